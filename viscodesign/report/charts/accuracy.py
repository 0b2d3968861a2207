"""`accuracy.png`: tip error against solve time, the Pareto front and the recommendation."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.charts.accuracy_axes import Window, draw_axes, percent_words, window_of
from viscodesign.report.charts.accuracy_key import PointMarks, draw_key, key_height
from viscodesign.report.charts.accuracy_labels import draw_labels, write_note
from viscodesign.report.layout.label_placement import HALF_LINE, Box
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.accuracy_points import Point
from viscodesign.results.accuracy_study import AccuracyStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class AccuracyLayout:
    """Lengths of the picture [inch].

    The key goes below where it would leave a plane less than the least size.
    """

    left: float = 0.78
    bottom: float = 0.55
    size: float = 5.0
    key_width: float = 2.25
    least_size: float = 3.4
    margin: float = 0.12


IN = AccuracyLayout()


def draw_accuracy(study: AccuracyStudy, path: Path) -> None:
    """Log-log; every point by its model and solver, the front, and the recommendation."""
    window = window_of(study)
    width = look().across(IN.left + IN.size + IN.key_width)
    is_beside = width - IN.left - IN.key_width >= IN.least_size
    size = width - IN.left - (IN.key_width if is_beside else IN.margin)
    below = 0.0 if is_beside else key_height(study)
    bottom = IN.bottom + below
    key = (IN.left + size + 0.12, bottom + size) if is_beside else (IN.left, below)
    with picture(path, width, bottom + size + title_room()) as made:
        axes = axes_at(made, IN.left, bottom, size, size)
        draw_axes(axes, window)
        if size < IN.least_size:
            axes.set_ylabel("largest tip error / length")
        occupied = [*_draw_bounds(axes, study, window, size), *_draw_front(axes, study, window)]
        _draw_branches(axes, study)
        _draw_points(axes, study)
        draw_labels(axes, study, window, occupied, size)
        draw_key(made, study, *key)
        words = "tip error against solve time"
        if study.status == "interrupted":
            words += " (interrupted: incomplete)"
        draw_title(made, f"{shown(study.name, 40)}: {words}", 0.1)


def _draw_bounds(axes: Axes, study: AccuracyStudy, window: Window, size: float) -> list[Box]:
    """The requested error and the error of the reference; returns the space of their words."""
    axes.axhline(study.requested_rel, color=look().accent, lw=1.2, ls=(0, (5, 2)), zorder=2)
    up = window.up(study.requested_rel)
    points = [window.place(point) for point in study.points]
    requested = f"requested: {percent_words(study.requested_rel)}"
    boxes = [
        write_note(axes, requested, up, points, look().warning, size),
        Box(0, up - HALF_LINE, 1, up + HALF_LINE, faint=True),
    ]
    found = study.reference
    least = 0.0 if found is None else found.smallest_error_m / study.length
    if least > 10**window.bottom:
        axes.axhspan(10**window.bottom, least, color=look().body, lw=0, zorder=0)
        words = "upper bounds (error of the reference)"
        boxes.append(write_note(axes, words, 0.004, points, look().note, size))
    return boxes


def _draw_front(axes: Axes, study: AccuracyStudy, window: Window) -> list[Box]:
    """A staircase: nothing was reached below and to the left of it."""
    front = study.front
    times = [front[0].solve_s, *(p.solve_s for p in front[1:]), 10**window.right]
    errors = [10**window.top, *(p.tip_error_rel for p in front)]
    x, y = [times[0]], [errors[0]]
    for k, error in enumerate(errors[1:]):
        x += [times[k], times[k + 1]]
        y += [error, error]
    axes.plot(x, y, color=look().faint, lw=2.4, zorder=1.5, solid_joinstyle="miter")
    places = [(window.across(t), window.up(e)) for t, e in zip(x, y, strict=True)]
    return [_stripe(a, b) for a, b in itertools.pairwise(places)]


def _stripe(a: tuple[float, float], b: tuple[float, float]) -> Box:
    half = HALF_LINE
    x, y = sorted((a[0], b[0])), sorted((a[1], b[1]))
    return Box(x[0] - half, y[0] - half, x[1] + half, y[1] + half)


def _draw_branches(axes: Axes, study: AccuracyStudy) -> None:
    """Join points that differ in tolerance only."""
    marks = PointMarks(study)
    branches: dict[tuple[str, int, str], list[Point]] = {}
    for point in study.points:
        branches.setdefault((point.model, point.edges, point.solver), []).append(point)
    for points in branches.values():
        ordered = sorted(points, key=lambda point: -point.tolerance)
        axes.plot(
            [p.solve_s for p in ordered], [p.tip_error_rel for p in ordered],
            color=marks.colour(ordered[0]), lw=0.6, alpha=0.45, zorder=2,
        )  # fmt: skip


def _draw_points(axes: Axes, study: AccuracyStudy) -> None:
    """Filled marks on the front, hollow ones elsewhere, a ring around the recommendation."""
    marks = PointMarks(study)
    for point in study.points:
        colour = marks.colour(point)
        axes.plot(
            point.solve_s, point.tip_error_rel, marker=marks.marker(point),
            ms=marks.size(point), mec=colour, mew=1.0, ls="none",
            mfc=look().ground if point.dominated else colour, zorder=3 if point.dominated else 4,
        )  # fmt: skip
    best = study.recommended
    if best is not None:
        axes.plot(
            best.solve_s, best.tip_error_rel, marker="o", ms=14, mec=look().accent, mew=1.8,
            mfc="none", ls="none", zorder=5,
        )  # fmt: skip
