"""The path of the tip as a line coloured by time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection

from viscodesign.report.layout.downsampling import stretches
from viscodesign.report.layout.look import look
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MAX_PIECES = 1500
"""Pieces of one colour that a long path is drawn in."""
MANY_ROUNDS = 8
"""From this number of rounds on, a finer pen keeps them apart."""


def draw_path(axes: Axes, trajectory: Trajectory, size: float = 1.0) -> LineCollection:
    """Draw the path [mm] into axes whose limits are set, with direction, start and end.

    Of a long run some stretches stand for the whole.
    ``size`` is that of the marks, 1 as usual.
    """
    parts = stretches(trajectory.tip[:, :2])
    stride = -(-sum(part.stop - part.start for part in parts) // MAX_PIECES)
    starts = [
        slice(k, min(k + stride + 1, part.stop))
        for part in parts
        for k in range(part.start, part.stop - 1, stride)
    ]
    points = trajectory.tip[parts[-1], :2] * 1e3
    extent = np.subtract(*reversed([corner[:2] for corner in extremes(trajectory.tip)]))
    way = sum(travelled(trajectory.tip[part, :2])[-1] for part in parts)
    rounds = way / max(float(np.sum(extent)), 1e-300)
    lines = LineCollection(
        [trajectory.tip[rows, :2] * 1e3 for rows in starts],
        cmap=look().sequential,
        linewidths=2.0 if rounds < MANY_ROUNDS else 1.0,
        capstyle="round",
        zorder=4,
    )
    lines.set_array(np.array([trajectory.time[rows].mean() for rows in starts]))
    lines.set_clim(*time_range(trajectory))
    axes.add_collection(lines)
    _draw_arrows(axes, points, size)
    common: dict[str, Any] = {"ls": "none", "mec": look().ink, "zorder": 6}
    # Of different sizes, so that both are seen where they are one place.
    axes.plot(
        *(trajectory.tip[0, :2] * 1e3),
        marker="o",
        mfc=look().ground,
        ms=8 * size,
        label="start",
        **common,
    )
    axes.plot(*points[-1], marker="s", mfc=look().ink, ms=3.5 * size, label="end", **common)
    return lines


def time_range(trajectory: Trajectory) -> tuple[float, float]:
    """First and last time [s], never the same."""
    start, end = float(trajectory.time[0]), float(trajectory.time[-1])
    return start, (end if end > start else start + 1.0)


def travelled(points: np.ndarray) -> np.ndarray:
    """Length of the path up to each point."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def _draw_arrows(axes: Axes, points: np.ndarray, size: float) -> None:
    """Arrow heads at equal distances along the path show its direction."""
    way = travelled(points)
    side = abs(float(np.subtract(*axes.get_ylim())))
    if way[-1] < 0.08 * side:
        return
    # A periodic run retraces its path: heads on its last round alone stay legible.
    extent = float(np.sum(np.ptp(points, axis=0))) * 2.0
    first = max(0.0, way[-1] - extent)
    for target in first + (way[-1] - first) * np.array([0.2, 0.5, 0.8]):
        end, start = (
            [float(np.interp(at, way, points[:, i])) for i in (0, 1)]
            for at in (target, target - 0.003 * side)
        )
        axes.annotate(
            "", xy=(end[0], end[1]), xytext=(start[0], start[1]), zorder=5,
            arrowprops={
                "arrowstyle": "-|>", "color": look().ink, "mutation_scale": 13 * size, "lw": 0,
            },
        )  # fmt: skip
