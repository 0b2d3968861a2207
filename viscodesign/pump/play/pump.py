"""The contract of a pump: axes that move only a little at a time, and can always be held.

Streams and safety rules know no more than this; targets that an alarm, the travel or the
reach of a tick forbids are refused here, for every family alike.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, field
from typing import Any, ClassVar

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import AxisLimits, AxisState, FinalAxisState, FoundAxis
from viscodesign.pump.play.guard import Stop
from viscodesign.pump.sensors.pressure_readings import PressureReadings

Pressed = dict[int, frozenset[str]]  # ends whose switch is pressed, by axis

Steps = Mapping[int, int]  # targets by axis [steps]
Speeds = Mapping[int, float]  # by axis [steps/s]


@dataclass(eq=False)
class Pump(ABC):
    """Axes that move together; all that moves them goes through here.

    In order: `arm`, `look` and `set_goals` in turns, `hold` or `release`. After an alarm targets
    are refused until a new command begins.
    """

    reading_share: ClassVar[float] = 0.8
    """Share of a tick that reading may take; the rest is left for sending and recording."""

    board: Any  # a controller
    settings: Any  # the section of its kind in a spec; None without a spec
    axes: Sequence[int]
    gauges: PressureReadings
    clock: Clock
    _: KW_ONLY
    switches: bool = True
    """Whether its limit switches are read, where it has some."""
    identity: str = field(default="", init=False)  # what the board said of itself
    armed: bool = field(default=False, init=False)
    alarm: Stop | None = field(default=None, init=False)
    goals: dict[int, int] = field(default_factory=dict, init=False)  # targets in force [steps]
    positions: dict[int, int] = field(default_factory=dict, init=False)  # last read [steps]
    read_at: float = field(default=-math.inf, init=False)
    """When, about: between question and answer [s of the clock]."""
    reach: int = field(default=1, init=False)
    """Farthest that a target may lie from the one before [steps]: one tick's travel."""

    @property
    @abstractmethod
    def limits(self) -> AxisLimits:
        """What its axes can do, and may; only with a spec."""

    @abstractmethod
    def inspect(self) -> tuple[str, list[FoundAxis]]:
        """What the board says of itself, and all axes as they are; changes nothing."""

    def connect(self) -> list[FoundAxis]:
        """Identify the board and all axes; raises `PumpError` where they must not move."""
        self.identity, found = self.inspect()
        faults = [fault for axis in found for fault in axis.faults]
        if faults:
            raise PumpError("\n".join(["nothing has moved:", *faults]))
        return found

    @abstractmethod
    def arm(self, speed: float = 0.0) -> None:
        """Power each axis where it stands.

        ``speed``: the fastest that will be asked for [steps/s]; raises `PumpError` where an axis
        is not that fast.
        """

    @abstractmethod
    def _read(self) -> Mapping[int, AxisState]:
        """The state of each axis now; brings `positions` and `read_at` up to date."""

    @abstractmethod
    def _send(self, goals: Steps, speeds: Speeds, paces: Speeds | None) -> None:
        """Send checked targets; arguments as for `set_goals`."""

    @abstractmethod
    def hold(self, *, in_place: bool = True) -> list[FinalAxisState]:
        """Hold each axis where it is, read back; nothing is sent where it was never powered.

        Unless ``in_place``, the targets in force are kept: those that a load asks for.
        """

    @abstractmethod
    def release(self) -> list[FinalAxisState]:
        """Power off, read back; pressure may push a plunger back then."""

    def look(self) -> tuple[Mapping[int, AxisState], tuple[float | None, ...], Pressed]:
        """Axes, pressures [Pa gauge] and pressed switches, read now."""
        states = self._read()
        return states, self.gauges.read(), self.pressed()

    def pressed(self) -> Pressed:
        """Limit switches that are pressed."""
        return {}

    def set_goals(self, goals: Steps, speeds: Speeds, paces: Speeds | None = None) -> None:
        """Send the next targets [steps], one transaction for all where the family can.

        ``speeds``: of each axis [steps/s]. ``paces``: what the plan asks of each about now
        [steps/s]; its force is limited to that and the pressure cap.
        """
        self._refuse(goals)
        self._send(goals, speeds, paces)
        self.goals |= goals

    def allowed(self, goals: Steps) -> dict[int, int]:
        """The same targets within travel; after an alarm, what would not draw back stays.

        So one plunger that is drawn out beyond home keeps no other from being drawn back to it.
        """
        low, high = self.limits.travel
        if self.alarm is None:
            return {s: min(max(goal, low), high) for s, goal in goals.items()}
        kept = self.goals
        return {s: g if self._draws_back(g - kept[s]) else kept[s] for s, g in goals.items()}

    def _refuse(self, goals: Steps) -> None:
        low, high = self.limits.travel
        if not self.armed:
            raise PumpError("the pump is not armed; nothing is sent")
        for axis, goal in goals.items():
            step, who = goal - self.goals[axis], f"{self.limits.noun} {axis}"
            if self.alarm is not None and not self._draws_back(step):
                raise PumpError(f"locked by an alarm ({self.alarm}); start a new command")
            if not low <= goal <= high:
                raise PumpError(f"{who}: goal {goal} is outside its travel [{low}, {high}]")
            if abs(step) > self.reach:
                raise PumpError(
                    f"{who}: goal {goal} is {abs(step)} {self.limits.unit} from the "
                    f"last one; one tick's travel is {self.reach}"
                )

    def _draws_back(self, step: int) -> bool:
        """Whether an alarm lets this step pass: none, or one that relieves pressure."""
        if self.alarm is None or not self.alarm.may_retreat:
            return step == 0
        return step * self.limits.retreat_sign >= 0
