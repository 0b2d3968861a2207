"""`tip.png`: the path of the tip, coloured by time, and the actuator at several times."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.charts.coefficient_band import band_corners, draw_band
from viscodesign.report.charts.tip_instants import draw_instants
from viscodesign.report.charts.tip_path import draw_path, time_range
from viscodesign.report.ground_outline import feet, ground_outline, ground_words, lies_beyond
from viscodesign.report.layout.bellow_blocks import body_widths
from viscodesign.report.layout.downsampling import MAX_PLOTTED_ROWS
from viscodesign.report.layout.look import look
from viscodesign.report.layout.snapshots import clamp_strokes, outline, spread_instants
from viscodesign.report.layout.style import (
    NOTE_ROOM,
    TIME_DIGITS,
    Target,
    axes_at,
    draw_note,
    head,
    head_room,
    picture,
)
from viscodesign.report.page.sketch_numbers import ground_of
from viscodesign.results.channels import channel
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes, rows_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from viscodesign.scene.ground import Ground

MAX_INSTANTS = 7
LARGEST_AXES = np.array((4.6, 4.8))
SMALLEST_AXES = np.array((3.2, 2.0))
"""Size of the axes, x and z [inch]."""


@dataclass(frozen=True)
class TipLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.62
    bottom: float = 0.5
    right: float = 0.85
    """Room beside the axes, where the colour bar stands."""
    zoom_gap: float = 0.7
    """Before the enlarged path."""
    zoom: float = 2.1
    """Side of the enlarged path."""
    zoom_legend: float = 0.5
    """The legend, where that is below."""
    legend_line: float = 0.2
    least_beside: float = 6.0
    """Least width that was asked for with the enlarged path on the right; else it is below."""


IN = TipLayout()
ZOOM_RANGE = (1e-3, 0.25)
"""A path whose extent is in this range, relative to that of the bodies, is also drawn enlarged."""


def draw_tip(trajectory: Trajectory, path: Target) -> None:
    """Equal axes in mm, the clamp at the top, z downwards as the actuator hangs."""
    instants = spread_instants(trajectory, MAX_INSTANTS)
    rows = trajectory.shape_rows[instants]
    bodies = outline(trajectory.shape[instants], body_widths(trajectory)) * 1e3
    zoomed = _is_small(trajectory, bodies)
    asked = look().width
    is_narrow = asked is not None and asked < IN.least_beside
    below = zoomed and is_narrow
    beside = IN.zoom_gap + IN.zoom if zoomed and not below else 0.0
    largest, smallest = LARGEST_AXES, SMALLEST_AXES
    if asked is not None:
        room = asked - IN.left - IN.right - beside
        largest, smallest = np.array((room, LARGEST_AXES[1])), np.array((room, SMALLEST_AXES[1]))
    low, high = _limits(trajectory, bodies, largest, smallest)
    width, height = np.maximum((high - low) * _scale(low, high, largest), smallest).tolist()
    ground = ground_of(trajectory)
    foot = 0.0 if ground is None else NOTE_ROOM
    base = (
        foot
        + IN.bottom
        + (IN.bottom + IN.zoom + IN.zoom_legend if below else IN.legend_line * is_narrow)
    )
    right = IN.left + width + beside
    full = right + IN.right
    with picture(path, full, base + height + head_room(trajectory, full)) as made:
        axes = axes_at(made, IN.left, base, width, height)
        axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]))
        axes.set(xlabel=channel("x").label, ylabel=f"{channel('z').label}, down from the clamp")
        _draw_clamp(axes, trajectory)
        if ground is not None:
            _draw_ground(axes, ground, rows_at(trajectory.tip, rows)[:, :2])
            draw_note(made, f"dashed: {ground_words(ground)}", IN.left)
        # What touches the ground is the axis: no outline is drawn across it.
        if ground is None or not lies_beyond(ground, 1e-3 * bodies, trajectory.length):
            _draw_outlines(axes, bodies)
        _draw_axes(axes, trajectory, instants)
        draw_band(axes, trajectory)
        lines = draw_path(axes, trajectory, 0.4 if zoomed else 1.0)
        if zoomed:
            side = min(IN.zoom, width)
            axes = axes_at(
                made, IN.left if below else right - IN.zoom, foot + IN.bottom, side, side
            )
            _draw_enlarged(axes, trajectory)
        draw_instants(axes, trajectory, rows)
        legend = IN.left + IN.zoom if below else right
        level = IN.bottom + IN.zoom + 0.25 * below + 0.05 if zoomed else 0.07
        _draw_legend(made, axes, legend, foot + level)
        bar = made.colorbar(lines, cax=axes_at(made, right + 0.15, base, 0.12, height))
        bar.set_label(channel("time").label)
        bar.outline.set_visible(False)
        bar.ax.ticklabel_format(axis="y", scilimits=TIME_DIGITS)
        if len(trajectory.time) == 1:
            bar.set_ticks([float(trajectory.time[0])])
        thinned = len(trajectory.time) > MAX_PLOTTED_ROWS
        told = f"tip path{' (excerpts)' if thinned else ''}"
        if trajectory.uncertainty is not None and not trajectory.uncertainty.is_still:
            told += ", 95 % band"
        head(made, trajectory, told, IN.left)


def _is_small(trajectory: Trajectory, bodies: np.ndarray) -> bool:
    low, high = extremes(trajectory.tip)
    extent = 1e3 * float(np.max((high - low)[:2]))
    drawn = float(np.max(np.ptp(bodies.reshape(-1, 2), axis=0)))
    return ZOOM_RANGE[0] < extent / drawn < ZOOM_RANGE[1]


def _draw_enlarged(axes: Axes, trajectory: Trajectory) -> None:
    low, high = (1e3 * corner[:2] for corner in extremes(trajectory.tip))
    middle, half = (low + high) / 2, 0.6 * float(np.max(high - low))
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] + half, middle[1] - half))
    axes.locator_params(nbins=5)
    axes.ticklabel_format(style="plain", useOffset=False)
    axes.set(xlabel=channel("x").label)
    axes.set_title("enlarged", loc="left", fontsize=9)
    draw_band(axes, trajectory)
    draw_path(axes, trajectory)


def _draw_legend(made: Figure, axes: Axes, right: float, bottom: float) -> None:
    width, height = made.get_size_inches()
    made.legend(
        *axes.get_legend_handles_labels(), loc="lower right", ncols=2, handletextpad=0.1,
        columnspacing=1.0, borderaxespad=0,
        bbox_to_anchor=((right + 0.05) / width, bottom / height),
    )  # fmt: skip


def _limits(
    trajectory: Trajectory, bodies: np.ndarray, largest: np.ndarray, smallest: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Corners (x, z) [mm] of a frame about all that is drawn, of a sensible shape."""
    half, hatch = _clamp_size(trajectory)
    corners = [1e3 * corner[None, :2] for corner in extremes(trajectory.tip)]
    points = np.concatenate([bodies.reshape(-1, 2), *corners, band_corners(trajectory)])
    low = np.minimum(points.min(axis=0), (-half, -hatch))
    high = np.maximum(points.max(axis=0), (half, 0.0))
    margin = 0.04 * float(np.max(high - low))
    low, high = low - margin, high + margin
    short = np.maximum(smallest / _scale(low, high, largest) - (high - low), 0.0)
    return low - short / 2, high + short / 2


def _scale(low: np.ndarray, high: np.ndarray, largest: np.ndarray) -> float:
    """Inches for a millimetre."""
    return float(np.min(largest / (high - low)))


def _clamp_size(trajectory: Trajectory) -> tuple[float, float]:
    """Half width and height of the hatched clamp [mm]."""
    return 0.75e3 * trajectory.width, 0.15e3 * trajectory.width


def _draw_clamp(axes: Axes, trajectory: Trajectory) -> None:
    half, hatch = _clamp_size(trajectory)
    strokes = clamp_strokes(half, hatch, 12)
    axes.add_collection(LineCollection(list(strokes), colors=look().ink, linewidths=0.7, zorder=3))
    axes.plot([-half, half], [0, 0], color=look().ink, lw=1.5, solid_capstyle="butt", zorder=3)


def _draw_ground(axes: Axes, ground: Ground, tips: np.ndarray) -> None:
    """The line that may be touched, as far as it is in the frame, and the feet at ``tips`` (n, 2)
    [m] that touch it."""
    (low, high), (top, bottom) = axes.get_xlim(), axes.get_ylim()
    reach = 1e-3 * (abs(low) + abs(high) + abs(top) + abs(bottom))
    line = 1e3 * ground_outline(ground, reach)
    axes.plot(*line.T, color=look().accent, lw=1.2, ls=(0, (6, 2)), zorder=2.5)
    rings = list(1e3 * feet(ground, tips))
    axes.add_collection(LineCollection(rings, colors=look().accent, linewidths=0.8, zorder=3.5))


def _draw_outlines(axes: Axes, bodies: np.ndarray) -> None:
    sides = PolyCollection(
        list(bodies), facecolors=look().body, edgecolors=look().faint, linewidths=0.6, alpha=0.5
    )
    axes.add_collection(sides)


def _draw_axes(axes: Axes, trajectory: Trajectory, instants: np.ndarray) -> None:
    """The axis of the actuator at some instants, in the colours of their times."""
    bent = LineCollection(
        list(trajectory.shape[instants] * 1e3), cmap=look().sequential, linewidths=0.8, zorder=3
    )
    bent.set_array(trajectory.time[trajectory.shape_rows[instants]])
    bent.set_clim(*time_range(trajectory))
    axes.add_collection(bent)
