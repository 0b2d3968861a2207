"""Options shared by several commands."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from viscodesign.cli.completion import override_keys, spec_files

Spec = Annotated[
    Path,
    typer.Argument(
        metavar="SPEC", help="Spec (YAML file); - is standard input.", autocompletion=spec_files
    ),
]
Specs = Annotated[
    list[Path],
    typer.Argument(
        metavar="SPEC", help="Specs (YAML files); - is standard input.", autocompletion=spec_files
    ),
]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a spec key, such as `run.duration=2 s`; repeatable.",
        autocompletion=override_keys,
    ),
]
Markers = Annotated[
    Path | None,
    typer.Option(
        "--markers",
        metavar="FILE",
        help="Of recordings in space: markers at the clamp and the tip (YAML).",
    ),
]
Json = Annotated[
    bool,
    typer.Option("--json", help="Print one JSON document, and nothing else, to standard output."),
]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="DIR", help="Write the results to this folder."),
]
RunFolder = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="DIR", help="Output folder; runs/<name> by default."),
]
NoPlots = Annotated[bool, typer.Option("--no-plots", help="Skip the pictures.")]
NoReport = Annotated[bool, typer.Option("--no-report", help="Skip the page, report.html.")]
PictureFormat = Annotated[
    Literal["png", "pdf", "svg"], typer.Option("--format", help="Format of the pictures.")
]
PictureStyle = Annotated[
    Literal["plain", "paper", "talk", "dark"],
    typer.Option(
        "--style",
        help="Style of the pictures: paper has no titles, talk is large, dark is on dark.",
    ),
]
PictureWidth = Annotated[
    str | None,
    typer.Option(
        "--width",
        metavar="MM",
        help="Width of the pictures: single (89 mm), double (183 mm; paper), or 80 to 400 mm.",
    ),
]
Force = Annotated[bool, typer.Option("--force", help="Write even if the folder holds other files.")]
Quiet = Annotated[
    bool, typer.Option("--quiet", "-q", help="Print errors only (and the JSON document).")
]
Debug = Annotated[bool, typer.Option("--debug", help="Show tracebacks of errors.")]
"""Read by `main` from the command line itself; commands only declare it."""
