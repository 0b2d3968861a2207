"""Options that the pump's commands share, word for word."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.pump._board_help import ALL_BOARDS, REAL_BOARDS
from viscodesign.errors import UsageError

if TYPE_CHECKING:
    from viscodesign.scene.scene import Scene

Board = Annotated[
    str,
    typer.Option(
        "--board",
        metavar="NAME",
        help=f"{ALL_BOARDS}.",
    ),
]
RealBoard = Annotated[
    str,
    typer.Option("--board", metavar="NAME", help=f"{REAL_BOARDS}."),
]
Port = Annotated[
    str | None,
    typer.Option("--port", metavar="PORT", help="Serial port; `pump ports` lists them."),
]
Baud = Annotated[
    int | None,
    typer.Option("--baud", metavar="RATE", min=1, help="Bits per second; by default the board's."),
]
Log = Annotated[
    Path | None,
    typer.Option("--log", metavar="FILE", help="Keep every byte with its time, as JSON lines."),
]
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


def optional_scene(spec: Path | None, overrides: list[str] | None) -> Scene | None:
    """The scene of a command for which a spec is optional."""
    from viscodesign.cli.specs import read_pumped

    if spec is not None:
        return read_pumped(spec, overrides)
    if overrides:
        raise UsageError("--set overrides a spec, and none is given")
    return None
