"""Words on the plane of `accuracy.png`, placed so that they hide few points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from viscodesign.report.charts.accuracy_axes import Window, percent_words, time_words
from viscodesign.report.layout.label_placement import Box, place_labels, text_box
from viscodesign.report.layout.look import look
from viscodesign.results.accuracy_points import Point, spread, tolerance_words
from viscodesign.results.accuracy_study import AccuracyStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MAX_LABELS = 9
LABEL_LETTERS, NOTE_LETTERS = 7.0, 7.5
"""Font sizes [pt]."""
NOTE_ENDS = (0.985, 0.85, 0.7, 0.55, 0.4, 0.25)
"""Where notes on a line may end, as fractions of the plane."""
HALF_MARK_SHARE = 0.011
"""Half the space of a mark, as a fraction of the plane."""


def draw_labels(
    axes: Axes, study: AccuracyStudy, window: Window, occupied: list[Box], side: float
) -> None:
    """Label the points of the front by their settings, the recommended one in bold."""
    best = study.recommended
    labelled = spread(study.front, MAX_LABELS)
    if best is not None:
        labelled = [best, *(point for point in labelled if point != best)]
    others = [window.place(point) for point in study.points if point not in labelled]
    room = [*occupied, *(mark_box(place) for place in others)]
    texts = [_label(study, point, point == best) for point in labelled]
    labels = place_labels(
        [window.place(point) for point in labelled], texts, room, size=LABEL_LETTERS, side=side
    )
    for point, label in zip(labelled, labels, strict=True):
        if label.step > 0:
            ends = ([label.point[0], label.x], [label.point[1], label.y])
            axes.plot(*ends, color=look().grey, lw=0.6, zorder=2.5, transform=axes.transAxes)
        is_best = point == best
        axes.text(
            label.x, label.y, label.text, ha=label.across, va=label.upright, size=LABEL_LETTERS,
            zorder=7, linespacing=1.1, transform=axes.transAxes,
            color=look().warning if is_best else look().ink,
            weight="bold" if is_best else "normal",
            bbox={"facecolor": look().ground, "edgecolor": "none", "alpha": 0.7, "pad": 0.3},
        )  # fmt: skip


def _label(study: AccuracyStudy, point: Point, is_best: bool) -> str:
    parts = [] if point.is_exact_in_space else [f"{point.edges} edge{'s' * (point.edges != 1)}"]
    if not point.is_stepless:
        parts.append(f"tol {tolerance_words(point.tolerance)}")
    setting = ", ".join(parts) or "no time steps"
    if not is_best:
        return setting
    solver = "" if point.is_stepless else f"{point.solver}, "
    return (
        f"recommended for {percent_words(study.requested_rel)}:\n"
        f"{point.model}, {solver}{setting}, {time_words(float(f'{point.solve_s:.2g}'))}"
    )


def write_note(
    axes: Axes,
    words: str,
    y: float,
    points: Sequence[tuple[float, float]],
    colour: str,
    side: float,
) -> Box:
    """Words on a horizontal line, where they hide fewest points; returns their space.

    ``side``: of the plane [inch].
    """
    boxes = [
        text_box(words, (x, y + 0.004), "right", "bottom", NOTE_LETTERS, side) for x in NOTE_ENDS
    ]
    boxes = [box for box in boxes if box.left > 0.0] or boxes[:1]
    hidden = [sum(mark_box(point).overlap(box) for point in points) for box in boxes]
    box = boxes[hidden.index(min(hidden))]
    axes.text(
        box.right, y + 0.004, words, ha="right", va="bottom", size=NOTE_LETTERS, color=colour,
        zorder=6, transform=axes.transAxes,
    )  # fmt: skip
    return box


def mark_box(place: tuple[float, float]) -> Box:
    """The space of a mark."""
    x, y = place
    return Box(x - HALF_MARK_SHARE, y - HALF_MARK_SHARE, x + HALF_MARK_SHARE, y + HALF_MARK_SHARE)
