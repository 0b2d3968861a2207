"""Home and the ends of travel: found with limit switches or by hand, and kept in the servo."""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.errors import PumpError, UsageError
from viscodesign.interrupt import stop_on_signals
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.hold import release
from viscodesign.pump.ax.homing import find_travel
from viscodesign.pump.ax.preflight import RegisterChange, changes, identify
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.servo_state import read_register
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.connection import (
    BoardAddress,
    Confirm,
    Connection,
    Tell,
    connected,
    ignore,
    require,
)
from viscodesign.scene.pump import MAX_SERVO_COUNTS, PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

HIGHEST_ID = 252
"""253 is the ArbotiX itself."""

ShowPosition = Callable[[str, Callable[[], int]], int]
"""Asks the user to move the plunger; given what to do and what reads the position [counts].

Returns the position at which the user said so.
"""


@dataclass(frozen=True)
class Calibration:
    """Where a plunger starts and how far it may go, in servo counts."""

    home: int
    travel: tuple[int, int]


def calibrate(
    scene: Scene,
    address: BoardAddress,
    *,
    confirm: Confirm,
    by_hand: ShowPosition | None = None,
    vented: Confirm | None = None,
    keep: bool = False,
    rename: tuple[int, int] | None = None,
    tell: Tell = ignore,
) -> Calibration:
    """Find home and travel, and set the servo's own angle limits to the travel.

    With the scene's limit switches, slowly and at low torque; without them by hand, with the
    torque off: ``vented`` (by default ``confirm``) is asked before, and ``by_hand`` for each
    position. ``keep`` takes the scene's values and measures nothing; ``rename`` first gives a
    servo another id (old, new). The only session that writes what a servo keeps without power:
    only what differs, each after ``confirm``.
    """
    if address.simulated:
        raise UsageError("--board simulated: a simulated pump is calibrated as its spec says")
    pump = pump_of(scene)
    with connected(address, scene, tell=tell) as link:
        if rename is not None:
            _rename(link, *rename, confirm)
        tell(f"found {link.board.identify()}")
        if keep:
            found = Calibration(pump.home, pump.travel)
        elif len(link.servos) > 1:
            raise UsageError(
                "all servos of a spec share home and travel; calibrate each with a spec that has "
                "its servo_id alone, then this one with --keep"
            )
        elif pump.limit_switches is None:
            found = _by_hand(link, pump, by_hand, vented or confirm)
        else:
            found = _against_switches(link, pump, confirm)
        for servo in link.servos:
            different = changes(identify(link.board, servo), found.travel)
            for change in different:
                _write(link, change, confirm)
            if not different:
                tell(f"servo {servo} is up to date; nothing is written")
        link.log.event("calibrated", home_counts=found.home, travel_counts=found.travel)
    return found


def calibration_steps(scene: Scene, keep: bool, rename: tuple[int, int] | None) -> list[str]:
    """What `calibrate` would do; opens no port."""
    how = "switch the torque off, and ask you to move the plunger by hand"
    if pump_of(scene).limit_switches is not None:
        how = "move the plunger slowly against both limit switches"
    return [
        "[dry run] no port is opened; it would",
        *([f"  change a servo's id from {rename[0]} to {rename[1]}"] if rename else []),
        f"  {'take home and travel from the spec' if keep else how}",
        "  write angle limits to the EEPROM where they differ, asking before each",
    ]


def _rename(link: Connection, old: int, new: int, confirm: Confirm) -> None:
    if not 0 <= new <= HIGHEST_ID:
        raise UsageError(f"--rename: ids go from 0 to {HIGHEST_ID}; got {new}")
    if link.board.answers(new):
        raise PumpError(f"a servo with id {new} exists already; two would answer at once")
    _write(link, RegisterChange(old, registers.ID, old, new), confirm)


def _write(link: Connection, change: RegisterChange, confirm: Confirm) -> None:
    require(confirm, f"EEPROM of {change}\nWrite it?")
    change.write(link.board)


def _against_switches(link: Connection, pump: PumpSpec, confirm: Confirm) -> Calibration:
    require(
        confirm,
        "the plunger moves slowly to both ends, until their switches are pressed; vent it "
        "first\nMove the plunger?",
    )
    free = copied(pump, {"travel": (0, MAX_SERVO_COUNTS)})
    switches, no_sensor = Switches.of(pump, link.servos), PressureReadings([None], 0.0)
    moved = ServoPump(link.board, free, link.servos, no_sensor, switches, link.clock)
    with stop_on_signals() as request:
        low, high = find_travel(moved, lambda: request.asked)
    return Calibration(low if pump.push == "up" else high, (low, high))


def _by_hand(
    link: Connection, pump: PumpSpec, by_hand: ShowPosition | None, vented: Confirm
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
    (servo,) = link.servos
    (left,) = release(link.board, [servo], link.clock)
    if not left.verified:
        raise PumpError(str(left))
    outer, inner, home = (
        by_hand(
            f"servo {servo}: move the plunger {place}, then press Enter",
            lambda: read_register(link.board, servo, registers.PRESENT_POSITION),
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
