"""What a course of pressure asks of one pump: where its plunger is, how fast, against what."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from viscodesign.pump import syringe as syringe_pump
from viscodesign.pump.drive import Drive
from viscodesign.pump.planning.barrel import Barrel, Line
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.pump.servo_motor import SERVOS, Servo
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene

STANDS = 0.05
"""Speed below which a plunger counts as standing [counts/s]: of round-off and drift."""
AROUND = 5
"""Times to both sides of one at which its direction is told: by more than a count."""


@dataclass(frozen=True)
class Demand:
    """One inlet's pump over T times; arrays (T,) or, between the times, (T - 1,)."""

    scene: Scene
    pump: Pump
    inlet: str
    line: Line
    time: np.ndarray
    lead_s: float
    pressure: np.ndarray
    given: np.ndarray
    stated_position: np.ndarray | None = None
    """Where the motion is known; else it follows from pressure and what is given."""

    def with_pump(self, pump: Pump) -> Demand:
        """The same pressures asked of another pump."""
        return replace(self, pump=pump)

    @cached_property
    def drive(self) -> Drive:
        """Rack, pinion and barrel."""
        return Drive(self.pump)

    @cached_property
    def servo(self) -> Servo:
        """The servo's numbers."""
        return SERVOS[self.pump.servo]

    @cached_property
    def barrel(self) -> Barrel:
        """What is in front of the plunger."""
        return Barrel.of(self.scene, self.drive, self.line)

    @property
    def stall_torque(self) -> float:
        """At the battery's voltage [N m]."""
        return syringe_pump.stall_torque(self.servo, self.pump.supply_voltage)

    @property
    def stall_pressure(self) -> float:
        """At the battery's voltage, gauge [Pa]."""
        pump = self.pump
        return syringe_pump.stall_pressure(
            self.servo, pump.supply_voltage, pump.syringe_diameter, pump.pinion_diameter
        )

    @cached_property
    def position(self) -> np.ndarray:
        """Plunger pushed in from home [m]."""
        if self.stated_position is not None:
            return self.stated_position
        return np.asarray(self.barrel.position(self.pressure, self.given))

    @property
    def extremes(self) -> tuple[tuple[float, float], ...]:
        """Pressure and position where the barrel is emptiest, fullest and pressed hardest."""
        places = (np.argmax(self.position), np.argmin(self.position), np.argmax(self.pressure))
        return tuple((float(self.pressure[k]), float(self.position[k])) for k in places)

    @cached_property
    def count(self) -> np.ndarray:
        """Of the servo, not rounded."""
        home, way = self.drive.count(0.0), self.drive.count(1.0) - self.drive.count(0.0)
        return np.asarray(home + way * self.position)

    @cached_property
    def velocity(self) -> np.ndarray:
        """Of the plunger between the times [m/s]."""
        return np.asarray(np.diff(self.position) / np.diff(self.time))

    @cached_property
    def direction(self) -> np.ndarray:
        """1 where it moves in, -1 where out, 0 where it stands; between the times."""
        still = STANDS * self.drive.advance_per_count
        return np.where(np.abs(self.velocity) > still, np.sign(self.velocity), 0.0)

    def _torque(self, pressure: np.ndarray, direction: np.ndarray) -> np.ndarray:
        pump = self.pump
        friction = pump.plunger_friction * direction
        return np.asarray(
            syringe_pump.shaft_torque(
                pressure, pump.syringe_diameter, pump.pinion_diameter, friction
            )
        )

    @cached_property
    def end_torques(self) -> np.ndarray:
        """Torque at both ends of each interval (2, T - 1) [N m]."""
        ends = np.stack((self.pressure[:-1], self.pressure[1:]))
        return self._torque(ends, self.direction)

    @cached_property
    def speed_left(self) -> np.ndarray:
        """Speed of the plunger that the servo has left in each interval [m/s]."""
        against = np.max(self.end_torques * self.direction, axis=0)
        left = syringe_pump.speed_left(self.servo, self.pump.supply_voltage, against)
        return np.asarray(left * self.pump.pinion_diameter / 2)

    @cached_property
    def speed_share(self) -> np.ndarray:
        """Part of it that is asked; infinite where none is left."""
        speed = np.abs(self.velocity) * (self.direction != 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(speed > 0.0, speed / self.speed_left, 0.0)

    @cached_property
    def torque(self) -> np.ndarray:
        """At the times [N m]; friction by the motion around them, which steps of a count hide."""
        near = np.minimum(AROUND, len(self.time) - 1)
        later = np.append(self.position[near:], np.full(near, self.position[-1]))
        before = np.append(np.full(near, self.position[0]), self.position[: len(later) - near])
        way = (later - before) / self.drive.advance_per_count
        return self._torque(self.pressure, np.where(np.abs(way) > 1.0, np.sign(way), 0.0))


def course(demands: Sequence[Demand]) -> PumpCourse:
    """All inlets' demands as one course."""

    def columns(values: Sequence[np.ndarray]) -> np.ndarray:
        return np.stack(values, axis=1)

    first = demands[0]
    volume = columns([d.drive.area * d.position for d in demands])
    flow = np.diff(volume, axis=0) / np.diff(first.time)[:, None]
    return PumpCourse(
        time=first.time,
        lead_s=first.lead_s,
        pressure=columns([d.pressure for d in demands]),
        given=columns([d.given for d in demands]),
        position=columns([d.position for d in demands]),
        volume=volume,
        count=columns([d.count for d in demands]),
        flow=np.concatenate([flow, np.zeros((1, len(demands)))]),
        torque=columns([d.torque for d in demands]),
        stall_share=columns([np.abs(d.torque) / d.stall_torque for d in demands]),
        speed_share=columns([np.append(d.speed_share, 0.0) for d in demands]),
    )
