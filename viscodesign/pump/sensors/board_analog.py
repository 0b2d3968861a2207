"""The sensor on an analog input of the board."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board
from viscodesign.pump.sensors.base import PressureSource


class BoardAnalog(PressureSource):
    """As precise as the board's converter."""

    def __init__(self, board: Board, channel: int) -> None:
        if not board.has_pins:
            raise PumpError(
                f"the board {board.name} has no analog inputs: leave out `pump.sensor`, or use "
                "--board arbotix-ros"
            )
        self._board = board
        self._channel = channel

    def ratio(self) -> float:
        ratio = self._board.analog(self._channel)
        if ratio is None:
            raise PumpError(f"the board {self._board.name} has no analog input {self._channel}")
        return ratio

    def close(self) -> None:
        """The board is closed by who opened it."""
