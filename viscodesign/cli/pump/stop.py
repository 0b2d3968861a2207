"""`viscodesign pump stop`: come to rest, whatever runs; needs no spec."""

from __future__ import annotations

from typing import Annotated

import typer

from viscodesign.cli.options import Answer
from viscodesign.cli.pump._options import RealBoard, Wire
from viscodesign.errors import PumpError

EXAMPLE = """\b
Examples:
  viscodesign pump stop --board dynamixel --port /dev/ttyUSB0
  viscodesign pump stop --board arbotix --port /dev/ttyUSB0 --release"""


def command(
    *,
    board: RealBoard,
    wire: Wire,
    ids: Annotated[
        list[int] | None,
        typer.Option("--id", metavar="N", help="Only this axis; repeatable. By default all."),
    ] = None,
    release: Annotated[bool, typer.Option("--release", help="Drop the torque, or vent.")] = False,
    answer: Answer,
) -> None:
    """Halt the board and hold every axis that answers.

    Works in any state and asks nothing. Says of each whether that was verified, and exits with 4
    where it was not. An axis without force is left without; a set pressure is held.
    """
    from viscodesign.cli.output import complain, say
    from viscodesign.pump import stop

    address = wire.to(board)
    if address.simulated:
        return say("nothing to stop: a simulated pump lives only as long as its command")
    left = stop(address, ids=ids or (), release=release, tell=complain)
    axes = {f"{left[0].noun}s": [one.document() for one in left]}
    answer.give({"board": board, **axes}, map(str, left))
    if not all(one.verified for one in left):
        raise PumpError("not verified for every axis: look at the pump, or switch its power off")
    return None
