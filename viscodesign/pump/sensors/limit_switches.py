"""Limit switches of the plunger's ends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pump import LimitSwitchSpec, PumpSpec


class Switches:
    """Of each servo that has some: two, at the ends of its plunger's travel."""

    def __init__(self, settings: Mapping[int, LimitSwitchSpec]) -> None:
        self._settings = dict(settings)

    @classmethod
    def of(cls, pump: PumpSpec, servos: Sequence[int]) -> Switches:
        """A spec's, for servos in the order of their inlets."""
        pairs = zip(servos, each(pump.limit_switches, len(servos)), strict=True)
        return cls({servo: switches for servo, switches in pairs if switches is not None})

    def read(self, board: Board) -> dict[int, frozenset[str]]:
        """By servo: ends ('low', 'high') whose switch is pressed.

        Of normally closed ones, a broken wire is pressed too.
        """
        return {servo: _pressed_ends(board, pair) for servo, pair in self._settings.items()}


def _pressed_ends(board: Board, switches: LimitSwitchSpec) -> frozenset[str]:
    # Pins are pulled up: an open circuit reads high.
    pressed_level = switches.normally == "closed"
    pins = {"low": switches.low, "high": switches.high}
    return frozenset(end for end, pin in pins.items() if _level(board, pin) == pressed_level)


def _level(board: Board, pin: str) -> bool:
    level = board.digital(pin)
    if level is None:
        raise PumpError(
            f"board {board.name} has no pins, so the limit switch on {pin} cannot be read; "
            "use --board arbotix-ros, or leave out pump.limit_switches"
        )
    return level
