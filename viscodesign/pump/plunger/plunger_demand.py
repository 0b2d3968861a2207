"""What a pressure profile asks of one plunger: where it is, how fast, against what force."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.drive import PlungerDrive
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.limits import MARGINS
from viscodesign.pump.planning.result import Panel
from viscodesign.pump.plunger.barrel import Barrel
from viscodesign.pump.plunger.plunger_limits import PLUNGER_LIMITS, PLUNGER_STEPWISE
from viscodesign.pump.plunger.plunger_numbers import (
    gas_notices,
    plunger_faults,
    plunger_numbers,
    plunger_words,
)
from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

REST_STEPS_PER_S = 0.05
"""Speed below which a plunger counts as at rest: round-off and drift."""
DIRECTION_SAMPLES = 5
"""Samples on both sides over which the direction of motion is found: more than a step."""


@dataclass(frozen=True)
class PlungerDemand(PumpDemand):
    """One inlet's plunger over T times; arrays (T,) or, between the times, (T - 1,).

    A kind adds its `axis`, its `device` and `drive_of`; where its drive is limited by more than
    stall and speed, it extends `limits`, and what is written of it.
    """

    limits = PLUNGER_LIMITS
    stepwise = PLUNGER_STEPWISE
    stall_marks: ClassVar[tuple[tuple[str, float], ...]] = (("stall", 100.0),)
    """Levels in the picture of the load [% of stall], with their names."""

    @classmethod
    @abstractmethod
    def drive_of(cls, pump: Any) -> PlungerDrive:
        """The drive of a pump's section."""

    @cached_property
    def drive(self) -> PlungerDrive:
        """The plunger in its barrel, and what moves it."""
        return self.drive_of(self.pump)

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        yield from plunger_faults(scene, cls.drive_of(scene.pump))

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
        """Compliance of the barrel where it is emptiest, fullest or pressed hardest [m3/Pa]."""
        places = (np.argmax(self.position), np.argmin(self.position), np.argmax(self.pressure))
        kept = self.barrel.within(self.position)  # a plunger beyond its barrel compresses nothing
        pairs = [(float(self.pressure[k]), float(kept[k])) for k in places]
        return min(self.barrel.compliance(*pair) for pair in pairs)

    @cached_property
    def velocity(self) -> np.ndarray:
        """Speed of the plunger between the times [m/s]."""
        return np.asarray(np.diff(self.position) / np.diff(self.time))

    @cached_property
    def direction(self) -> np.ndarray:
        """1 where the plunger moves in, -1 out, 0 at rest; between the times."""
        rest = REST_STEPS_PER_S * self.drive.step
        return np.where(np.abs(self.velocity) > rest, np.sign(self.velocity), 0.0)

    @cached_property
    def end_forces(self) -> np.ndarray:
        """Forces of the drive at both ends of each interval (2, T - 1) [N]."""
        ends = np.stack((self.pressure[:-1], self.pressure[1:]))
        return np.asarray(self.drive.force(ends, self.direction))

    def load_of(self, force: Any) -> Any:
        """A force as the drive's load, in its own unit."""
        return force * self.drive.load.per_newton

    @property
    def worst_load(self) -> tuple[float, int]:
        """The largest load in size, moving or holding, and the index of its time."""
        size = np.abs(self.load_of(self.end_forces))
        when = int(np.argmax(np.max(size, axis=0)))
        end = int(np.argmax(size[:, when]))
        return float(size[end, when]), when + end

    @cached_property
    def speed_left(self) -> np.ndarray:
        """Plunger speed that the drive has left in each interval [m/s]."""
        hardest = np.max(self.end_forces * self.direction, axis=0)
        return np.asarray(self.drive.speed_left(hardest))

    @cached_property
    def speed_share(self) -> np.ndarray:
        """Share of it that is required; infinite where none is left."""
        speed = np.abs(self.velocity) * (self.direction != 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(speed > 0.0, speed / self.speed_left, 0.0)

    @cached_property
    def force(self) -> np.ndarray:
        """Force at the times [N]; friction by the motion around them, which whole steps hide."""
        near = np.minimum(DIRECTION_SAMPLES, len(self.time) - 1)
        later = np.append(self.position[near:], np.full(near, self.position[-1]))
        before = np.append(np.full(near, self.position[0]), self.position[: len(later) - near])
        moved = (later - before) / self.drive.step
        direction = np.where(np.abs(moved) > 1.0, np.sign(moved), 0.0)
        return np.asarray(self.drive.force(self.pressure, direction))

    @property
    def load(self) -> np.ndarray:
        """The same as the drive's load (T,), in its own unit."""
        return np.asarray(self.load_of(self.force))

    @property
    def bounds(self) -> tuple[float, float]:
        ambient, stall = self.scene.ambient_pressure, self.drive.stall_pressure
        floor = max(MARGINS.sensor_floor, self.scene.fluid.vapour_pressure or 0.0) - ambient
        return max(floor, -stall), min(self.pump.max_pressure, stall)

    def _reach(self, pressure: np.ndarray) -> dict[float, np.ndarray]:
        """As far as the drive's speed at the harder of each interval's pressures."""
        drive, steps = self.drive, np.diff(self.time)
        speeds = {s: drive.speed_left(s * drive.force(pressure, s)) for s in (1.0, -1.0)}
        return {sign: np.minimum(v[:-1], v[1:]) * steps for sign, v in speeds.items()}

    def approach_time(self, speed_share: float) -> float:
        force = self.drive.force(np.abs(self.pressure), 1.0)
        left = float(self.drive.speed_left(force)[0])
        return abs(float(self.position[0])) / (speed_share * left) if left > 0.0 else 0.0

    def source(self, time: np.ndarray, path: np.ndarray) -> Input:
        # Equal actuators take up even parts of what one plunger pushes out.
        return self.barrel.syringe(time, path).shared_by(self.pump.feeds)

    def input_value(self, position: float) -> float:
        return float(self.drive.area * position / self.pump.feeds)

    def possible(self, position: float) -> float:
        return float(self.barrel.within(np.asarray(position)))

    def columns(self) -> dict[str, np.ndarray]:
        drive, volume = self.drive, self.drive.area * self.position
        return {
            "pressure_pa": self.pressure,
            "given_m3": self.given,
            "volume_m3": volume,  # swept from home
            "flow_m3_s": self.flow(volume),
            "plunger_m": self.position,
            drive.step_name: self.steps,
            f"{drive.load.name}_{drive.load.suffix}": self.load,
            "stall_share": np.abs(self.load) / drive.stall_load,
            "speed_share": np.append(self.speed_share, 0.0),
        }

    def numbers(self) -> dict[str, float]:
        return plunger_numbers(self)

    def words(self) -> dict[str, str]:
        return plunger_words(self)

    @classmethod
    def limit_numbers(cls, demands: Sequence[Any]) -> dict[str, float]:
        drive, pump, unit = demands[0].drive, demands[0].pump, demands[0].axis.unit
        return {
            f"stall_{drive.load.suffix}": drive.stall_load,
            f"travel_low_{unit}": float(pump.travel[0]),
            f"travel_high_{unit}": float(pump.travel[1]),
            "cap_pa_gauge": pump.max_pressure,
        }

    @classmethod
    def notices(cls, demands: Sequence[PlungerDemand]) -> Iterator[Notice]:
        return gas_notices(demands)

    @classmethod
    def panels(cls, demands: Sequence[PlungerDemand]) -> tuple[Panel, ...]:
        pressure, steps, flows = super().panels(demands)
        axis, load = demands[0].axis, demands[0].drive.load
        low, high = demands[0].pump.travel
        margin, ends = 0.25 * (high - low), (("travel", float(low)), ("travel", float(high)))
        most = 1.2e6 * max(d.numbers()["no_load_flow_m3_s"] for d in demands)
        share = f"{load.name} [% of\nits stall]"
        return (
            pressure,
            steps._replace(
                label=f"{axis.noun}\n[{axis.unit}]",
                column=demands[0].drive.step_name,
                marks=ends,
                shows=np.inf,
                limits=(low - margin, high + margin),
            ),
            flows._replace(label="flow of the\nplunger [mL/s]", limits=(-most, most)),
            Panel(share, "stall_share", 100.0, cls.stall_marks, 0.5, (0.0, 160.0)),
        )
