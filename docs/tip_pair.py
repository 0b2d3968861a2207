"""Two paths of one tip in one picture."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign import Trajectory
from viscodesign.report.charts.tip_path import travelled
from viscodesign.report.layout.label_placement import (
    DIRECTIONS,
    DISTANCES,
    POINTS_PER_INCH,
    Box,
    text_box,
)
from viscodesign.report.layout.look import PLAIN
from viscodesign.report.layout.style import axes_at, picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIDE = 3.1
"""Length of the axes [inch]."""
LEFT, BOTTOM, ROOM = 0.62, 0.5, 0.15
SIZE = 9.0
"""Font size of the labels [pt]."""
MARGIN = 0.16
"""Free space around the paths, as a fraction of their extent."""
OBSTACLES = 80
"""Points of a path that labels keep away from."""
OBSTACLE_HALF = 0.01
"""Half the size of such a point, as a fraction of the axes."""


def draw_tips(published: Trajectory, called_for: Trajectory, path: Path) -> None:
    """Both paths in equal axes [mm], z downwards, each with its name beside it."""
    paths = [1e3 * run.tip[:, :2] for run in (published, called_for)]
    low, high = _limits(paths)
    with picture(path, LEFT + SIDE + ROOM, BOTTOM + SIDE + ROOM) as made:
        axes = axes_at(made, LEFT, BOTTOM, SIDE, SIDE)
        axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]))
        axes.set(xlabel="x of the tip [mm]", ylabel="z of the tip [mm], down from the clamp")
        axes.plot(*paths[0].T, color=PLAIN.ink, lw=1.2, ls=(0, (4, 1.5)))
        axes.plot(*paths[1].T, color=PLAIN.accent, lw=1.8)
        for points, colour in zip(paths, (PLAIN.ink, PLAIN.accent), strict=True):
            axes.plot(*points[0], marker="o", mfc="white", mec=colour, ms=6)
            _draw_heads(axes, points, colour, float(high[0] - low[0]))
        _name(axes, paths, low, high)


def _limits(paths: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Corners (x, z) of a square about all paths."""
    points = np.concatenate(paths)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    half = (0.5 + MARGIN) * float(np.max(np.ptp(points, axis=0)))
    return middle - half, middle + half


def _draw_heads(axes: Axes, points: np.ndarray, colour: str, side: float) -> None:
    """Two arrow heads that show the direction."""
    way = travelled(points)
    if way[-1] < 0.1 * side:
        return
    for target in (0.25 * way[-1], 0.7 * way[-1]):
        end, start = (
            [float(np.interp(at, way, points[:, i])) for i in (0, 1)]
            for at in (target, target - 0.01 * side)
        )
        axes.annotate(
            "", xy=end, xytext=start,
            arrowprops={"arrowstyle": "-|>", "color": colour, "mutation_scale": 11, "lw": 0},
        )  # fmt: skip


def _name(axes: Axes, paths: list[np.ndarray], low: np.ndarray, high: np.ndarray) -> None:
    """Label both paths and their start where the labels hide least."""
    first, second = (_inside(points, low, high) for points in paths)
    taken = [_around(x, y, OBSTACLE_HALF) for points in (first, second) for x, y in _some(points)]
    for text, colour, own, other in (
        ("called for", PLAIN.accent, _some(second), first),
        ("published model", PLAIN.ink, _some(first), second),
        ("start", PLAIN.ink, first[:1], first[-1:]),
    ):
        chosen = min(_choices(text, own), key=lambda c: _cost(c, other, taken))
        taken.append(_grown(chosen.box, 2 * OBSTACLE_HALF))
        axes.annotate(
            text, xy=chosen.anchor, xytext=chosen.place, xycoords="axes fraction",
            textcoords="axes fraction", ha=chosen.across, va=chosen.upright, fontsize=SIZE,
            color=colour,
            arrowprops={"arrowstyle": "-", "lw": 0.6, "color": colour} if chosen.step else None,
        )  # fmt: skip


@dataclass(frozen=True)
class Choice:
    """One place for a name, relative to the axes."""

    anchor: tuple[float, float]
    place: tuple[float, float]
    across: str
    upright: str
    step: int
    """Which of the distances; above the first a line leads from the path to the name."""
    box: Box


def _choices(text: str, anchors: np.ndarray) -> Iterator[Choice]:
    for (x, y), (step, far), (u, v) in itertools.product(
        anchors, enumerate(DISTANCES[:4]), DIRECTIONS
    ):
        place = (x + u * far / POINTS_PER_INCH / SIDE, y + v * far / POINTS_PER_INCH / SIDE)
        across = "center" if u == 0 else "left" if u > 0 else "right"
        upright = "center" if abs(v) < 1 else "bottom" if v > 0 else "top"
        box = text_box(text, place, across, upright, SIZE, SIDE)
        yield Choice((float(x), float(y)), place, across, upright, step, box)


def _cost(choice: Choice, other: np.ndarray, taken: list[Box]) -> float:
    """To hide something is worst, then a name that might be the other path's."""
    hidden = choice.box.outside() + sum(choice.box.overlap(box) for box in taken)
    gap = _gap(choice.anchor, other)
    way = np.linspace(choice.anchor, choice.place, 12)[2:]
    crossed = min(_gap(point, other) for point in way) < 1.5 * OBSTACLE_HALF
    return 1e3 * hidden + 0.1 * choice.step + 0.3 * crossed + 0.6 * (gap < 3 * OBSTACLE_HALF) - gap


def _gap(point: Sequence[float], path: np.ndarray) -> float:
    return float(np.min(np.hypot(path[:, 0] - point[0], path[:, 1] - point[1])))


def _around(x: float, y: float, half: float) -> Box:
    return Box(x - half, y - half, x + half, y + half)


def _grown(box: Box, by: float) -> Box:
    return Box(box.left - by, box.bottom - by, box.right + by, box.top + by)


def _some(points: np.ndarray) -> np.ndarray:
    """Points at equal distances along a path, as many as labels keep away from."""
    way = travelled(points)
    even = np.linspace(0.0, way[-1], OBSTACLES)
    return np.column_stack([np.interp(even, way, points[:, i]) for i in (0, 1)])


def _inside(points: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Relative to the axes, upwards."""
    parts = (points - low) / (high - low)
    return np.column_stack((parts[:, 0], 1 - parts[:, 1]))
