"""`tip.png`: the tip's path with time as colour, and the actuator at several instants."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from viscodesign.report.instants import clamp_strokes, outlines, spread_instants
from viscodesign.report.style import FAINT, INK, SEQUENTIAL, axes_at, head, head_room, picture
from viscodesign.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SHOWN = 7
LARGEST = np.array((4.6, 4.8))
SMALLEST = np.array((3.2, 2.0))
"""Size of the axes, x and z [inch]."""
LEFT, BOTTOM, RIGHT = 0.62, 0.75, 0.85
"""Room around the axes [inch]; the colour bar stands to their right."""
PIECES = 1500
"""Pieces of one colour that a long path is drawn in."""


def draw_tip(trajectory: Trajectory, path: Path) -> None:
    """Equal axes in mm, the clamp at the top, z downwards as the actuator hangs."""
    instants = spread_instants(trajectory, SHOWN)
    bodies = outlines(trajectory.shape[instants], trajectory.width) * 1e3
    low, high = _limits(trajectory, bodies)
    size = np.maximum((high - low) * _scale(low, high), SMALLEST)
    width, height = size
    full = LEFT + width + RIGHT
    with picture(path, full, BOTTOM + height + head_room(trajectory, full)) as made:
        axes = axes_at(made, LEFT, BOTTOM, width, height)
        axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]))
        axes.set(xlabel="x [mm]", ylabel="z [mm], down from the clamp")
        _draw_clamp(axes, trajectory)
        _draw_bodies(axes, trajectory, instants, bodies)
        lines = _draw_path(axes, trajectory)
        _draw_ends(made, axes, trajectory)
        bar = made.colorbar(lines, cax=axes_at(made, LEFT + width + 0.15, BOTTOM, 0.12, height))
        bar.set_label("time [s]")
        bar.outline.set_visible(False)
        head(made, trajectory, "path of the tip", LEFT)


def _limits(trajectory: Trajectory, bodies: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners (x, z) [mm] of a frame about all that is drawn, of a sensible shape."""
    half, hatch = _clamp_size(trajectory)
    points = np.concatenate([bodies.reshape(-1, 2), trajectory.tip[:, :2] * 1e3])
    low = np.minimum(points.min(axis=0), (-half, -hatch))
    high = np.maximum(points.max(axis=0), (half, 0.0))
    margin = 0.04 * float(np.max(high - low))
    low, high = low - margin, high + margin
    short = np.maximum(SMALLEST / _scale(low, high) - (high - low), 0.0)
    return low - short / 2, high + short / 2


def _scale(low: np.ndarray, high: np.ndarray) -> float:
    """Inches for a millimetre."""
    return float(np.min(LARGEST / (high - low)))


def _clamp_size(trajectory: Trajectory) -> tuple[float, float]:
    """Half width and height of the hatched clamp [mm]."""
    return 0.75e3 * trajectory.width, 0.15e3 * trajectory.width


def _draw_clamp(axes: Axes, trajectory: Trajectory) -> None:
    half, hatch = _clamp_size(trajectory)
    strokes = clamp_strokes(half, hatch, 12)
    axes.add_collection(LineCollection(list(strokes), colors=INK, linewidths=0.7, zorder=3))
    axes.plot([-half, half], [0, 0], color=INK, lw=1.5, solid_capstyle="butt", zorder=3)


def _draw_bodies(
    axes: Axes, trajectory: Trajectory, instants: np.ndarray, bodies: np.ndarray
) -> None:
    """Outlines in a light grey, axes in the colour of their time."""
    axes.add_collection(
        PolyCollection(
            list(bodies), facecolors="#eeeeee", edgecolors=FAINT, linewidths=0.6, alpha=0.5
        )
    )
    bent = LineCollection(
        list(trajectory.shape[instants] * 1e3), cmap=SEQUENTIAL, linewidths=0.8, zorder=3
    )
    bent.set_array(trajectory.time[instants])
    bent.set_clim(*_time_range(trajectory))
    axes.add_collection(bent)


def _time_range(trajectory: Trajectory) -> tuple[float, float]:
    start, end = float(trajectory.time[0]), float(trajectory.time[-1])
    return start, (end if end > start else start + 1.0)


def _draw_path(axes: Axes, trajectory: Trajectory) -> LineCollection:
    points, time = trajectory.tip[:, :2] * 1e3, trajectory.time
    stride = -(-len(points) // PIECES)
    starts = range(0, len(points) - 1, stride)
    pieces = [points[k : k + stride + 1] for k in starts]
    # A path of many rounds needs a finer pen.
    rounds = _travelled(points)[-1] / max(float(np.sum(np.ptp(points, axis=0))), 1e-300)
    lines = LineCollection(
        pieces, cmap=SEQUENTIAL, linewidths=2.0 if rounds < 8 else 1.0, capstyle="round", zorder=4
    )
    lines.set_array(np.array([time[k : k + stride + 1].mean() for k in starts]))
    lines.set_clim(*_time_range(trajectory))
    axes.add_collection(lines)
    _draw_arrows(axes, points, 0.02e3 * trajectory.length)
    return lines


def _travelled(points: np.ndarray) -> np.ndarray:
    """Length of the path up to each point."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def _draw_arrows(axes: Axes, points: np.ndarray, smallest: float) -> None:
    """Heads along the path at equal distances tell its direction."""
    travelled = _travelled(points)
    if travelled[-1] < 5 * smallest:
        return
    # A periodic run retraces its path: heads on its last round alone stay legible.
    extent = float(np.sum(np.ptp(points, axis=0))) * 2.0
    first = max(0.0, travelled[-1] - extent)
    for target in first + (travelled[-1] - first) * np.array([0.2, 0.5, 0.8]):
        end, start = (
            [float(np.interp(at, travelled, points[:, i])) for i in (0, 1)]
            for at in (target, target - 0.2 * smallest)
        )
        axes.annotate(
            "", xy=(end[0], end[1]), xytext=(start[0], start[1]), zorder=5,
            arrowprops={"arrowstyle": "-|>", "color": INK, "mutation_scale": 11, "lw": 0},
        )  # fmt: skip


def _draw_ends(made: Figure, axes: Axes, trajectory: Trajectory) -> None:
    """Start and end, told apart even where they are one place; their names below the axes."""
    points = trajectory.tip[[0, -1], :2] * 1e3
    common: dict[str, Any] = {"ls": "none", "mec": INK, "zorder": 6}
    axes.plot(*points[0], marker="o", mfc="white", ms=8, label="start", **common)
    axes.plot(*points[1], marker="s", mfc=INK, ms=3.5, label="end", **common)
    width, height = made.get_size_inches()
    made.legend(
        loc="lower right", ncols=2, handletextpad=0.1, columnspacing=1.0, borderaxespad=0,
        bbox_to_anchor=((width - RIGHT + 0.05) / width, 0.12 / height),
    )  # fmt: skip
