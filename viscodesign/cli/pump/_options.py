"""Options that the pump's commands share, word for word.

Boards are looked up by the command that has the option, and not as all commands are set up: they
are those of all kinds of pump, so also of installed packages.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass

if TYPE_CHECKING:
    from viscodesign.pump import BoardAddress
    from viscodesign.scene.scene import Scene

REAL_BOARDS, ALL_BOARDS = "{real boards}", "{all boards}"
"""What a help text has in place of their names."""

Board = Annotated[str, typer.Option("--board", metavar="NAME", help=f"{ALL_BOARDS}.")]
RealBoard = Annotated[str, typer.Option("--board", metavar="NAME", help=f"{REAL_BOARDS}.")]
Yes = Annotated[bool, typer.Option("--yes", "-y", help="Move without asking.")]
DryRun = Annotated[
    bool, typer.Option("--dry-run", help="Show what would be done; open no port, move nothing.")
]
Pace = Annotated[
    str,
    typer.Option(
        "--pace",
        metavar="FACTOR",
        help="Speed of the simulated board's time: 1 is real time, max does not wait.",
    ),
]
OptionalSpec = Annotated[
    Path | None, typer.Argument(metavar="[SPEC]", help="Names the pump, its sensors and switches.")
]
Achievable = Annotated[
    bool,
    typer.Option("--achievable", help="Play what the pump can do of a profile beyond its limits."),
]
Force = Annotated[bool, typer.Option("--force", help="Overwrite files that exist.")]


@dataclass(frozen=True)
class Wire:
    """The way to a board."""

    port: Annotated[
        str | None,
        typer.Option("--port", metavar="PORT", help="Serial port; `pump ports` lists them."),
    ] = None
    baud: Annotated[
        int | None,
        typer.Option(
            "--baud", metavar="RATE", min=1, help="Bits per second; by default the board's."
        ),
    ] = None
    log: Annotated[
        Path | None,
        typer.Option("--log", metavar="FILE", help="Keep every byte with its time, as JSON lines."),
    ] = None

    def to(self, board: str, pace: str = "1") -> BoardAddress:
        """The address of a board."""
        from viscodesign.pump import BoardAddress

        return BoardAddress(board, self.port, self.baud, pace, self.log)


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

    for placeholder, names in (
        (REAL_BOARDS, real_boards()),
        (ALL_BOARDS, [*real_boards(), SIMULATED_BOARD]),
    ):
        words = words.replace(placeholder, f"{', '.join(names[:-1])} or {names[-1]}")
    return words


def optional_scene(spec: Path | None, overrides: list[str] | None) -> Scene | None:
    """The scene of a command for which a spec is optional."""
    from viscodesign.cli.specs import read_pumped

    if spec is not None:
        return read_pumped(spec, overrides)
    if overrides:
        raise UsageError("--set overrides a spec, and none is given")
    return None
