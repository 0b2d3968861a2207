"""`reach.png`: where the tip can be with one inlet and with two, and the way to a point."""

from __future__ import annotations

import numpy as np
from matplotlib.patches import Polygon

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import Target, axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import channel
from viscodesign.results.reach_study import ReachStudy


@dataclass(frozen=True)
class ReachLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.75
    bottom: float = 0.6
    width: float = 6.0
    right: float = 0.25
    key_line: float = 0.2
    """A line of the key."""
    key_column: float = 1.6
    """A column of it."""
    tallest: float = 6.0
    lowest: float = 2.6


IN = ReachLayout()
REACH_PAD = 0.06
NEAR_CLAMP = 0.4
"""The clamp is drawn, too, if it is nearer than this part of the extent of what is drawn."""


def draw_reach(study: ReachStudy, path: Target) -> None:
    """Both sets as areas, z down from the clamp, and the point with the tip's way to it."""
    point = study.point
    low, high, has_clamp = _limits(study)
    full = look().across(IN.left + IN.width + IN.right)
    width = full - IN.left - IN.right
    height = float(np.clip(width * (high[1] - low[1]) / (high[0] - low[0]), IN.lowest, IN.tallest))
    size = np.array([width, height])
    short = size * float(np.max((high - low) / size)) - (high - low)
    low, high = low - short / 2, high + short / 2
    columns = 5 if look().width is None else max(1, int(width / IN.key_column))
    key = 0.15 + IN.key_line * -(-(2 + has_clamp + 2 * (point is not None)) // columns)
    with picture(path, full, IN.bottom + height + key + title_room()) as made:
        axes = axes_at(made, IN.left, IN.bottom, width, height)
        areas = (
            (study.edge_two_inlets, look().faint, "two inlets"),
            (study.edge, look().main, "one inlet"),
        )
        for edge, colour, words in areas:
            if len(edge):
                area = study.area_two_inlets_m2 if edge is study.edge_two_inlets else study.area_m2
                label = f"{words}, {1e4 * area:.3g} cm²"
                axes.add_patch(
                    Polygon(1e3 * edge, fc=colour, ec=colour, alpha=0.35, lw=1.2, label=label)
                )
        if has_clamp:
            axes.plot(0, 0, "s", color=look().ink, ms=6, label="clamp")
        if point is not None:
            axes.plot(*(1e3 * point.path.T), color=look().ink, lw=1.2, label="way of the tip")
            axes.plot(1e3 * point.at[0], 1e3 * point.at[1], "x", color=look().accent, ms=9, mew=2,
                      label="point", zorder=6)  # fmt: skip
        axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]))
        axes.set(xlabel=channel("x").label, ylabel=f"{channel('z').label}, down from the clamp")
        axes.set_aspect("equal")
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, borderaxespad=0.1,
                    columnspacing=1.2, handlelength=1.4)  # fmt: skip
        draw_title(made, shown(_title(study), 90), IN.left)


def _limits(study: ReachStudy) -> tuple[np.ndarray, np.ndarray, bool]:
    """Corners (x, z) [mm] of a frame about all that is drawn, and whether the clamp is near it."""
    point = study.point
    every = [1e3 * study.edge, 1e3 * study.edge_two_inlets]
    if point is not None:
        every += [1e3 * point.path, 1e3 * np.array([point.at])]
    corners = np.concatenate(every)
    low, high = corners.min(axis=0), corners.max(axis=0)
    apart = np.maximum(np.maximum(low, -high), 0.0)
    has_clamp = float(apart.max()) <= NEAR_CLAMP * float(np.max(high - low))
    if has_clamp:
        low, high = np.minimum(low, 0.0), np.maximum(high, 0.0)
    pad = REACH_PAD * float(np.max(high - low))
    return low - pad, high + pad, has_clamp


def _title(study: ReachStudy) -> str:
    low, high = (f"{1e-3 * value:g}" for value in study.limits)
    words = f"{study.name}: reach with {low} to {high} kPa"
    if study.point is None:
        return words
    if study.interrupted:
        return f"{words}; interrupted"
    if study.point.is_reached:
        return f"{words}; the point is reached to {1e3 * study.point.miss_m:.2g} mm"
    return f"{words}; the point is {1e3 * study.point.miss_m:.3g} mm out of reach"
