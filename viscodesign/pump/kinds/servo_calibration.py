"""Home and the ends of travel: found with limit switches or by hand, and kept in the servo."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection

from viscodesign.errors import InterruptedRunError, PumpError, UsageError
from viscodesign.interrupt import stop_on_signals
from viscodesign.pump.ax.hold import release
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.servo_state import EepromChange, changes, id_change, identify, read_servo
from viscodesign.pump.consent import Confirm, ShowPosition, require
from viscodesign.pump.kinds.base import Calibration, CalibrationRequest
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.scene.pumps.servo import MAX_SERVO_COUNTS, ServoPumpSpec
from viscodesign.scene.spec_part import copied

HIGHEST_ID = 252
"""253 is the ArbotiX itself."""
SEARCH_SPEED = 20.0  # [counts/s]: 1.5 mm/s.
SEARCH_RATE = 20.0  # of the ticks [Hz]
BACK_OFF = 10  # travel ends this far before the place where a switch lets go [counts]
LARGEST_ERROR = 30  # A plunger this far behind its goal is blocked [counts]


def calibrate(link: Connection, request: CalibrationRequest) -> Calibration:
    """Find home and travel, and set the servo's own angle limits to the travel.

    With the scene's limit switches, slowly and at low torque; without them by hand, with the
    torque off. Writes only what differs, each after the user agreed.
    """
    pump, confirm = link.pump, request.confirm
    if request.rename is not None:
        _rename(link, *request.rename, confirm)
    request.tell(f"found {link.board.identify()}")
    if request.keep:
        found = Calibration(pump.home, pump.travel)
    elif len(link.axes) > 1:
        raise UsageError(
            "all servos of a spec share home and travel; calibrate each with a spec that has "
            "its servo_id alone, then this one with --keep (keep=True in Python)"
        )
    elif pump.limit_switches is None:
        found = _by_hand(link, pump, request.by_hand, request.vented or confirm)
    else:
        found = _against_switches(link, pump, confirm)
    for servo in link.axes:
        different = changes(identify(link.board, servo), found.travel)
        for change in different:
            _write(link, change, confirm)
        if not different:
            request.tell(f"servo {servo} is up to date; nothing is written")
    return found


def calibration_steps(pump: ServoPumpSpec, request: CalibrationRequest) -> list[str]:
    """What `calibrate` would do."""
    how = "switch the torque off, and ask you to move the plunger by hand"
    if pump.limit_switches is not None:
        how = "move the plunger slowly against both limit switches"
    old, new = request.rename or ("", "")
    return [
        *([f"change a servo's id from {old} to {new}"] if request.rename else []),
        "take home and travel from the spec" if request.keep else how,
        "write angle limits to the EEPROM where they differ, asking before each",
    ]


def _rename(link: Connection, old: int, new: int, confirm: Confirm) -> None:
    if not 0 <= new <= HIGHEST_ID:
        raise UsageError(f"rename: ids go from 0 to {HIGHEST_ID}; got {new}")
    if link.board.answers(new):
        raise PumpError(f"a servo with id {new} exists already; two would answer at once")
    _write(link, id_change(old, new), confirm)


def _write(link: Connection, change: EepromChange, confirm: Confirm) -> None:
    require(confirm, f"EEPROM of {change}\nWrite it?")
    change.write(link.board)


def _against_switches(link: Connection, pump: ServoPumpSpec, confirm: Confirm) -> Calibration:
    require(
        confirm,
        "the plunger moves slowly to both ends, until their switches are pressed; vent it "
        "first\nMove the plunger?",
    )
    free = copied(pump, {"travel": (0, MAX_SERVO_COUNTS)})
    no_sensor = PressureReadings([None], link.ambient)
    moved = ServoPump(link.board, free, link.axes, no_sensor, link.clock)
    with stop_on_signals() as request:
        low, high = find_travel(moved, lambda: request.asked)
    return Calibration(low if pump.push == "up" else high, (low, high))


def _by_hand(
    link: Connection, pump: ServoPumpSpec, by_hand: ShowPosition | None, vented: Confirm
) -> Calibration:
    if by_hand is None:
        raise UsageError(
            "the plunger has to be moved by hand: pass `by_hand`, or keep the home and travel of "
            "the spec"
        )
    require(
        vented,
        "the torque goes off; pressure in the syringe would push the plunger: vent it first\n"
        "Is it vented?",
    )
    (servo,) = link.axes
    (left,) = release(link.board, [servo], link.clock)
    if not left.verified:
        raise PumpError(str(left))
    outer, inner, home = (
        by_hand(
            f"servo {servo}: move the plunger {place}, then press Enter",
            lambda: read_servo(link.board, servo).position,
        )
        for place in ("out as far as it may go", "in as far as it may go", "to its home")
    )
    low, high = sorted((outer, inner))
    if (inner > outer) != (pump.push == "up"):
        raise PumpError(
            f"counts went from {outer} to {inner} as the plunger was pushed in, but the spec says "
            f"pump.push: {pump.push}; correct it and calibrate again"
        )
    if not low <= home <= high or low == high:
        raise PumpError(f"home {home} is not between the ends, {low} and {high}; try again")
    return Calibration(home, (low, high))


def find_travel(pump: Pump, stopped: Callable[[], bool]) -> tuple[int, int]:
    """Both ends of travel of a connected pump's plunger [counts]; it is left at the low one.

    Against limit switches, slowly. ``stopped``: whether somebody asked to stop. Whatever happens,
    the plunger is held.
    """
    search = _EndSearch(pump, stopped)
    try:
        pump.arm()
        high = search.end("high", 1)
        low = search.end("low", -1)
    finally:
        pump.hold()
    if high - low < 4 * BACK_OFF:
        raise PumpError(
            f"the switches are at {low} and {high} counts: too close together; check their wiring"
        )
    return low, high


class _EndSearch:
    """The plunger on its way to a switch, step by step; never on when something is wrong."""

    def __init__(self, pump: Pump, stopped: Callable[[], bool]) -> None:
        self.pump, self.stopped = pump, stopped
        (self.servo,) = pump.axes
        pump.reach = math.ceil(SEARCH_SPEED / SEARCH_RATE)

    def end(self, end: str, sign: int) -> int:
        """Go towards an end until its switch is pressed, then back until it lets go, and farther.

        ``sign``: the direction of the counts towards it. Where travel ends on this side [counts].
        """
        barred = {"low": "high", "high": "low"}[end]
        self._go(sign, barred, lambda pressed, _: end in pressed)
        self._go(-sign, barred, lambda pressed, _: end not in pressed)
        place = self.pump.positions[self.servo] - sign * BACK_OFF
        self._go(-sign, barred, lambda _, position: (place - position) * sign >= 0)
        return place

    def _go(self, sign: int, barred: str, arrived: Callable[[Collection[str], int], bool]) -> None:
        """In one direction until it is ``arrived``, by the pressed switches and the position."""
        pump, servo = self.pump, self.servo
        ticks = Ticks(pump.clock, 1.0 / SEARCH_RATE)
        ticks.begin()
        while True:
            states, _, switches = pump.look()
            pressed, position = switches.get(servo, frozenset()), states[servo].position
            if self.stopped():
                raise InterruptedRunError("stopped by the user; the plunger is held")
            if states[servo].alarm:
                raise PumpError(f"servo {servo} {states[servo].alarm}")
            if barred in pressed:
                raise PumpError(
                    f"the switch at the {barred} end is pressed on the way to the other one: check "
                    "its wiring, and that pump.limit_switches does not swap the pins"
                )
            if arrived(pressed, position):
                return
            goal = pump.goals[servo] + sign * pump.reach
            if not pump.limits.travel[0] <= goal <= pump.limits.travel[1]:
                raise PumpError(
                    "the servo reached the end of its range without a switch being pressed"
                )
            if abs(goal - position) > LARGEST_ERROR:
                raise PumpError(
                    f"the plunger is stuck at {position} counts with no switch pressed: it is "
                    "blocked, or the switch does not work"
                )
            pump.set_goals({servo: goal}, {servo: SEARCH_SPEED})
            ticks.wait(lambda: not self.stopped())
