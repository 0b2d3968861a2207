"""What the parts of `viscodesign compare` share."""

from __future__ import annotations

from pathlib import Path

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import PictureOptions


@dataclass(frozen=True)
class ComparisonOptions:
    """What the command line asks of a comparison."""

    overrides: list[str]
    verify: bool
    plots: bool
    report: bool
    pictures: PictureOptions
    force: bool
    json: bool
    quiet: bool


def rest_of(folder: Path) -> str:
    """Where to go on after an interrupt."""
    return f"runs that are done are in {folder}; the same command reads them and does the others"
