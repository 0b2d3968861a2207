"""Limit switches at the ends of the plungers' travel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.servo import LimitSwitchSpec, ServoPumpSpec


class Switches:
    """The two limit switches of each servo that has them."""

    def __init__(self, settings: Mapping[int, LimitSwitchSpec]) -> None:
        self._settings = dict(settings)

    @classmethod
    def of(cls, pump: ServoPumpSpec, servos: Sequence[int]) -> Switches:
        """Those of a spec, for servos in the order of their inlets."""
        pairs = zip(servos, each(pump.limit_switches, len(servos)), strict=True)
        return cls({servo: switches for servo, switches in pairs if switches is not None})

    def read(self, board: Controller) -> dict[int, frozenset[str]]:
        """By servo: the ends ('low', 'high') whose switch is pressed, or its wire broken."""
        # Pins are pulled up: an open circuit reads high.
        return {
            servo: frozenset(
                end
                for end, pin in (("low", pair.low), ("high", pair.high))
                if _level(board, pin) == (pair.normally == "closed")
            )
            for servo, pair in self._settings.items()
        }


def _level(board: Controller, pin: str) -> bool:
    level = board.digital(pin)
    if level is None:
        raise PumpError(
            f"board {board.name} has no pins, so the limit switch on {pin} cannot be read; "
            "use --board arbotix-ros, or leave out pump.limit_switches"
        )
    return level
