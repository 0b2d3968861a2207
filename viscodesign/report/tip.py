"""`tip.png`: the tip's path with time as colour, and the actuator at several instants."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.patches import Polygon, Rectangle

from viscodesign.report.instants import outline, spread_instants
from viscodesign.report.style import FAINT, INK, SEQUENTIAL, ended_early, picture
from viscodesign.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SHOWN = 6


def draw_tip(trajectory: Trajectory, path: Path) -> None:
    """Equal axes in mm, the clamp at the top, z downwards as the actuator hangs."""
    with picture(path, 5.6, 5.2) as made:
        axes = made.add_axes((0.12, 0.11, 0.7, 0.8))
        _draw_bodies(axes, trajectory)
        points = trajectory.tip[:, :2] * 1e3
        _draw_clamp(axes, trajectory)
        bar = _draw_path(axes, trajectory, points)
        axes.set_aspect("equal")
        axes.set_xlabel("x [mm]")
        axes.set_ylabel("z [mm], from the clamp down")
        axes.set_title(f"{trajectory.name}: path of the tip", loc="left")
        _frame(axes, trajectory)
        axes.invert_yaxis()
        made.canvas.draw()
        box = axes.get_position()
        bar_axes = made.add_axes((box.x1 + 0.03, box.y0, 0.022, box.height))
        colorbar = made.colorbar(bar, cax=bar_axes)
        colorbar.set_label("time [s]")
        colorbar.outline.set_visible(False)
        ended_early(made, trajectory)


def _draw_path(axes: Axes, trajectory: Trajectory, points: np.ndarray) -> LineCollection:
    time = trajectory.time
    pieces = np.stack((points[:-1], points[1:]), axis=1)
    lines = LineCollection(list(pieces), cmap=SEQUENTIAL, linewidths=1.8, zorder=4)
    lines.set_array((time[:-1] + time[1:]) / 2 if len(time) > 1 else np.zeros(0))
    lines.set_clim(time[0], time[-1] if len(time) > 1 else time[0] + 1)
    lines.set_capstyle("round")
    axes.add_collection(lines)
    ends: dict[str, Any] = {
        "zorder": 6,
        "linestyle": "none",
        "markeredgecolor": INK,
        "markersize": 6.5,
    }
    axes.plot(*points[0], marker="o", markerfacecolor="white", label="start", **ends)
    axes.plot(*points[-1], marker="s", markerfacecolor="white", label="end", **ends)
    _draw_arrows(axes, points)
    axes.legend(loc="best", handletextpad=0.2, borderaxespad=0.2)
    return lines


def _draw_arrows(axes: Axes, points: np.ndarray) -> None:
    """Heads along the path at equal distances tell its direction."""
    steps = np.hypot(*np.diff(points, axis=0).T) if len(points) > 1 else np.zeros(0)
    travelled = np.concatenate([[0.0], np.cumsum(steps)])
    if travelled[-1] < 1.0:
        return
    # A long periodic run retraces its path: heads on its last part alone stay legible.
    extent = float(np.sum(np.ptp(points, axis=0))) * 2.5
    first = max(0.0, travelled[-1] - extent)
    for target in first + (travelled[-1] - first) * np.array([0.2, 0.5, 0.8]):
        k = int(np.clip(np.searchsorted(travelled, target), 1, len(points) - 1))
        if steps[k - 1] > 0:
            axes.annotate(
                "", xy=points[k], xytext=points[k - 1], zorder=5,
                arrowprops={"arrowstyle": "-|>", "color": INK, "mutation_scale": 11, "lw": 0},
            )  # fmt: skip


def _draw_bodies(axes: Axes, trajectory: Trajectory) -> None:
    for k in spread_instants(trajectory, SHOWN):
        ring = outline(trajectory.shape[k], trajectory.width) * 1e3
        axes.add_patch(
            Polygon(ring, closed=True, facecolor="#f1f1f1", edgecolor=FAINT, lw=0.6, alpha=0.55)
        )
    for k in spread_instants(trajectory, SHOWN):
        axes.plot(*(trajectory.shape[k].T * 1e3), color="#8a8a8a", lw=0.9, zorder=3)


def _draw_clamp(axes: Axes, trajectory: Trajectory) -> None:
    half = trajectory.width * 1e3 * 0.75
    axes.add_patch(
        Rectangle(
            (-half, -6),
            2 * half,
            6,
            facecolor="white",
            edgecolor=INK,
            hatch="/////",
            lw=0,
            zorder=3,
        )
    )
    axes.plot([-half, half], [0, 0], color=INK, lw=1.4, zorder=4)


def _frame(axes: Axes, trajectory: Trajectory) -> None:
    shown = trajectory.shape[spread_instants(trajectory, SHOWN)].reshape(-1, 2)
    everything = np.concatenate([shown, trajectory.tip[:, :2]]) * 1e3
    half = trajectory.width * 1e3 / 2
    low, high = everything.min(axis=0) - half - 4, everything.max(axis=0) + half * 0.4 + 4
    axes.set_xlim(min(low[0], -1.7 * half), max(high[0] + half * 0.6, 1.7 * half))
    axes.set_ylim(min(low[1] + half, -8), high[1])
