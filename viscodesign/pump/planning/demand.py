"""What a pressure profile asks of one pump: where its plunger is, how fast, at what load."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.drive import Drive
from viscodesign.pump.planning.barrel import Barrel, FeedLine
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

REST_COUNTS_PER_S = 0.05
"""Speed below which a plunger counts as at rest: round-off and drift."""
DIRECTION_SAMPLES = 5
"""Samples on both sides over which the direction of motion is found: more than a count."""


@dataclass(frozen=True)
class PumpDemand:
    """One inlet's pump over T times; arrays (T,) or, between the times, (T - 1,)."""

    scene: Scene
    pump: PumpSpec
    inlet: str
    line: FeedLine
    time: np.ndarray  # from the start of the lead-in [s]
    lead_s: float
    pressure: np.ndarray  # gauge [Pa]
    given: np.ndarray  # to the network since it was filled [m3 at ambient density]
    stated_position: np.ndarray | None = None  # [m]; None: follows from pressure and given

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

    @cached_property
    def count(self) -> np.ndarray:
        """Of the servo, not rounded."""
        home, per_metre = self.drive.count(0.0), self.drive.count(1.0) - self.drive.count(0.0)
        return np.asarray(home + per_metre * self.position)

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


def course_of(demands: Sequence[PumpDemand]) -> PumpCourse:
    """All inlets' demands as one course."""

    def columns(value: Callable[[PumpDemand], np.ndarray]) -> np.ndarray:
        return np.stack([value(d) for d in demands], axis=1)

    first = demands[0]
    volume = columns(lambda d: d.drive.area * d.position)
    flow = np.diff(volume, axis=0) / np.diff(first.time)[:, None]
    return PumpCourse(
        time=first.time,
        lead_s=first.lead_s,
        pressure=columns(lambda d: d.pressure),
        given=columns(lambda d: d.given),
        position=columns(lambda d: d.position),
        volume=volume,
        count=columns(lambda d: d.count),
        flow=np.concatenate([flow, np.zeros((1, len(demands)))]),
        torque=columns(lambda d: d.torque),
        stall_share=columns(lambda d: np.abs(d.torque) / d.drive.stall_torque),
        speed_share=columns(lambda d: np.append(d.speed_share, 0.0)),
    )
