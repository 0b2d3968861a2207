"""`shapes.png`: a filmstrip of the actuator, every bellow coloured by its pressure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize, TwoSlopeNorm

from viscodesign.report.instants import normals, spread_instants
from viscodesign.report.style import DIVERGING, INK, bare, ended_early, picture
from viscodesign.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SHOWN = 8
PER_ROW = 4
GAP = 0.12
"""Part of a section's length left between neighbouring bellows."""
SCALE_BARS_MM = (1, 2, 5, 10, 20, 50, 100, 200, 500)


def draw_shapes(trajectory: Trajectory, path: Path) -> None:
    """Up to eight instants at one scale, time below each, a scale bar and a colour bar."""
    instants = spread_instants(trajectory, SHOWN)
    frames = [_blocks(trajectory, k) for k in instants]
    low, high = _common_box(frames, trajectory)
    columns = min(PER_ROW, len(instants))
    rows = -(-len(instants) // columns)
    cell = 6.2 / columns
    tall = cell * float((high[1] - low[1]) / (high[0] - low[0]))
    with picture(path, 6.8, rows * (tall + 0.25) + 0.3) as made:
        norm = _norm(trajectory)
        height = made.get_figheight()
        for k, (instant, (blocks, values)) in enumerate(zip(instants, frames, strict=True)):
            row, column = divmod(k, columns)
            bottom = 1 - ((row + 1) * (tall + 0.25) + 0.1) / height
            axes = made.add_axes(
                (column * cell / 6.8, bottom + 0.2 / height, cell / 6.8, tall / height)
            )
            _draw_frame(axes, trajectory, instant, blocks, values, norm)
            axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), aspect="equal")
            made.text(
                (column + 0.5) * cell / 6.8, bottom + 0.1 / height,
                f"t = {trajectory.time[instant]:.3g} s", ha="center", va="center", fontsize=9,
            )  # fmt: skip
            if k == 0:
                _scale_bar(axes, low, high)
        bar = made.colorbar(
            ScalarMappable(norm, mpl.colormaps[DIVERGING]),
            cax=made.add_axes((0.93, 0.2, 0.018, 0.6)),
        )
        bar.set_label("bellow pressure [kPa gauge]")
        bar.outline.set_visible(False)
        made.text(0.01, 1.0, f"{trajectory.name}: shapes", va="bottom", fontsize=10)
        ended_early(made, trajectory)


def _blocks(trajectory: Trajectory, instant: int) -> tuple[np.ndarray, np.ndarray]:
    """Quadrangles (B, 4, 2) [mm] beside the axis, and their pressures (B,) [kPa]."""
    axis = trajectory.shape[instant]
    side = normals(axis) * trajectory.width / 2
    arc = trajectory.arc / trajectory.arc[-1] * trajectory.sections
    corners = []
    for name in trajectory.bellows:
        section = int(name[1:]) - 1
        ends = (section + GAP / 2, section + 1 - GAP / 2)
        point = np.array([[np.interp(e, arc, axis[:, i]) for i in (0, 1)] for e in ends])
        out = np.array([[np.interp(e, arc, side[:, i]) for i in (0, 1)] for e in ends])
        sign = 1.0 if name[0] == "R" else -1.0
        near, far = point + 0.08 * sign * out, point + sign * out
        corners.append([near[0], near[1], far[1], far[0]])
    return np.array(corners) * 1e3, trajectory.pressure[instant] / 1e3


def _common_box(
    frames: list[tuple[np.ndarray, np.ndarray]], trajectory: Trajectory
) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate([blocks.reshape(-1, 2) for blocks, _ in frames])
    half = trajectory.width * 1e3 * 0.75
    low = np.minimum(points.min(axis=0), (-half, -0.07 * trajectory.length * 1e3))
    high = np.maximum(points.max(axis=0), (half, 0.0))
    margin = 0.04 * float(np.max(high - low))
    return low - margin, high + margin


def _norm(trajectory: Trajectory) -> Normalize:
    largest = float(np.max(np.abs(trajectory.pressure))) / 1e3 or 1.0
    return TwoSlopeNorm(0.0, -largest, largest)


def _draw_frame(
    axes: Axes,
    trajectory: Trajectory,
    instant: int,
    blocks: np.ndarray,
    values: np.ndarray,
    norm: Normalize,
) -> None:
    shown = PolyCollection(list(blocks), cmap=DIVERGING, norm=norm, edgecolors=INK, linewidths=0.4)
    shown.set_array(values)
    axes.add_collection(shown)
    axes.plot(*(trajectory.shape[instant].T * 1e3), color=INK, lw=1.0)
    half = trajectory.width * 1e3 * 0.7
    axes.plot([-half, half], [0, 0], color=INK, lw=1.6, solid_capstyle="butt")
    ticks = np.linspace(-half, half, 9)
    height = 0.04 * trajectory.length * 1e3
    strokes = [[(t, 0.0), (t + height, -height)] for t in ticks[:-1]]
    axes.add_collection(LineCollection(strokes, colors=INK, linewidths=0.6))
    bare(axes)


def _scale_bar(axes: Axes, low: np.ndarray, high: np.ndarray) -> None:
    span = float(high[0] - low[0])
    fitting = [mm for mm in SCALE_BARS_MM if mm <= 0.35 * span] or [SCALE_BARS_MM[0]]
    length = 20 if 20 in fitting and fitting[-1] <= 50 else fitting[-1]
    x, z = low[0] + 0.04 * span, high[1] - 0.03 * span
    axes.plot([x, x + length], [z, z], color=INK, lw=2.2, solid_capstyle="butt")
    axes.text(x + length / 2, z - 0.02 * span, f"{length} mm", ha="center", va="bottom", fontsize=8)
