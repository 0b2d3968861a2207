"""Stopping whatever runs, with nothing known of it but the board."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.hold import Standing, hold
from viscodesign.pump.play.hold import release as drop_torque

DEAF = 40.0
"""A board that plays by itself may hear nothing this long: its moves last up to 32.8 s [s]."""
AGAIN = 2.0
"""Between two halts of such a board [s]."""


def stop_all(
    board: Board, ids: Sequence[int], clock: Clock, *, release: bool = False
) -> list[Standing]:
    """Halt the board's own program, then hold (or release) each servo that is found.

    Each is told as soon as it is found: others that are not there would cost time. Empty where
    none answers; a board that plays by itself is asked again until its move must be over.
    """
    board.halt()
    deadline = clock.now() + (0.0 if board.streams else DEAF)
    while not (left := _each(board, ids, clock, release)) and clock.now() < deadline:
        clock.sleep(AGAIN)
        board.halt()
    return left


def _each(board: Board, ids: Sequence[int], clock: Clock, drop: bool) -> list[Standing]:
    act = drop_torque if drop else hold
    return [one for servo in ids if _is_there(board, servo) for one in act(board, [servo], clock)]


def _is_there(board: Board, servo: int) -> bool:
    """Also where what comes from it is broken: then it is told all the same."""
    try:
        return board.answers(servo)
    except PumpError:
        return False
