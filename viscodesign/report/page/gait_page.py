"""`report.html` of a gait: the robot in motion, its feet, forces and pumps."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from viscodesign.report.page.packed_arrays import packed, packed_coordinates
from viscodesign.report.page.page_data import shortened_spec
from viscodesign.report.page.self_contained import self_contained, write_html
from viscodesign.report.page.shown_rows import evenly
from viscodesign.results.walk_study import WalkStudy

TEMPLATE = "gait.html"
SCRIPTS = (
    *("data.js", "svg.js", "actuator.js", "charts.js", "player.js", "tables.js", "robot.js"),
    "gait.js",
)
"""In the order in which they run; those before the last only define functions."""
MAX_GAIT_ROWS = 1000
"""Times that are shown; of more, some at even distances."""


def write_gait_page(study: WalkStudy, file: str | Path) -> Path:
    """Write the page of a gait. Raises `UsageError` where the file cannot be written."""
    return write_html(Path(file), self_contained(TEMPLATE, SCRIPTS, gait_data(study)))


def gait_data(study: WalkStudy) -> dict[str, Any]:
    """All that the page shows."""
    motion = study.motion
    shown = evenly(len(motion.rows), MAX_GAIT_ROWS)
    rows, axes = motion.rows[shown], motion.axes[shown]
    thinned = f"{len(shown):,} of {len(motion.rows):,} recorded times are shown"
    return {
        "summary": study.document(),
        "spec": shortened_spec(study.spec_text),
        "notes": [thinned] if len(shown) < len(motion.rows) else [],
        "legs": motion.legs,
        "sources": motion.sources,
        "source_of": motion.source_of,
        "body_length": study.body_length_m,
        "foot_radius": motion.foot_radius,
        "points": (axes[0, :, :, 0] == axes[0, :, :, 0]).sum(axis=1).tolist(),
        "time": packed(motion.time[rows], "f8"),
        "body": packed(motion.body[rows], "f8"),
        "lift": packed(motion.feet[rows, :, 1], "f8"),
        "normal": packed(motion.normal[rows], "f8"),
        "friction": packed(motion.friction[rows], "f8"),
        "pressure": packed(motion.pressure[rows], "f8"),
        "barrel": packed(motion.barrel[rows], "f8"),
        "axes": packed_coordinates(axes),
    }
