"""`sensitivity.png`: what moves the tip how far, and when."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.sensitivity_study import AXES, SensitivityStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class TornadoLayout:
    """Lengths of the picture [inch]."""

    left: float = 2.15
    bars_width: float = 3.0
    gap: float = 0.8
    path_width: float = 3.3
    right: float = 0.2
    bottom: float = 0.55
    row_height: float = 0.27
    least_height: float = 3.0
    panel_gap: float = 0.12
    least_width: float = 6.4
    """With the paths on the right."""
    panel_height: float = 1.2
    """Height of a path below the bars."""
    narrow_left: float = 1.55
    """Margin of the bars there."""
    label: float = 0.15
    """A second line of their label there."""


IN = TornadoLayout()
MAX_BARS = 16
DEVIATIONS = 2
"""Half width of a drawn band, in standard deviations."""
LINES = 3
"""Numbers whose shifts are drawn against time where there is no band."""


def draw_tornado(study: SensitivityStudy, path: Path) -> None:
    """Bars of the largest shifts, the farthest on top; beside them x and z against time."""
    order = study.order[:MAX_BARS]
    width = look().across(IN.left + IN.bars_width + IN.gap + IN.path_width + IN.right)
    bars, margin = IN.row_height * max(len(order), 2), IN.left
    if width >= IN.least_width:
        free = width - IN.left - IN.gap - IN.right
        wide = free * IN.bars_width / (IN.bars_width + IN.path_width)
        bars, base = max(bars, IN.least_height), IN.bottom
        panel, left, across = (bars - IN.panel_gap) / 2, IN.left + wide + IN.gap, free - wide
    else:
        margin = min(IN.left, max(IN.narrow_left, width - IN.left - IN.right))
        wide = width - margin - IN.right
        panel, left, across = IN.panel_height, IN.gap, width - IN.gap - IN.right
        base = 2 * IN.bottom + IN.label + 2 * panel + IN.panel_gap
    with picture(path, width, base + bars + title_room()) as made:
        _draw_bars(axes_at(made, margin, base, wide, bars), study, order)
        for c, bottom in enumerate((IN.bottom + panel + IN.panel_gap, IN.bottom)):
            axes = axes_at(made, left, bottom, across, panel)
            _draw_band(axes, study, c) if study.has_band else _draw_shifts(axes, study, c, order)
            axes.tick_params(labelbottom=c == 1)
            if c == 1:
                axes.set_xlabel("time [s]")
        draw_title(made, f"{shown(study.name, 40)}: {_words(study, len(order))}", 0.1)


def _words(study: SensitivityStudy, rows: int) -> str:
    more = len(study.numbers) - rows
    left_out = f" ({more} that move it less left out)" if more > 0 else ""
    if study.has_band:
        return f"shift of the tip by one standard deviation of each number{left_out}"
    return f"shift of the tip by one percent of each number{left_out}"


def _draw_bars(axes: Axes, study: SensitivityStudy, order: list[int]) -> None:
    """To the right what a larger number does at its worst time, to the left a smaller one."""
    sizes = study.sizes[:, order].max(axis=0)
    wide_enough = look().across(IN.least_width) >= IN.least_width
    places = range(len(order))
    colour = look().main
    axes.barh(places, sizes, 0.62, color=colour)
    axes.barh(places, -sizes, 0.62, color=look().faint)
    for place, size in zip(places, sizes, strict=True):
        axes.annotate(
            f"{size:.2g}", (size, place), (3, 0), textcoords="offset points", va="center", size=6.5
        )
    reach = (1.18 if wide_enough else 1.5) * max(sizes.max(initial=0.0), 1e-12)
    axes.set(xlim=(-reach, reach), ylim=(len(order) - 0.5, -0.5))
    axes.locator_params(axis="x", nbins=5)
    axes.set_yticks(
        places, [shown(study.numbers[k].key, 36 if wide_enough else 24) for k in order], fontsize=7
    )
    axes.tick_params(axis="y", length=0)
    axes.axvline(0.0, color=look().ink, lw=0.8)
    between = " " if wide_enough else "\n"
    axes.set_xlabel(f"largest shift of the tip,{between}number smaller | larger [mm]", fontsize=8)


def _draw_band(axes: Axes, study: SensitivityStudy, c: int) -> None:
    tip, half = 1e3 * study.tip[:, c], 1e3 * DEVIATIONS * study.band[:, c]
    axes.fill_between(study.time, tip - half, tip + half, color=look().accent, alpha=0.35, lw=0)
    axes.plot(study.time, tip, color=look().ink, lw=1.0)
    axes.set_ylabel(f"{AXES[c]} ± {DEVIATIONS} sd [mm]")


def _draw_shifts(axes: Axes, study: SensitivityStudy, c: int, order: list[int]) -> None:
    for place, k in enumerate(order[:LINES]):
        axes.plot(
            study.time, study.mm_per_percent[:, c, k], lw=1.1,
            color=look().sequential(place / LINES), label=shown(study.numbers[k].key, 32),
        )  # fmt: skip
    axes.set_ylabel(f"{AXES[c]} [mm per percent]")
    if c == 0:
        axes.legend(fontsize=6.5, loc="best")
