"""What a plan asks of an AX servo and its plunger."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_limits import LIMITS
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.plunger.plunger_demand import PlungerDemand
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import STEADY_SHARE
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class AxDemand(PlungerDemand):
    """One inlet's plunger and servo over T times; a step is a count."""

    limits = LIMITS
    stall_marks = (("a fifth: advice", 20.0), *PlungerDemand.stall_marks)

    pump: ServoPumpSpec

    @classmethod
    def drive_of(cls, pump: ServoPumpSpec) -> ServoDrive:
        return ServoDrive(pump)

    @cached_property
    def drive(self) -> ServoDrive:
        return self.drive_of(self.pump)

    @cached_property
    def axis(self) -> AxisLimits:
        return axis_limits(self.pump)

    @property
    def device(self) -> str:
        return self.drive.servo.title

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        pump, inlets = scene.pump, list(scene.inputs)
        assert isinstance(pump, ServoPumpSpec), "a servo's section"
        if isinstance(pump.servo_id, int) and len(inlets) > 1:
            ids = ", ".join(f"{name}: {k}" for k, name in enumerate(inlets, start=1))
            yield (
                "pump.servo_id",
                f"{pump.servo_id} is one servo for {len(inlets)} inlets; give each its own, like "
                f"{{{ids}}}",
            )
        yield from super().faults(scene)

    @property
    def mean_current(self) -> float:
        """Current of the servo, averaged over the whole motion [A]."""
        current = self.drive.current(self.load)
        return float(np.trapezoid(current, self.time)) / float(np.ptp(self.time))

    def numbers(self) -> dict[str, float]:
        n, drive = super().numbers(), self.drive
        return {
            **n,
            "steady_pressure_pa_gauge": STEADY_SHARE * drive.stall_pressure,
            "largest_current_a": float(drive.current(n["largest_torque_nm"])),
            "mean_current_a": self.mean_current,
            "fastest_speed_register": float(
                drive.speed_register(float(np.max(np.abs(self.velocity))))
            ),
        }

    def words(self) -> dict[str, str]:
        words, n = super().words(), self.numbers()
        words["stall"] += f"; a fifth of it is {n['steady_pressure_pa_gauge'] / 1e3:.3g} kPa"
        words["needs"] += f", {n['largest_current_a']:.3g} A"
        return words

    @classmethod
    def limit_numbers(cls, demands: Sequence[Any]) -> dict[str, float]:
        drive = demands[0].drive
        return {
            "fifth_nm": STEADY_SHARE * drive.stall_load,
            **super().limit_numbers(demands),
            "battery_life_s": drive.battery_life(sum(d.mean_current for d in demands)),
        }
