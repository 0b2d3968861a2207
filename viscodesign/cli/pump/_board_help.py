"""The boards that `--help` lists: those of all kinds of pump, so also of installed packages.

They are looked up by the command that has the option, and not as all commands are set up.
"""

from __future__ import annotations

from typing import Any

from typer.core import TyperCommand

REAL_BOARDS, ALL_BOARDS = "{real boards}", "{all boards}"
"""What a help text has in place of their names."""


class PumpCommand(TyperCommand):
    """A command of the pump, whose help names the boards that there are."""

    def get_params(self, ctx: Any) -> list[Any]:
        """The parameters, with their help texts complete."""
        found = super().get_params(ctx)
        for parameter in found:
            words = getattr(parameter, "help", None) or ""
            if REAL_BOARDS in words or ALL_BOARDS in words:
                parameter.help = _with_names(words)  # type: ignore[attr-defined]
        return found


def _with_names(words: str) -> str:
    from viscodesign.pump.sessions.board_names import SIMULATED_BOARD, real_boards

    real = real_boards()
    named = words.replace(REAL_BOARDS, _joined(real))
    return named.replace(ALL_BOARDS, _joined([*real, SIMULATED_BOARD]))


def _joined(names: list[str]) -> str:
    return f"{', '.join(names[:-1])} or {names[-1]}"
