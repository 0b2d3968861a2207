"""Options that several commands share, word for word."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Spec = Annotated[Path, typer.Argument(metavar="SPEC", help="The spec, a YAML file.")]
Specs = Annotated[list[Path], typer.Argument(metavar="SPEC", help="Specs, YAML files.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a spec key, as in `run.duration=2 s`; repeatable.",
    ),
]
Json = Annotated[
    bool,
    typer.Option("--json", help="One JSON document on standard output, nothing else there."),
]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="DIR", help="Write the result's files to this folder."),
]
Quiet = Annotated[
    bool, typer.Option("--quiet", "-q", help="Say nothing but errors (and the JSON asked for).")
]
Debug = Annotated[bool, typer.Option("--debug", help="Show the traceback of an error.")]
"""Read by `main` from the words themselves; commands only declare it."""
