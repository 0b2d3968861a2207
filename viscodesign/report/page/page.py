"""`report.html`: the page put together from its parts."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.page.page_data import page_data
from viscodesign.report.page.self_contained import self_contained, write_html
from viscodesign.results.trajectory import Trajectory

TEMPLATE = "page.html"
SCRIPTS = (
    "data.js",
    "svg.js",
    "actuator.js",
    "charts.js",
    "tip_path.js",
    "player.js",
    "tables.js",
    "effect_bars.js",
    "sketch_model.js",
    "sketch.js",
    "main.js",
)
"""In the order in which they run; those before `main.js` only define functions."""


def write_page(run: Trajectory, file: str | Path) -> Path:
    """Write the page of a run, in a new folder where there is none; `Trajectory.report`.

    Raises `UsageError` where the file cannot be written.
    """
    return write_html(Path(file), page_bytes(run))


def page_bytes(run: Trajectory) -> bytes:
    """The whole page."""
    return self_contained(TEMPLATE, SCRIPTS, page_data(run))
