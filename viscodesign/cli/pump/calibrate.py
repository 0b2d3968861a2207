"""`viscodesign pump calibrate`: where home and the ends of travel are, kept in the servo too."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Debug, Overrides, Quiet, Spec
from viscodesign.cli.pump._options import Baud, DryRun, Log, Port, Yes
from viscodesign.errors import PumpError, UsageError

if TYPE_CHECKING:
    from viscodesign.cli.pump._setting import Setting
    from viscodesign.pump.boards.base import Board as AnyBoard
    from viscodesign.pump.bus.clock import Clock
    from viscodesign.pump.play.eeprom import RegisterChange
    from viscodesign.pump.play.preflight import FoundServo
    from viscodesign.scene.pump import Pump

EXAMPLE = """\b
Examples:
  viscodesign pump calibrate leg.yaml --board dynamixel --port /dev/ttyUSB0
  viscodesign pump calibrate leg.yaml --keep --board dynamixel \\
    --port /dev/ttyUSB0"""
AnyTravel = tuple[int, int]
HIGHEST = 252
"""Id; 253 is the ArbotiX itself."""


def command(
    spec: Spec,
    board: Annotated[
        str, typer.Option("--board", metavar="NAME", help="dynamixel, arbotix or arbotix-ros.")
    ],
    port: Port = None,
    baud: Baud = None,
    keep: Annotated[
        bool, typer.Option("--keep", help="Take the spec's home and travel; measure nothing.")
    ] = False,
    rename: Annotated[
        str | None,
        typer.Option("--rename", metavar="OLD=NEW", help="Give a servo another id first."),
    ] = None,
    write: Annotated[
        bool, typer.Option("--write", help="Put home and travel into the spec's file.")
    ] = False,
    log: Log = None,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Find home and travel, and keep them in the servo.

    Its own angle limits are set to the travel. Against limit switches where the spec names
    them, slowly and with little torque; else by hand, with the torque off. The only command
    that writes what a servo keeps without power: ids, angle limits and whether it answers;
    only what differs, and each is asked for.
    """
    from viscodesign import load
    from viscodesign.cli.output import say
    from viscodesign.cli.pump._session import Way, opened
    from viscodesign.cli.pump._setting import Setting

    way = Way(board, port, baud, "1", log)
    setting = Setting.of(load(spec, overrides or ()))
    if dry_run:
        return say("\n".join(_described(setting, keep, rename)))
    if way.simulated:
        raise UsageError("--board simulated: a simulated pump is calibrated as its spec says")
    clock = way.clock()
    with opened(way, clock, setting) as (opened_board, log_of_bytes):
        found = _calibrate(opened_board, setting, clock, keep, rename, yes)
        log_of_bytes.event("calibrated", home_counts=found[0], travel_counts=found[1])
    _tell(spec, found, write, quiet)
    return None


def _described(setting: Setting, keep: bool, rename: str | None) -> list[str]:
    pump = _pump(setting)
    how = "switch the torque off, and ask you to move the plunger by hand"
    if pump.limit_switches is not None:
        how = "move the plunger slowly against both limit switches"
    return [
        "[dry run] no port is opened; it would",
        *([f"  give a servo another id: {rename}"] if rename else []),
        f"  {'take home and travel from the spec' if keep else how}",
        "  write the angle limits into the EEPROM where they differ, after asking for each",
    ]


def _pump(setting: Setting) -> Pump:
    assert setting.pump is not None  # of a spec, as `Setting.of` sees to
    return setting.pump


def _calibrate(
    board: AnyBoard, setting: Setting, clock: Clock, keep: bool, rename: str | None, yes: bool
) -> tuple[int, AnyTravel]:
    from viscodesign.cli.output import complain
    from viscodesign.pump.play.preflight import identify

    if rename:
        _rename(board, rename, yes)
    pump, servos = _pump(setting), setting.servos(board)
    complain(f"found {board.identify()}")
    found = (pump.home, pump.travel) if keep else _measured(board, pump, servos, clock, yes)
    for servo in servos:
        _keep_in(board, identify(board, servo), found[1], yes)
    return found


def _measured(
    board: AnyBoard, pump: Pump, servos: list[int], clock: Clock, yes: bool
) -> tuple[int, AnyTravel]:
    if len(servos) > 1:
        raise UsageError(
            "home and travel are one for all servos of a spec; calibrate each by a spec with its "
            "servo_id alone, then this one with --keep"
        )
    if pump.limit_switches is None:
        return _by_hand(board, pump, servos[0], clock)
    return _against_switches(board, pump, servos[0], clock, yes)


def _by_hand(board: AnyBoard, pump: Pump, servo: int, clock: Clock) -> tuple[int, AnyTravel]:
    from viscodesign.cli.confirm import confirm
    from viscodesign.cli.pump._by_hand import positions_by_hand
    from viscodesign.pump.play.hold import release

    confirm(
        ["the torque goes off; pressure in the syringe would push the plunger: vent it first"],
        "Is it vented?",
        yes=False,
    )
    for one in release(board, [servo], clock):
        if not one.sure:
            raise PumpError(str(one))
    return positions_by_hand(board, servo, pump.push)


def _against_switches(
    board: AnyBoard, pump: Pump, servo: int, clock: Clock, yes: bool
) -> tuple[int, AnyTravel]:
    from viscodesign.cli.confirm import confirm
    from viscodesign.interrupt import stop_on_signals
    from viscodesign.pump.play.homing import find_travel
    from viscodesign.pump.play.pump import Pump as Moved
    from viscodesign.pump.sensors.limit_switches import Switches
    from viscodesign.pump.sensors.pressure_readings import PressureReadings
    from viscodesign.scene.pump import SERVO_COUNTS

    confirm(
        ["the plunger goes slowly to both ends, until their switches are pressed; vent it first"],
        "Move the plunger?",
        yes=yes,
    )
    free = pump.model_copy(update={"travel": (0, SERVO_COUNTS)})
    switches = Switches.of(pump, [servo])
    moved = Moved(board, free, [servo], PressureReadings([None], 0.0), switches, clock)
    with stop_on_signals() as wish:
        low, high = find_travel(moved, lambda: wish.asked)
    return (low if pump.push == "up" else high), (low, high)


def _rename(board: AnyBoard, words: str, yes: bool) -> None:
    from viscodesign.pump.bus import registers
    from viscodesign.pump.play.eeprom import RegisterChange

    try:
        old, new = (int(word) for word in words.split("="))
    except ValueError:
        raise UsageError(f"--rename {words}: give two ids, like 1=2") from None
    if not 0 <= new <= HIGHEST:
        raise UsageError(f"--rename {words}: ids go from 0 to 252; 253 is the ArbotiX itself")
    if board.answers(new):
        raise PumpError(f"a servo with id {new} is there already; two would answer at once")
    _write(board, RegisterChange(old, registers.ID, old, new), yes)


def _keep_in(board: AnyBoard, servo: FoundServo, travel: AnyTravel, yes: bool) -> None:
    """Bring a servo's EEPROM in line, one register after the other."""
    from viscodesign.cli.output import complain
    from viscodesign.pump.play.eeprom import changes

    wanted = changes(servo, travel)
    for change in wanted:
        _write(board, change, yes)
    if not wanted:
        complain(f"servo {servo.id} holds all of it already; nothing is written")


def _write(board: AnyBoard, change: RegisterChange, yes: bool) -> None:
    from viscodesign.cli.confirm import confirm
    from viscodesign.pump.play import eeprom as permanent

    confirm([f"EEPROM of {change}"], "Write it?", yes=yes)
    permanent.write(board, change)


def _tell(spec: Path, found: tuple[int, AnyTravel], write: bool, quiet: bool) -> None:
    from viscodesign.cli.output import complain, say
    from viscodesign.scene.reading.edit import spec_lines, write_spec

    if write:
        write_spec(spec, *found)
        complain(f"written into {spec}")
    if not quiet:
        say("\n".join(["pump:", *(f"  {line}" for line in spec_lines(*found))]))
