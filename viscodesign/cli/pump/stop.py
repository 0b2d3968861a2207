"""`viscodesign pump stop`: stand still, whatever runs; needs no spec."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.options import Debug, Json, Quiet
from viscodesign.cli.pump._options import Baud, Log, Port
from viscodesign.errors import PumpError

if TYPE_CHECKING:
    from viscodesign.pump.boards.base import Board as AnyBoard
    from viscodesign.pump.bus.clock import Clock
    from viscodesign.pump.play.hold import FinalServoState

EXAMPLE = """\b
Examples:
  viscodesign pump stop --board dynamixel --port /dev/ttyUSB0
  viscodesign pump stop --board arbotix --port /dev/ttyUSB0 --release"""
NOBODY = (
    "no servo answers, so nothing could be verified. Switch the pump's power off where it moves. "
    "Is this the right --board and --baud?"
)
DEAF = (
    "A move that the PyPose firmware plays cannot be interrupted: the halt acts when it is over, "
    "up to 32 s later. Until then nothing answers, and only switching the power off stops it."
)


def command(
    board: Annotated[
        str,
        typer.Option("--board", metavar="NAME", help="dynamixel, arbotix or arbotix-ros."),
    ],
    port: Port = None,
    baud: Baud = None,
    ids: Annotated[
        list[int] | None,
        typer.Option("--id", metavar="N", help="Only this servo; repeatable. Else 1 to 8."),
    ] = None,
    release: Annotated[
        bool, typer.Option("--release", help="Drop the torque; pressure may push the plunger.")
    ] = False,
    log: Log = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Stand still: halt the board, hold every servo.

    Works in any state and asks nothing. Says of each servo whether that was verified, and
    exits with 4 where it was not. A servo without torque is left without.
    """
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.pump._session import Way, opened
    from viscodesign.cli.pump._setting import STANDARD_AMBIENT, TRIED, Setting

    way = Way(board, port, baud, "1", log)
    if way.simulated:
        return say("nothing to stop: a simulated pump lives only as long as its command")
    clock = way.clock()
    with opened(way, clock, Setting(None, STANDARD_AMBIENT)) as (opened_board, _log):
        left = _stopped(opened_board, list(ids or TRIED), clock, release)
        deaf = not opened_board.streams
    if json:
        say(json_text(_document(board, left)))
    elif not quiet and left:
        say("\n".join(str(one) for one in left))
    if not left:
        raise PumpError("\n".join([NOBODY, *([DEAF] if deaf else [])]))
    if not all(one.sure for one in left):
        raise PumpError("not verified for every servo: look at the pump, or switch its power off")
    return None


def _stopped(board: AnyBoard, ids: list[int], clock: Clock, release: bool) -> list[FinalServoState]:
    """Halt, then hold each servo as soon as it is found; again where the board is deaf."""
    from viscodesign.pump.play.hold import stop_all

    return stop_all(board, ids, clock, release=release)


def _document(board: str, left: list[FinalServoState]) -> dict[str, Any]:
    return {
        "board": board,
        "servos": [{"id": one.servo, "verified": one.sure, "state": one.words} for one in left],
    }
