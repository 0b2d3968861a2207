"""Home and the ends of travel: found with limit switches or by hand, and kept in the servo."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from viscodesign.errors import PumpError, UsageError
from viscodesign.interrupt import stop_on_signals
from viscodesign.pump.ax import eeprom
from viscodesign.pump.ax.eeprom import RegisterChange, changes
from viscodesign.pump.ax.hold import release
from viscodesign.pump.ax.preflight import identify
from viscodesign.pump.ax.servo_pump import ServoPump as ConnectedPump
from viscodesign.pump.ax.servo_state import read_register
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.registers import PRESENT_POSITION
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.play.homing import find_travel
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.connection import (
    BoardAddress,
    Confirm,
    PumpSetup,
    Tell,
    connected,
    unheard,
)
from viscodesign.scene.pump import MAX_SERVO_COUNTS, PumpSpec
from viscodesign.scene.scene import Scene

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
    tell: Tell = unheard,
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
    clock, setup = address.clock(), PumpSetup.of(scene)
    with connected(address, clock, setup, None, tell) as (board, log):
        pump, asked = pump_of(scene), (confirm, vented or confirm)
        session = _CalibrationSteps(board, clock, pump, *asked, by_hand, tell)
        if rename is not None:
            session.rename(*rename)
        servos = setup.servos(board)
        tell(f"found {board.identify()}")
        found = session.as_stated() if keep else session.measured(servos)
        for servo in servos:
            session.keep_in(servo, found.travel)
        log.event("calibrated", home_counts=found.home, travel_counts=found.travel)
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


@dataclass(frozen=True)
class _CalibrationSteps:
    board: Board
    clock: Clock
    pump: PumpSpec
    confirm: Confirm
    vented: Confirm
    by_hand: ShowPosition | None
    tell: Tell

    def as_stated(self) -> Calibration:
        return Calibration(self.pump.home, self.pump.travel)

    def measured(self, servos: list[int]) -> Calibration:
        if len(servos) > 1:
            raise UsageError(
                "all servos of a spec share home and travel; calibrate each with a spec that has "
                "its servo_id alone, then this one with --keep"
            )
        if self.pump.limit_switches is None:
            return self._by_hand(servos[0])
        return self._against_switches(servos[0])

    def _against_switches(self, servo: int) -> Calibration:
        _require(
            self.confirm,
            "the plunger moves slowly to both ends, until their switches are pressed; vent it "
            "first\nMove the plunger?",
        )
        free = self.pump.model_copy(update={"travel": (0, MAX_SERVO_COUNTS)})
        switches = Switches.of(self.pump, [servo])
        moved = ConnectedPump(
            self.board, free, [servo], PressureReadings([None], 0.0), switches, self.clock
        )
        with stop_on_signals() as request:
            low, high = find_travel(moved, lambda: request.asked)
        return Calibration(low if self.pump.push == "up" else high, (low, high))

    def _by_hand(self, servo: int) -> Calibration:
        if self.by_hand is None:
            raise UsageError(
                "nobody to move the plunger by hand; keep the spec's home and travel instead"
            )
        _require(
            self.vented,
            "the torque goes off; pressure in the syringe would push the plunger: vent it first\n"
            "Is it vented?",
        )
        for one in release(self.board, [servo], self.clock):
            if not one.verified:
                raise PumpError(str(one))
        outer, inner, home = (
            self.by_hand(
                f"servo {servo}: move the plunger {place}, then press Enter",
                lambda: read_register(self.board, servo, PRESENT_POSITION),
            )
            for place in ("out as far as it may go", "in as far as it may go", "to its home")
        )
        return _calibration_of(outer, inner, home, self.pump.push)

    def rename(self, old: int, new: int) -> None:
        if not 0 <= new <= HIGHEST_ID:
            raise UsageError(f"--rename: ids go from 0 to {HIGHEST_ID}; got {new}")
        if self.board.answers(new):
            raise PumpError(f"a servo with id {new} exists already; two would answer at once")
        self._write(RegisterChange(old, registers.ID, old, new))

    def keep_in(self, servo: int, travel: tuple[int, int]) -> None:
        """Bring a servo's EEPROM up to date, one register at a time."""
        different = changes(identify(self.board, servo), travel)
        for change in different:
            self._write(change)
        if not different:
            self.tell(f"servo {servo} is up to date; nothing is written")

    def _write(self, change: RegisterChange) -> None:
        _require(self.confirm, f"EEPROM of {change}\nWrite it?")
        eeprom.write(self.board, change)


def _require(confirm: Confirm, text: str) -> None:
    if not confirm(text):
        raise UsageError("aborted; nothing moved")


def _calibration_of(outer: int, inner: int, home: int, push: str) -> Calibration:
    """From three positions [counts]: drawn out, pushed in, home."""
    low, high = sorted((outer, inner))
    if (inner > outer) != (push == "up"):
        raise PumpError(
            f"counts went from {outer} to {inner} as the plunger was pushed in, but the spec says "
            f"pump.push: {push}; correct it and calibrate again"
        )
    if not low <= home <= high or low == high:
        raise PumpError(f"home {home} is not between the ends, {low} and {high}; try again")
    return Calibration(home, (low, high))
