"""Options that the pump's commands share, word for word."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Board = Annotated[
    str,
    typer.Option(
        "--board",
        metavar="NAME",
        help="dynamixel, arbotix, arbotix-ros or simulated.",
    ),
]
Port = Annotated[
    str | None,
    typer.Option("--port", metavar="PORT", help="Serial port; `pump ports` lists them."),
]
Baud = Annotated[
    int | None,
    typer.Option("--baud", metavar="RATE", min=1, help="Bits a second; by default the board's."),
]
Log = Annotated[
    Path | None,
    typer.Option("--log", metavar="FILE", help="Keep every byte with its time, as JSON lines."),
]
Yes = Annotated[bool, typer.Option("--yes", "-y", help="Move without asking.")]
DryRun = Annotated[
    bool, typer.Option("--dry-run", help="Say what would be done; open no port, move nothing.")
]
Pace = Annotated[
    str,
    typer.Option(
        "--pace",
        metavar="FACTOR",
        help="Speed of the simulated board's time: 1 is real, 10 ten times it, max at once.",
    ),
]
