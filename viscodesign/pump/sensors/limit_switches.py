"""Limit switches at the ends of the plungers' travel."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.servo import ServoPumpSpec


def pressed_switches(
    board: Controller, pump: ServoPumpSpec | None, servos: Sequence[int]
) -> dict[int, frozenset[str]]:
    """By servo that has switches: the ends ('low', 'high') whose switch is pressed.

    A broken wire counts as pressed. ``servos``: ids in the order of the spec's inlets.
    """
    if pump is None:
        return {}
    # Pins are pulled up: an open circuit reads high.
    return {
        servo: frozenset(
            end
            for end, pin in (("low", pair.low), ("high", pair.high))
            if _level(board, pin) == (pair.normally == "closed")
        )
        for servo, pair in zip(servos, each(pump.limit_switches, len(servos)), strict=True)
        if pair is not None
    }


def _level(board: Controller, pin: str) -> bool:
    level = board.digital(pin)
    if level is None:
        raise PumpError(
            f"board {board.name} has no pins, so the limit switch on {pin} cannot be read; "
            "use the board arbotix-ros, or leave out pump.limit_switches"
        )
    return level
