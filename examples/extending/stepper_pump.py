"""`kind: stepper`: what a plan asks of a stepper motor that moves a plunger by a lead screw.

The plunger itself, its barrel, its limits and what cures them are the package's own. What moves
it is said here, in metres, newtons and seconds.
"""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
from stepper_section import StepperPumpSpec

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.drive import PlungerDrive
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.plunger.plunger_demand import PlungerDemand


@dataclass(frozen=True)
class StepperDrive(PlungerDrive):
    """Motor, screw and plunger. Its pull-out curve is taken as a straight line."""

    gear_key: ClassVar[str] = "lead"

    pump: StepperPumpSpec

    @property
    def step(self) -> float:
        return self.pump.lead / self.pump.steps_per_turn

    @property
    def stall_load(self) -> float:
        return self.pump.thrust

    def speed_left(self, force: Any) -> Any:
        # A load that helps makes it no faster: it keeps step.
        share = np.maximum(force, 0.0) / self.pump.thrust
        return self.pump.top_speed * np.maximum(1.0 - share, 0.0)


class StepperDemand(PlungerDemand):
    """What a plan asks of a stepper motor and its plunger."""

    name: ClassVar[str] = "stepper"

    @classmethod
    def drive_of(cls, pump: StepperPumpSpec) -> StepperDrive:
        return StepperDrive(pump)

    @property
    def device(self) -> str:
        return f"a stepper motor with {self.pump.steps_per_turn} steps per turn"

    @property
    def axis(self) -> AxisLimits:
        pump, step = self.pump, self.drive.step
        top = pump.top_speed / step
        return AxisLimits(
            step=step,
            noun="stepper",
            unit="steps",
            travel=pump.travel,
            home=pump.home,
            retreat_sign=-1 if pump.push == "up" else 1,
            max_pressure=pump.max_pressure,
            top_speed=top,
            slowest_speed=0.0,
            lead_distance=0.0,  # it keeps step with its target, or loses it
            largest_lead=0.0,
            approach_speed=0.1 * top,
            settle_speed=0.1 * top,
            following_error=4.0,  # of a motor that slips by a pole pair
            weakness="the plunger is blocked, or the motor lost steps",
            dead_band=1.0,
            settled_error=1.0,
            travel_tolerance=1,
            lowest_voltage=0.0,
            highest_temperature=float("inf"),
        )
