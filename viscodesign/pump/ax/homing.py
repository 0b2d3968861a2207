"""Finding the ends of travel against limit switches, slowly and with little torque."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection

from viscodesign.errors import InterruptedRunError, PumpError
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.ticks import Ticks

SEARCH_SPEED = 20.0  # [counts/s]: 1.5 mm/s.
SEARCH_RATE = 20.0  # of the ticks [Hz]
BACK_OFF = 10  # travel ends this far before the place where a switch lets go [counts]
LARGEST_ERROR = 30  # A plunger this far behind its goal is blocked [counts]
SIGN = {"low": -1, "high": 1}
Arrived = Callable[[Collection[str], int], bool]
"""Whether the way is over, by the pressed switches and the position [counts]."""


def find_travel(pump: Pump, stopped: Callable[[], bool]) -> tuple[int, int]:
    """Both ends of travel of a connected pump's plunger [counts]; it is left at the low one.

    ``stopped``: whether somebody asked to stop. Whatever happens, the plunger is held.
    """
    try:
        pump.arm()
        high = _find(pump, "high", stopped)
        low = _find(pump, "low", stopped)
    finally:
        pump.hold()
    if high - low < 4 * BACK_OFF:
        raise PumpError(
            f"the switches are at {low} and {high} counts: too close together; check their wiring"
        )
    return low, high


def _find(pump: Pump, end: str, stopped: Callable[[], bool]) -> int:
    """Go towards an end until its switch is pressed, then back until it lets go, and farther."""
    sign, other = SIGN[end], "high" if end == "low" else "low"
    _go(pump, sign, lambda pressed, _: end in pressed, other, stopped)
    _go(pump, -sign, lambda pressed, _: end not in pressed, other, stopped)
    place = pump.positions[pump.axes[0]] - sign * BACK_OFF
    _go(pump, -sign, lambda _, position: (place - position) * sign >= 0, other, stopped)
    return place


def _go(pump: Pump, sign: int, arrived: Arrived, barred: str, stopped: Callable[[], bool]) -> None:
    """Step by step in one direction; never on when something is wrong."""
    servo = pump.axes[0]
    pump.reach = step = math.ceil(SEARCH_SPEED / SEARCH_RATE)
    ticks = Ticks(pump.clock, 1.0 / SEARCH_RATE)
    ticks.begin()
    while True:
        states, _, switches = pump.look()
        pressed, position = switches.get(servo, frozenset()), states[servo].position
        if stopped():
            raise InterruptedRunError("stopped by the user; the plunger is held")
        if states[servo].alarm:
            raise PumpError(f"servo {servo} {states[servo].alarm}")
        if barred in pressed:
            raise PumpError(
                f"the switch at the {barred} end is pressed on the way to the other one: check its "
                "wiring, and that pump.limit_switches does not swap the pins"
            )
        if arrived(pressed, position):
            return
        goal = pump.goals[servo] + sign * step
        if not pump.limits.travel[0] <= goal <= pump.limits.travel[1]:
            raise PumpError("the servo reached the end of its range without a switch being pressed")
        if abs(goal - position) > LARGEST_ERROR:
            raise PumpError(
                f"the plunger is stuck at {position} counts with no switch pressed: it is "
                "blocked, or the switch does not work"
            )
        pump.set_goals({servo: goal}, {servo: SEARCH_SPEED})
        ticks.wait(lambda: not stopped())
