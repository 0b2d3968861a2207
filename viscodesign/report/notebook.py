"""What a notebook shows of a scene or a run: tables and a picture, as HTML."""

from __future__ import annotations

import html
from collections.abc import Iterable
from typing import Any

import numpy as np

from viscodesign.results.findings import outside_words
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.reading.write import plain_part
from viscodesign.scene.scene import Scene

Rows = Iterable[tuple[str, str]]
"""What something is, and its value, in words."""
MAX_SHOWN = 200
"""Characters of a key's value: a table of measured rows is not listed."""
MAX_PATH_POINTS = 400
"""Points of a path that is drawn."""
THUMBNAIL_SIDE = 180
"""Longer side of the picture [px]."""


def scene_html(scene: Scene) -> str:
    """The resolved spec, a row for each key."""
    return html_table(repr(scene), _rows(plain_part(scene)))


def trajectory_html(trajectory: Trajectory) -> str:
    """What came out, and the path of the tip."""
    table = html_table(repr(trajectory), _outcome(trajectory))
    return f"<div>{table}{tip_svg(trajectory)}</div>"


def tip_svg(trajectory: Trajectory) -> str:
    """The path of the tip, z downwards as the actuator hangs; its start is a ring.

    Drawn in the colour of the text around it, so that it is seen on a light and a dark page.
    """
    points = trajectory.tip[:: max(1, len(trajectory.tip) // MAX_PATH_POINTS), :2]
    if not len(points):
        return ""
    low, high = points.min(axis=0), points.max(axis=0)
    extent = max(float(np.max(high - low)), 1e-9 * trajectory.length)
    placed = (points - low) / extent * THUMBNAIL_SIDE + 8.0
    width, height = (high - low) / extent * THUMBNAIL_SIDE + 16.0
    path = " ".join(f"{x:.1f},{z:.1f}" for x, z in placed)
    x, z = placed[0]
    return (
        f'<svg width="{width:.0f}" height="{height:.0f}" role="img" fill="none" '
        'stroke="currentColor">'
        f"<title>path of the tip, {1e3 * extent:.3g} mm along its longer side</title>"
        f'<polyline points="{path}"/><circle cx="{x:.1f}" cy="{z:.1f}" r="4"/></svg>'
    )


def _outcome(trajectory: Trajectory) -> Rows:
    accuracy, metrics = trajectory.accuracy, trajectory.metrics
    yield "status", trajectory.failure or trajectory.status
    yield "quadrant", f"{trajectory.classification.quadrant}: {trajectory.classification.meaning}"
    for axis in "xz":
        low, high = (1e3 * metrics[f"tip_{axis}_{end}_m"] for end in ("min", "max"))
        yield f"tip {axis}", f"{low:.1f} to {high:.1f} mm"
    error = accuracy.estimated_tip_error_m
    stated = accuracy.method if error is None else f"{1e3 * error:.3g} mm"
    yield "tip error", f"{stated} (requested {1e3 * accuracy.requested_m:.3g} mm)"
    if trajectory.violations:
        yield "validity", outside_words(trajectory.violations)
    for decision in ("included", "neglected"):
        names = [v.name for v in trajectory.effects if v.decision == decision]
        yield decision, ", ".join(names) or "none"
    for notice in trajectory.warnings:
        yield f"warning: {notice.code}", notice.message


def _rows(keys: dict[str, Any], above: str = "") -> Rows:
    for key, value in keys.items():
        if isinstance(value, dict):
            yield from _rows(value, f"{above}{key}.")
        else:
            text = str(value)
            short = text if len(text) <= MAX_SHOWN else f"{text[: MAX_SHOWN - 4]} ..."
            yield f"{above}{key}", short


def html_table(title: str, rows: Rows) -> str:
    """A table with a caption, a row a line; texts are shown as texts."""
    lines = (
        f'<tr><th scope="row" style="text-align: left">{html.escape(key)}</th>'
        f'<td style="text-align: left">{html.escape(value)}</td></tr>'
        for key, value in rows
    )
    return f"<table><caption>{html.escape(title)}</caption>{''.join(lines)}</table>"
