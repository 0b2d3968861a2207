"""When the shapes of a picture are: a dot on the path for each, with its time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from viscodesign.report.charts.shapes import time_labels
from viscodesign.report.charts.tip_path import time_range
from viscodesign.report.layout.label_placement import POINTS_PER_INCH, Box, Label, place_labels
from viscodesign.report.layout.look import look
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import rows_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes

TIME_LETTERS = 7.0
"""Of the times [pt]."""
PATH_POINTS, PATH_PEN = 120, 2.0
"""Points of the path that times keep clear of, and the width of its pen [pt]."""


def draw_instants(axes: Axes, trajectory: Trajectory, rows: np.ndarray) -> None:
    """Name the times of some rows where the tip then is; limits and place of the axes are set."""
    tips = 1e3 * rows_at(trajectory.tip, rows)[:, :2]
    norm = np.clip((trajectory.time[rows] - time_range(trajectory)[0]) / _span(trajectory), 0, 1)
    axes.scatter(
        tips[:, 0], tips[:, 1], s=11, c=look().sequential(norm), edgecolors=look().ink,
        linewidths=0.6, zorder=6.5,
    )  # fmt: skip
    side, points = _fractions(axes, tips)
    words = [label.removeprefix("t = ") for label in time_labels(trajectory.time[rows])]
    for label in place_labels(
        points, words, _taken(axes, trajectory), size=TIME_LETTERS, side=side
    ):
        _write(axes, label, side)


def _span(trajectory: Trajectory) -> float:
    start, end = time_range(trajectory)
    return end - start


def _size(axes: Axes) -> np.ndarray:
    """Width and height of axes [inch]."""
    return np.array((axes.bbox.width, axes.bbox.height)) / axes.figure.dpi


def _fractions(axes: Axes, places: np.ndarray) -> tuple[float, list[tuple[float, float]]]:
    """The longer side of the axes [inch], and places (n, 2) in its parts, from below left."""
    size = _size(axes)
    limits = np.array([axes.get_xlim(), axes.get_ylim()])
    parts = (places - limits[:, 0]) / (limits[:, 1] - limits[:, 0]) * size / size.max()
    return float(size.max()), [(float(x), float(y)) for x, y in parts]


def _taken(axes: Axes, trajectory: Trajectory) -> list[Box]:
    """What times are not to hide: the path, and all that is beside the axes."""
    some = np.unique(np.linspace(0, len(trajectory.time) - 1, PATH_POINTS).round().astype(int))
    side, path = _fractions(axes, 1e3 * rows_at(trajectory.tip, some)[:, :2])
    across, up = _size(axes) / side
    pen = PATH_PEN / POINTS_PER_INCH / side
    beside = [Box(across, -9.0, 9.0, 9.0), Box(-9.0, up, 9.0, 9.0)]
    return [*beside, *(Box(x - pen, y - pen, x + pen, y + pen) for x, y in path)]


def _write(axes: Axes, label: Label, side: float) -> None:
    """A time beside its dot, with a line to it where it is far; lengths over the longer side."""
    width, height = _size(axes) / side
    if label.step > 0:
        ends = (
            [label.point[0] / width, label.x / width],
            [label.point[1] / height, label.y / height],
        )
        axes.plot(
            *ends, transform=axes.transAxes, color=look().grey, lw=0.6, zorder=6, clip_on=False
        )
    axes.text(
        label.x / width, label.y / height, label.text, transform=axes.transAxes,
        fontsize=TIME_LETTERS, ha=label.across, va=label.upright, color=look().text, zorder=7,
        bbox={"facecolor": look().ground, "edgecolor": "none", "alpha": 0.7, "pad": 0.3},
    )  # fmt: skip
