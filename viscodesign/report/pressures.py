"""`pressures.png`: every bellow's pressure against time, with the inlet's."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from viscodesign.report.style import ACCENT, FAINT, SEQUENTIAL, ended_early, picture
from viscodesign.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DASHES = ("-", "--", ":", "-.")


def draw_pressures(trajectory: Trajectory, path: Path) -> None:
    """Two panels, right and left column, kPa gauge; colour is the section."""
    with picture(path, 6.6, 4.6) as made:
        left = made.add_axes((0.1, 0.12, 0.37, 0.77))
        right = made.add_axes((0.5, 0.12, 0.37, 0.77), sharex=left, sharey=left)
        norm = Normalize(1, max(trajectory.sections, 2))
        for axes, side, title in ((left, "L", "left column"), (right, "R", "right column")):
            _draw_column(axes, trajectory, side, norm)
            axes.set_title(title, loc="left", fontsize=9)
            axes.set_xlabel("time [s]")
            axes.grid(color="#e6e6e6", lw=0.6)
            axes.set_axisbelow(True)
        left.set_ylabel("pressure [kPa gauge]")
        right.tick_params(labelleft=False)
        _limits(left, trajectory)
        right.legend(loc="best", handlelength=2.2)
        bar = made.colorbar(
            ScalarMappable(norm, mpl.colormaps[SEQUENTIAL]),
            cax=made.add_axes((0.895, 0.12, 0.018, 0.77)),
        )
        bar.set_label("section, 1 at the clamp")
        bar.set_ticks(_section_ticks(trajectory.sections))
        bar.outline.set_visible(False)
        made.text(0.1, 0.97, f"{trajectory.name}: pressures", fontsize=10)
        ended_early(made, trajectory)


def _draw_column(axes: Axes, trajectory: Trajectory, side: str, norm: Normalize) -> None:
    columns = [k for k, name in enumerate(trajectory.bellows) if name.startswith(side)]
    numbers = np.array([int(trajectory.bellows[k][1:]) for k in columns])
    time = np.broadcast_to(trajectory.time[:, None], (len(trajectory.time), len(columns)))
    curves = np.stack((time, trajectory.pressure[:, columns] / 1e3), axis=2).transpose(1, 0, 2)
    lines = LineCollection(list(curves), cmap=SEQUENTIAL, norm=norm, linewidths=1.2, zorder=3)
    lines.set_array(numbers.astype(float))
    axes.add_collection(lines)
    for k, (name, values) in enumerate(trajectory.inlet_pressure.items()):
        label = "inlet" if len(trajectory.inlet_pressure) == 1 else f"inlet '{name}'"
        axes.plot(
            trajectory.time,
            values / 1e3,
            color=ACCENT,
            lw=2,
            ls=DASHES[k % 4],
            label=label,
            zorder=2,
        )


def _limits(axes: Axes, trajectory: Trajectory) -> None:
    values = [trajectory.pressure.ravel(), *trajectory.inlet_pressure.values()]
    low = min(float(np.min(v)) for v in values) / 1e3
    high = max(float(np.max(v)) for v in values) / 1e3
    margin = 0.06 * (high - low) or max(0.05 * abs(high), 0.1)
    axes.set_ylim(low - margin, high + margin)
    end = trajectory.time[-1] if len(trajectory.time) > 1 else trajectory.time[0] + 1
    axes.set_xlim(trajectory.time[0], end)
    for shared in axes.get_shared_y_axes().get_siblings(axes):
        if low - margin < 0 < high + margin:
            shared.axhline(0, color=FAINT, lw=0.9, zorder=1)


def _section_ticks(sections: int) -> list[int]:
    step = max(1, round(sections / 8))
    ticks = list(range(1, sections + 1, step))
    return ticks if ticks[-1] == sections or step > 1 else [*ticks, sections]
