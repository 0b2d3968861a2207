"""Ends and home of a plunger that somebody moves by hand."""

from __future__ import annotations

import select
import sys

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus.registers import PRESENT_POSITION
from viscodesign.pump.play.servo_state import read_register

LOOK = 0.1
"""Between two readings [s]."""


def positions_by_hand(board: Board, servo: int, push: str) -> tuple[int, tuple[int, int]]:
    """Home and travel [counts] of a servo without torque, as the user shows them."""
    if not sys.stdin.isatty():
        raise UsageError(
            "nobody to move the plunger by hand (standard input is no terminal); "
            "use --keep to take the spec's home and travel as they are"
        )

    def shown(what: str) -> int:
        return _shown(f"servo {servo}: move the plunger {what}, then press Enter", board, servo)

    outer = shown("to where it may be drawn out to at most")
    inner = shown("to where it may be pushed in to at most")
    home = shown("to its home")
    low, high = sorted((outer, inner))
    if (inner > outer) != (push == "up"):
        raise PumpError(
            f"counts go from {outer} to {inner} as the plunger is pushed in, but the spec says "
            f"pump.push: {push}; correct it and calibrate again"
        )
    if not low <= home <= high or low == high:
        raise PumpError(f"home {home} is not between the ends, {low} and {high}; show them again")
    return home, (low, high)


def _shown(words: str, board: Board, servo: int) -> int:
    """The position when Enter is pressed; it is seen all the time."""
    while True:
        position = read_register(board, servo, PRESENT_POSITION)
        sys.stderr.write(f"\r\x1b[K{words}: {position} counts ")
        sys.stderr.flush()
        if _entered():
            return position


def _entered() -> bool:
    ready: list[object] = select.select([sys.stdin], [], [], LOOK)[0]
    return bool(ready) and bool(sys.stdin.readline())
