"""`compare.html`: paths over each other, distances, metrics side by side."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from viscodesign.report.page.packed_arrays import packed
from viscodesign.report.page.self_contained import self_contained, write_html
from viscodesign.report.page.shown_rows import MAX_SHOWN_ROWS, evenly
from viscodesign.results.coefficient_band import swept_ellipses
from viscodesign.results.run_comparison import ComparedMotion, Comparison, TipDifference

TEMPLATE = "compare.html"
SCRIPTS = ("data.js", "svg.js", "charts.js", "tip_path.js", "tables.js", "compare.js")
"""In the order in which they run; those before the last only define functions."""
MAX_PAGE_ELLIPSES, ELLIPSE_POINTS = 200, 24


def write_comparison_page(found: Comparison, file: str | Path) -> Path:
    """Write the page of a comparison. Raises `UsageError` where the file cannot be written."""
    return write_html(Path(file), self_contained(TEMPLATE, SCRIPTS, comparison_data(found)))


def comparison_data(found: Comparison) -> dict[str, Any]:
    """All that the page shows."""
    document = found.document()
    pairs = zip(document["motions"], found.motions, strict=True)
    differences = zip(document["differences"], found.differences, strict=True)
    return {
        **document,
        "notes": [*document["notes"], *_thinned(found)],
        "motions": [{**told, **_curve(motion)} for told, motion in pairs],
        "differences": [{**told, **_distances(own)} for told, own in differences],
    }


def _curve(motion: ComparedMotion) -> dict[str, Any]:
    rows = evenly(len(motion.time), MAX_SHOWN_ROWS)
    return {
        "title": motion.title,
        "time": packed(motion.time[rows], "f8"),
        "tip": packed(motion.tip[rows], "f8"),
        "band": _band(motion),
    }


def _band(motion: ComparedMotion) -> dict[str, Any] | None:
    """Ellipses, all points of one after the other, and how many points one has."""
    if motion.band is None:
        return None
    around = swept_ellipses(motion.tip, motion.band, MAX_PAGE_ELLIPSES, ELLIPSE_POINTS)
    return {"corners": packed(around.reshape(-1, 2), "f8"), "points": ELLIPSE_POINTS}


def _distances(difference: TipDifference) -> dict[str, Any]:
    rows = evenly(len(difference.time), MAX_SHOWN_ROWS)
    phase = difference.phase
    return {
        "time": packed(difference.time[rows], "f8"),
        "distance": packed(difference.distance[rows], "f8"),
        "numerical_m": difference.numerical_m,
        "band": None if difference.band is None else packed(difference.band[rows], "f8"),
        "phase": None if phase is None else packed(phase.phase, "f8"),
        "phase_distance": None if phase is None else packed(phase.distance, "f8"),
    }


def _thinned(found: Comparison) -> list[str]:
    return [
        f"{MAX_SHOWN_ROWS:,} of {len(motion.time):,} rows of {motion.label} are drawn"
        for motion in found.motions
        if len(motion.time) > MAX_SHOWN_ROWS
    ]
