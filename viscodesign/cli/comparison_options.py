"""What the parts of `viscodesign compare` share."""

from __future__ import annotations

from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class ComparisonOptions:
    """What the command line asks of a comparison."""

    overrides: Overrides = None
    no_verify: Annotated[
        bool, typer.Option("--no-verify", help="Skip the error estimate of specs.")
    ] = False
    no_report: Annotated[bool, typer.Option("--no-report", help="Skip the page, compare.html.")] = (
        False
    )
    _: KW_ONLY
    files: ResultFiles
    answer: Answer


def rest_of(folder: Path) -> str:
    """Where to go on after an interrupt."""
    return f"runs that are done are in {folder}; the same command reads them and does the others"
