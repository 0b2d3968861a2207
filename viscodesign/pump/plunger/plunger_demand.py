"""What a pressure profile asks of one pump: where its plunger is, how fast, at what load."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.drive import Drive
from viscodesign.pump.planning.demand import PumpDemand, columns, flow
from viscodesign.pump.planning.limits import MARGINS
from viscodesign.pump.planning.result import Panel
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.plunger.barrel import Barrel
from viscodesign.pump.plunger.plunger_course import PlungerCourse
from viscodesign.pump.plunger.plunger_fixes import FIXES, STEPWISE
from viscodesign.pump.plunger.plunger_limits import LIMITS
from viscodesign.pump.plunger.plunger_numbers import (
    gas_notices,
    plunger_faults,
    plunger_numbers,
    plunger_words,
)
from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.pumps.servo_motor import STEADY_SHARE
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

REST_COUNTS_PER_S = 0.05
"""Speed below which a plunger counts as at rest: round-off and drift."""
DIRECTION_SAMPLES = 5
"""Samples on both sides over which the direction of motion is found: more than a count."""


@dataclass(frozen=True)
class PlungerDemand(PumpDemand):
    """One inlet's plunger over T times; arrays (T,) or, between the times, (T - 1,)."""

    limits = LIMITS
    fixes = FIXES
    stepwise = STEPWISE

    @cached_property
    def axis(self) -> AxisLimits:
        return axis_limits(self.pump)

    @property
    def device(self) -> str:
        return self.drive.servo.title

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        return plunger_faults(scene)

    @cached_property
    def drive(self) -> Drive:
        """Servo, pinion and barrel."""
        return Drive(self.pump)

    @cached_property
    def barrel(self) -> Barrel:
        """What is in front of the plunger."""
        return Barrel(self.scene, self.drive, self.line)

    @cached_property
    def position(self) -> np.ndarray:
        """Plunger pushed in from home [m]."""
        if self.stated_position is not None:
            return self.stated_position
        return np.asarray(self.barrel.position(self.pressure, self.given))

    @property
    def least_compliance(self) -> float:
        """Of the barrel where it is emptiest, fullest or pressed hardest [m3/Pa]."""
        places = (np.argmax(self.position), np.argmin(self.position), np.argmax(self.pressure))
        kept = self.barrel.within(self.position)  # a plunger beyond its barrel compresses nothing
        pairs = [(float(self.pressure[k]), float(kept[k])) for k in places]
        return min(self.barrel.compliance(*pair) for pair in pairs)

    @property
    def count(self) -> np.ndarray:
        """Of the servo (T,), not rounded."""
        return self.steps

    @cached_property
    def velocity(self) -> np.ndarray:
        """Of the plunger between the times [m/s]."""
        return np.asarray(np.diff(self.position) / np.diff(self.time))

    @cached_property
    def direction(self) -> np.ndarray:
        """1 where the plunger moves in, -1 out, 0 at rest; between the times."""
        rest = REST_COUNTS_PER_S * self.drive.advance_per_count
        return np.where(np.abs(self.velocity) > rest, np.sign(self.velocity), 0.0)

    @cached_property
    def end_torques(self) -> np.ndarray:
        """At both ends of each interval (2, T - 1) [N m]."""
        ends = np.stack((self.pressure[:-1], self.pressure[1:]))
        return np.asarray(self.drive.torque(ends, self.direction))

    @cached_property
    def speed_left(self) -> np.ndarray:
        """Plunger speed that the servo has left in each interval [m/s]."""
        hardest = np.max(self.end_torques * self.direction, axis=0)
        return np.asarray(self.drive.speed_left(hardest))

    @cached_property
    def speed_share(self) -> np.ndarray:
        """Share of it that is required; infinite where none is left."""
        speed = np.abs(self.velocity) * (self.direction != 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(speed > 0.0, speed / self.speed_left, 0.0)

    @cached_property
    def torque(self) -> np.ndarray:
        """At the times [N m]; friction by the motion around them, which steps of a count hide."""
        near = np.minimum(DIRECTION_SAMPLES, len(self.time) - 1)
        later = np.append(self.position[near:], np.full(near, self.position[-1]))
        before = np.append(np.full(near, self.position[0]), self.position[: len(later) - near])
        moved = (later - before) / self.drive.advance_per_count
        direction = np.where(np.abs(moved) > 1.0, np.sign(moved), 0.0)
        return np.asarray(self.drive.torque(self.pressure, direction))

    @property
    def mean_current(self) -> float:
        """Of the servo over the whole motion [A]."""
        current = self.drive.current(self.torque)
        return float(np.trapezoid(current, self.time)) / float(np.ptp(self.time))

    @property
    def bounds(self) -> tuple[float, float]:
        ambient, stall = self.scene.ambient_pressure, self.drive.stall_pressure
        floor = max(MARGINS.sensor_floor, self.scene.fluid.vapour_pressure or 0.0) - ambient
        return max(floor, -stall), min(self.pump.max_pressure, stall)

    def _reach(self, pressure: np.ndarray) -> dict[float, np.ndarray]:
        """As far as the servo's speed at the harder of each interval's pressures."""
        drive, steps = self.drive, np.diff(self.time)
        speeds = {s: drive.speed_left(s * drive.torque(pressure, s)) for s in (1.0, -1.0)}
        return {sign: np.minimum(v[:-1], v[1:]) * steps for sign, v in speeds.items()}

    def approach_time(self, speed_share: float) -> float:
        torque = self.drive.torque(np.abs(self.pressure), 1.0)
        left = float(self.drive.speed_left(torque)[0])
        return abs(float(self.position[0])) / (speed_share * left) if left > 0.0 else 0.0

    def source(self, time: np.ndarray, path: np.ndarray) -> Input:
        # Equal actuators take up even parts of what one plunger pushes out.
        return self.barrel.syringe(time, path).shared_by(self.pump.feeds)

    def input_value(self, position: float) -> float:
        return float(self.drive.area * position / self.pump.feeds)

    def possible(self, position: float) -> float:
        return float(self.barrel.within(np.asarray(position)))

    @classmethod
    def course(cls, demands: Sequence[PlungerDemand]) -> PlungerCourse:
        shared = cls._shared_columns(demands)
        volume = columns(demands, lambda d: d.drive.area * d.position)
        return PlungerCourse(
            **{**shared, "flow": flow(volume, shared["time"])},
            volume=volume,
            torque=columns(demands, lambda d: d.torque),
            stall_share=columns(demands, lambda d: np.abs(d.torque) / d.drive.stall_torque),
            speed_share=columns(demands, lambda d: np.append(d.speed_share, 0.0)),
        )

    def numbers(self) -> dict[str, float]:
        return plunger_numbers(self)

    def words(self) -> list[tuple[str, str]]:
        return plunger_words(self)

    @classmethod
    def limit_numbers(cls, demands: Sequence[PlungerDemand]) -> dict[str, float]:
        drive, pump = demands[0].drive, demands[0].pump
        return {
            "fifth_nm": STEADY_SHARE * drive.stall_torque,
            "stall_nm": drive.stall_torque,
            "travel_low_counts": float(pump.travel[0]),
            "travel_high_counts": float(pump.travel[1]),
            "cap_pa_gauge": pump.max_pressure,
            "battery_life_s": drive.battery_life(sum(d.mean_current for d in demands)),
        }

    @classmethod
    def notices(cls, demands: Sequence[PlungerDemand]) -> Iterator[Notice]:
        return gas_notices(demands)

    @classmethod
    def panels(cls, demands: Sequence[PlungerDemand]) -> tuple[Panel, ...]:
        pressure, counts, flows = super().panels(demands)
        low, high = demands[0].pump.travel
        margin, ends = 0.25 * (high - low), (("travel", float(low)), ("travel", float(high)))
        most = 1.2e6 * max(d.numbers()["no_load_flow_m3_s"] for d in demands)
        torques = (("a fifth: advice", 20.0), ("stall", 100.0))
        return (
            pressure,
            counts._replace(
                label="servo\n[counts]",
                marks=ends,
                shows=np.inf,
                limits=(low - margin, high + margin),
            ),
            flows._replace(label="flow of the\nplunger [mL/s]", limits=(-most, most)),
            Panel("torque [% of\nits stall]", "stall_share", 100.0, torques, 0.5, (0.0, 160.0)),
        )
