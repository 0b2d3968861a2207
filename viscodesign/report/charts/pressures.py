"""`pressures.png`: every bellow's pressure against time, with the inlet's."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import BoundaryNorm, Normalize

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.downsampling import envelope
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import LINE_STYLES
from viscodesign.report.layout.style import (
    TIME_DIGITS,
    Target,
    axes_at,
    head,
    head_room,
    picture,
    shown,
)
from viscodesign.results.channels import channel
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class PressuresLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.68
    bottom: float = 0.5
    panel_width: float = 2.5
    panel_height: float = 3.0
    gap: float = 0.3
    bar_gap: float = 0.15
    right: float = 0.65
    panel_title: float = 0.22
    legend_row: float = 0.2
    legend_column: float = 1.1
    least_width: float = 4.6
    """With both panels side by side."""
    low_panel: float = 1.7
    """Height of a panel where one is above the other."""


IN = PressuresLayout()
MAX_DISCRETE_SECTIONS = 16
"""Up to this number of sections, each has its own field in the colour bar."""


def draw_pressures(trajectory: Trajectory, path: Target) -> None:
    """Two panels, left and right column, kPa gauge; colour is the section."""
    width = look().across(IN.left + 2 * IN.panel_width + IN.gap + IN.bar_gap + IN.right)
    free = width - IN.left - IN.bar_gap - IN.right
    wide, tall = (free - IN.gap) / 2, IN.panel_height
    lefts, bottoms = (IN.left, IN.left + wide + IN.gap), (IN.bottom, IN.bottom)
    if width < IN.least_width:
        wide, tall, lefts = free, IN.low_panel, (IN.left, IN.left)
        bottoms = (IN.bottom + IN.low_panel + IN.panel_title + 0.1, IN.bottom)
    columns = min(len(LINE_STYLES), int(free / IN.legend_column))
    rows = -(-len(trajectory.inlet_pressure) // columns)
    above = IN.panel_title + IN.legend_row * rows + head_room(trajectory, width)
    top = bottoms[0] + tall
    with picture(path, width, top + above) as made:
        left, right = (axes_at(made, x, y, wide, tall) for x, y in zip(lefts, bottoms, strict=True))
        norm = _section_colours(trajectory.sections)
        limits = _limits(trajectory)
        for axes, side, title in ((left, "L", "left column"), (right, "R", "right column")):
            _draw_column(axes, trajectory, side, norm)
            _draw_levels(axes, trajectory, limits[1])
            axes.ticklabel_format(axis="y", style="plain", useOffset=False)
            axes.ticklabel_format(axis="x", scilimits=TIME_DIGITS)
            axes.set(xlim=limits[0], ylim=limits[1], xlabel=channel("time").label)
            last = f" to {side}{trajectory.sections}" if trajectory.sections > 1 else ""
            axes.set_title(f"{title}, {side}1{last}", loc="left", fontsize=9)
        left.set_ylabel(channel("pressure").label)
        if bottoms[0] == bottoms[1]:
            right.tick_params(labelleft=False)
        else:
            right.set_ylabel(channel("pressure").label)
            left.set_xlabel("")
            left.tick_params(labelbottom=False)
        _draw_legend(made, right, columns, top + IN.panel_title)
        bar = axes_at(made, width - IN.right, IN.bottom, 0.12, top - IN.bottom)
        _draw_bar(made, bar, trajectory, norm)
        head(made, trajectory, "gauge pressures", IN.left)


def _section_colours(sections: int) -> Normalize:
    if sections > MAX_DISCRETE_SECTIONS:
        return Normalize(1, sections)
    return BoundaryNorm(np.arange(sections + 1) + 0.5, look().sequential.N)


def _draw_column(axes: Axes, trajectory: Trajectory, side: str, norm: Normalize) -> None:
    columns = [k for k, name in enumerate(trajectory.bellows) if name.startswith(side)]
    low, high = extremes(trajectory.pressure)
    # The smallest swing is drawn last, so that it stays visible among many cycles.
    columns.sort(key=lambda k: -float(high[k] - low[k]))
    numbers = np.array([float(trajectory.bellows[k][1:]) for k in columns])
    time, pressure = envelope(trajectory.time, trajectory.pressure)
    times = np.broadcast_to(time[:, None], (len(time), len(columns)))
    curves = np.stack((times, pressure[:, columns] / 1e3), axis=2).transpose(1, 0, 2)
    lines = LineCollection(
        list(curves), cmap=look().sequential, norm=norm, linewidths=1.1, zorder=3
    )
    lines.set_array(numbers)
    axes.add_collection(lines)
    alone = len(trajectory.inlet_pressure) == 1
    for k, (name, values) in enumerate(trajectory.inlet_pressure.items()):
        axes.plot(
            time, envelope(trajectory.time, values[:, None])[1][:, 0] / 1e3, zorder=2, lw=2.4,
            color=look().inlets[k % len(look().inlets)], ls=LINE_STYLES[k % len(LINE_STYLES)],
            label="inlet" if alone or name == "inlet" else f"inlet {shown(name, 14)}",
            marker="_" if len(time) == 1 else None,
        )  # fmt: skip
    if len(time) == 1:
        axes.scatter(
            times[0], curves[:, 0, 1], c=numbers, cmap=look().sequential, norm=norm, zorder=3
        )


def _limits(trajectory: Trajectory) -> tuple[tuple[float, float], tuple[float, float]]:
    """Time [s] and pressure [kPa], both never of no extent."""
    told = (trajectory.pressure, *trajectory.inlet_pressure.values())
    lows, highs = zip(*(extremes(values) for values in told), strict=True)
    low = min(float(np.min(v)) for v in lows) / 1e3
    high = max(float(np.max(v)) for v in highs) / 1e3
    largest = max(abs(low), abs(high))
    # A range of rounding alone is drawn as a level line.
    margin = 0.06 * (high - low) if high - low > 1e-6 * largest else 0.1 * largest or 1.0
    start, end = float(trajectory.time[0]), float(trajectory.time[-1])
    across = (start, end) if end > start else (start - 0.5, start + 0.5)
    return across, (low - margin, high + margin)


def _draw_levels(axes: Axes, trajectory: Trajectory, limits: tuple[float, float]) -> None:
    """Grid, ambient pressure, and vacuum, the lowest gauge pressure there is."""
    axes.grid(color=look().grid, lw=0.6)
    axes.set_axisbelow(True)
    levels = {"ambient": 0.0, "vacuum": -trajectory.ambient_pressure / 1e3}
    for name, level in levels.items():
        if limits[0] < level < limits[1]:
            axes.axhline(level, color=look().grey, lw=0.9, ls=(0, (6, 2)), zorder=1)
            axes.annotate(
                name, xy=(1, level), xycoords=("axes fraction", "data"), xytext=(-1, 1.5),
                textcoords="offset points", ha="right", va="bottom", fontsize=7, color=look().note,
                bbox={"facecolor": look().ground, "edgecolor": "none", "alpha": 0.7, "pad": 0.5},
                zorder=5,
            )  # fmt: skip


def _draw_legend(made: Figure, axes: Axes, columns: int, bottom: float) -> None:
    width, height = made.get_size_inches()
    made.legend(
        *axes.get_legend_handles_labels(), loc="lower left", ncols=columns, handlelength=2.4,
        borderaxespad=0, columnspacing=1.4,
        bbox_to_anchor=(IN.left / width, bottom / height),
    )  # fmt: skip


def _draw_bar(made: Figure, axes: Axes, trajectory: Trajectory, norm: Normalize) -> None:
    sections = trajectory.sections
    bar = made.colorbar(
        ScalarMappable(norm, look().sequential),
        cax=axes,
    )
    bar.set_label("section, 1 at the clamp")
    ticks = _section_ticks(sections)
    bar.set_ticks([float(tick) for tick in ticks], labels=[str(tick) for tick in ticks])
    bar.minorticks_off()
    bar.ax.tick_params(length=0 if sections <= MAX_DISCRETE_SECTIONS else 3)
    bar.outline.set_edgecolor(look().faint)
    bar.outline.set_linewidth(0.4)


def _section_ticks(sections: int) -> list[int]:
    """All of few; of many the first and about ten round numbers."""
    if sections <= MAX_DISCRETE_SECTIONS:
        return list(range(1, sections + 1))
    rounds = (m * 10**e for e in range(9) for m in (1, 2, 5))
    step = next(step for step in rounds if sections <= 10 * step)
    return [1, *range(step, sections + 1, step)]
