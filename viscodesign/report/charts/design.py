"""`design.png`: the wanted path and the found one with its band, and how the search got there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Polygon
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import Target, axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import channel, millimetres
from viscodesign.results.path_design import PathDesign

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class DesignLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.75
    bottom: float = 0.6
    side: float = 4.2
    gap: float = 0.95
    search: float = 2.6
    key: float = 0.3
    right: float = 0.25
    least_width: float = 5.6
    """With the search on the right."""
    below: float = 1.3
    """Height of the search where it is below."""
    least_key: float = 3.8
    """Side from which on the key is one line."""
    key_line: float = 0.2
    """A further line of the key."""


IN = DesignLayout()
DESIGN_PAD = 0.08
MIN_DESIGN_SPAN_MM = 1.0


def draw_design(found: PathDesign, path: Target) -> None:
    """Paths, z down as the actuator hangs; beside or below them the best distance so far."""
    width = look().across(IN.left + IN.side + IN.gap + IN.search + IN.right)
    free = width - IN.left - IN.right
    if width >= IN.least_width:
        side, base = (free - IN.gap) * IN.side / (IN.side + IN.search), IN.bottom
        search = (IN.left + side + IN.gap, IN.bottom, free - IN.gap - side, side)
    else:
        side, base = free, 2 * IN.bottom + IN.below
        search = (IN.left, IN.bottom, free, IN.below)
    columns = 3 if side >= IN.least_key else 1
    key = IN.key + IN.key_line * (3 - columns)
    with picture(path, width, base + side + key + title_room()) as made:
        axes = axes_at(made, IN.left, base, side, side)
        _draw_paths(axes, found, columns)
        draw_title(made, shown(_title(found), 90), IN.left)
        _draw_search(axes_at(made, *search), found)


def _title(found: PathDesign) -> str:
    if found.confirmed_rms_m is None:
        return f"{found.name}: {found.status.replace('_', ' ')}"
    words = "met" if found.status == "met" else "not met"
    return (
        f"{found.name}: {words}, {millimetres(found.confirmed_rms_m)} rms of "
        f"{millimetres(found.tolerance_m)} allowed"
    )


def _draw_paths(axes: Axes, found: PathDesign, columns: int) -> None:
    wanted, way = 1e3 * found.wanted, 1e3 * _closed(found.found, found.closed)
    every = np.concatenate([wanted, way])
    middle = (every.min(axis=0) + every.max(axis=0)) / 2
    half = (0.5 + DESIGN_PAD) * max(float(np.ptp(every, axis=0).max()), MIN_DESIGN_SPAN_MM)
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] + half, middle[1] - half))
    axes.set_aspect("equal")
    if len(found.band) >= len(found.found) > 1:
        band = _closed(found.band[: len(found.found)], found.closed)
        _draw_band(axes, way, 1e3 * band)
    axes.plot(
        *wanted.T, color=look().ink, lw=3.2, alpha=0.28, label="wanted", solid_capstyle="round"
    )
    if len(way):
        axes.plot(*way.T, color=look().main, lw=1.3, label="found", zorder=4)
        _draw_arrow(axes, way)
    axes.set(xlabel=channel("x").label, ylabel=f"{channel('z').label}, down from the clamp")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, borderaxespad=0.1)


def _draw_band(axes: Axes, way: np.ndarray, band: np.ndarray) -> None:
    """What one percent of every free number moves the path sideways, as a ribbon."""
    along = np.gradient(way, axis=0)
    length = np.linalg.norm(along, axis=1)
    across = np.column_stack([-along[:, 1], along[:, 0]]) / np.where(length > 0, length, 1)[:, None]
    wide = np.sqrt(((across * band) ** 2).sum(axis=1))[:, None] * across
    for k in range(len(way) - 1):
        corners = [way[k] + wide[k], way[k + 1] + wide[k + 1], way[k + 1] - wide[k + 1]]
        ribbon = Polygon(
            [*corners, way[k] - wide[k]], fc=look().main, ec="none", alpha=0.22, zorder=2
        )
        if k == 0:
            ribbon.set_label("± 1 % of each free number")
        axes.add_patch(ribbon)


def _draw_arrow(axes: Axes, way: np.ndarray) -> None:
    """Its sense, where the tip moves fastest."""
    steps = np.linalg.norm(np.diff(way, axis=0), axis=1)
    if not steps.max() > 0.0:
        return
    k = int(steps.argmax())
    axes.annotate(
        "", xy=tuple(way[k + 1]), xytext=tuple(way[k]), zorder=5,
        arrowprops={"arrowstyle": "-|>", "color": look().main, "mutation_scale": 14, "lw": 0},
    )  # fmt: skip


def _draw_search(axes: Axes, found: PathDesign) -> None:
    if found.history:
        rows = [row.evaluation for row in found.history]
        best = [1e3 * row.rms_m for row in found.history]
        end = max(found.evaluations, rows[-1] + 1)
        axes.step([*rows, end], [*best, best[-1]], where="post", color=look().main, lw=1.3)
        axes.set_yscale("log")
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
        axes.xaxis.set_major_locator(MaxNLocator("auto", integer=True))
        axes.set_xlim(left=0)
    axes.axhline(1e3 * found.tolerance_m, color=look().accent, lw=0.9, ls="--")
    axes.text(
        1.0, 1e3 * found.tolerance_m, "allowed", color=look().warning, size=8, ha="right",
        va="bottom",
        transform=axes.get_yaxis_transform(),
    )  # fmt: skip
    axes.set(xlabel="solutions", ylabel="best distance [mm rms]")
    axes.grid(color=look().grid, lw=0.6)
    axes.tick_params(which="both", color=look().grey)


def _closed(way: np.ndarray, closed: bool) -> np.ndarray:
    return np.concatenate([way, way[:1]]) if closed and len(way) else way
