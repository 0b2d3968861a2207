"""What an axis is to those who move it: its state, its limits, and how it was left.

An axis sets what drives one inlet: a plunger by its place, or a regulator by its pressure. Its
targets are whole steps, so that what was sent and what is held compare exactly; `AxisLimits.step`
says what one is, in SI. Every number about steps is the family's own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.clock import Clock

RETRY_PAUSE = 0.02  # between tries of a hold [s]
HOLD_TIMEOUT = 1.0  # to try for a verified one [s]


@dataclass(frozen=True)
class AxisState:
    """One axis as it was read."""

    driven: bool
    """Whether it is driven."""
    goal: int
    """Target that it holds [steps]."""
    position: int
    """[steps]"""
    load: float | None
    """Share of its full output, signed as the steps are; None where nothing measures it."""
    voltage: float | None
    """Voltage of its supply [V]; None where nothing measures it."""
    temperature: float | None
    """[degC]; None where nothing measures it."""

    @property
    def alarm(self) -> str:
        """The fault that it reports, in words; empty where there is none."""
        return ""


@dataclass(frozen=True)
class FoundAxis:
    """One axis as it was found, before anything moves."""

    id: int
    cells: Mapping[str, str]
    """What a table of axes says of it, by heading."""
    document: Mapping[str, Any]
    """The same for a program, under names with units."""
    faults: Sequence[str] = ()
    """Why it must not be moved, each with what to do."""


@dataclass(frozen=True)
class AxisLimits:
    """What all axes of a pump can do, and may."""

    step: float
    """Size of a step, in SI: [m] of a plunger, [Pa] of a regulator."""
    noun: str
    """What an axis is called in messages: 'servo'."""
    unit: str
    """What several steps are called in messages: 'counts'."""
    travel: tuple[int, int]
    """Lowest and highest target [steps]."""
    home: int
    """Where no pressure is made [steps]."""
    retreat_sign: int
    """Direction in which pressure is relieved: 1 towards higher steps, -1 towards lower."""
    max_pressure: float
    """Gauge [Pa]."""
    top_speed: float
    """Without load [steps/s]."""
    slowest_speed: float
    """[steps/s]"""
    lead_distance: float
    """By which the target has to be ahead at top speed [steps]."""
    largest_lead: float
    """By which it may be ahead to make up for a load [steps]."""
    approach_speed: float
    """On the way to a start or back [steps/s]."""
    settle_speed: float
    """At the end of a path [steps/s]."""
    following_error: float
    """Beyond this and one tick's travel an axis does not follow its target [steps]."""
    weakness: str
    """Why one may not follow, in words: 'the plunger is blocked'."""
    dead_band: float
    """Following error that is none [steps]."""
    settled_error: float
    """The same at the end of a path [steps]."""
    travel_tolerance: int
    """A position this far outside of travel is not yet one that slipped [steps]."""
    lowest_voltage: float
    """Supply voltage below which the pump stops [V]."""
    highest_temperature: float
    """At which the pump stops [degC]."""


@dataclass(frozen=True)
class FinalAxisState:
    """How one axis was left."""

    axis: int
    verified: bool
    """Whether it was read back."""
    words: str
    noun: str = "axis"

    def __str__(self) -> str:
        return f"{self.noun} {self.axis}: {self.words}"

    def document(self) -> dict[str, Any]:
        """It for a program."""
        return {"id": self.axis, "verified": self.verified, "state": self.words}


def until_verified(
    axes: Sequence[int], clock: Clock, noun: str, attempt: Callable[[int], str]
) -> list[FinalAxisState]:
    """Try each axis in turns until it is verified or the time is over; at least once.

    ``attempt`` says how an axis was left; it raises `PumpError` where that was not read back.
    """
    deadline = clock.now() + HOLD_TIMEOUT
    left: dict[int, FinalAxisState] = {}
    waiting = list(axes)
    while waiting:
        for axis in waiting:
            try:
                left[axis] = FinalAxisState(axis, True, attempt(axis), noun)
            except PumpError as error:
                left[axis] = FinalAxisState(axis, False, str(error), noun)
        waiting = [axis for axis in waiting if not left[axis].verified]
        if clock.now() >= deadline:
            break
        if waiting:
            clock.sleep(RETRY_PAUSE)
    return [left[axis] for axis in axes]


@dataclass(frozen=True)
class Sample:
    """What one tick read, and the targets that follow; S axes, in the order of their inlets."""

    time: float
    """Time on the clock [s]."""
    axes: Mapping[int, AxisState]
    pressure: tuple[float | None, ...]
    """(S,) measured gauge pressure [Pa]; None where nothing measures it."""
    wanted: tuple[float | None, ...]
    """(S,) gauge pressure that the model expects now [Pa]."""
    pressed: Mapping[int, frozenset[str]]
    """Limit switches that are pressed (or broken), 'low' or 'high', of each axis that has some."""
    goals: Mapping[int, int]
    """Targets in force [steps]."""
    next_goals: Mapping[int, int]
    """Targets that follow [steps]."""
    lag: float = 0.0
    """How far behind the plan the stream is [ticks]."""
    noun: str = "axis"
    """What an axis is called in messages."""

    def inlet_words(self, inlet: int) -> str:
        """Which of several inlets it is, by its axis; empty where there is one."""
        several = len(self.axes) > 1
        return f" at the inlet of {self.noun} {list(self.axes)[inlet]}" if several else ""
