"""Limit switches of the plunger's ends."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pumps.boards.base import Board
from viscodesign.scene.pump import LimitSwitches


class Switches:
    """The spec's switches, or none."""

    def __init__(self, settings: LimitSwitches | None) -> None:
        self._pins = {} if settings is None else {"low": settings.low, "high": settings.high}
        self._open_is_pressed = settings is not None and settings.normally == "closed"
        """Pins are pulled up: an open circuit reads high."""

    def __bool__(self) -> bool:
        return bool(self._pins)

    def read(self, board: Board) -> frozenset[str]:
        """Ends whose switch is pressed; of normally closed ones, a broken wire is pressed too."""
        return frozenset(end for end, pin in self._pins.items() if self._pressed(board, pin))

    def _pressed(self, board: Board, pin: str) -> bool:
        level = board.digital(pin)
        if level is None:
            raise PumpError(
                f"board {board.name} reads no pins, so the limit switch on {pin} cannot be heard; "
                "use --board arbotix-ros, or leave out pump.limit_switches"
            )
        return level == self._open_is_pressed
