"""`tips.png`: the tips of several actuators, each from its own clamp."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.charts.compare import draw_paths
from viscodesign.report.layout.downsampling import envelope
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import line_style
from viscodesign.report.layout.style import (
    Target,
    axes_at,
    draw_title,
    picture,
    shown,
    title_room,
)
from viscodesign.results.channels import channel
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.results.trajectory import Trajectory


@dataclass(frozen=True)
class TipsLayout:
    """Lengths of the picture [inch].

    Below the least width the panels stand one above the other.
    """

    left: float = 0.7
    bottom: float = 0.5
    side: float = 3.2
    gap: float = 0.75
    wide: float = 3.2
    right: float = 0.2
    key_line: float = 0.2
    least_width: float = 6.0


IN = TipsLayout()


@dataclass(frozen=True)
class OneTip:
    """The motion of actuators that are equal."""

    title: str
    """Their names."""
    run: Trajectory

    @property
    def tip(self) -> np.ndarray:
        """x and z at all output times (T, 2) [m]."""
        return self.run.tip[:, :2]


def draw_several_tips(found: SeveralRuns, path: Target) -> None:
    """The paths of all distinct tips at one scale, and their x over time."""
    motions = _distinct(found)
    width = look().across(IN.left + IN.side + IN.gap + IN.wide + IN.right)
    is_wide = width >= IN.least_width
    side = (width - IN.left - IN.gap - IN.right) / 2 if is_wide else width - IN.left - IN.right
    key = 0.12 + IN.key_line * -(-len(motions) // 3)
    above = IN.bottom if is_wide else 2 * IN.bottom + side
    with picture(path, width, above + side + key + title_room()) as made:
        draw_title(made, shown(f"{found.name}: tips, each from its own clamp", 90), IN.left)
        paths = axes_at(made, IN.left, above, side, side)
        draw_paths(paths, motions)
        handles, labels = paths.get_legend_handles_labels()
        top = above + side + key
        made.legend(
            handles, labels, loc="upper left", ncols=3, borderaxespad=0, handlelength=2.6,
            bbox_to_anchor=(IN.left / width, (top - 0.04) / made.get_size_inches()[1]),
        )  # fmt: skip
        axes = axes_at(made, IN.left + side + IN.gap if is_wide else IN.left, IN.bottom, side, side)
        for k, motion in enumerate(motions):
            time, across = envelope(motion.run.time, 1e3 * motion.tip[:, :1])
            style = line_style(k)
            (line,) = axes.plot(time, across[:, 0], color=style.colour, lw=1.4)
            if style.dashes:
                line.set_dashes(style.dashes)
        axes.set(xlabel=channel("time").label, ylabel=channel("x").label)
        axes.grid(color=look().grid, lw=0.6)


def _distinct(found: SeveralRuns) -> list[OneTip]:
    """One motion for all actuators that are equal."""
    names: dict[str, list[str]] = {}
    for name in found.runs:
        names.setdefault(found.equal_to.get(name, name), []).append(name)
    return [
        OneTip(", ".join(own), found.runs[first])
        for first, own in names.items()
        if first in found.runs and len(found.runs[first].time)
    ]
