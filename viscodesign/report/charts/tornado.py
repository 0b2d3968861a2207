"""`sensitivity.png`: what moves the tip how far, and when."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.sensitivity_study import AXES, SensitivityStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEFT, BARS_WIDTH, GAP, PATH_WIDTH, RIGHT = 2.15, 3.0, 0.8, 3.3, 0.2
BOTTOM, ROW_HEIGHT, LEAST_HEIGHT, PANEL_GAP = 0.55, 0.27, 3.0, 0.12
LEAST_WIDTH, PANEL_HEIGHT, NARROW_LEFT, LABEL = 6.4, 1.2, 1.55, 0.15
"""All in inches: the least width with the paths on the right, their height below the bars, and
there the margin of the bars and a second line of their label."""
MOST_BARS = 16
DEVIATIONS = 2
"""Half width of a drawn band, in standard deviations."""
LINES = 3
"""Numbers whose shifts are drawn against time where there is no band."""


def draw_tornado(study: SensitivityStudy, path: Path) -> None:
    """Bars of the largest shifts, the farthest on top; beside them x and z against time."""
    order = study.order[:MOST_BARS]
    width = look().across(LEFT + BARS_WIDTH + GAP + PATH_WIDTH + RIGHT)
    bars, margin = ROW_HEIGHT * max(len(order), 2), LEFT
    if width >= LEAST_WIDTH:
        free = width - LEFT - GAP - RIGHT
        wide = free * BARS_WIDTH / (BARS_WIDTH + PATH_WIDTH)
        bars, base = max(bars, LEAST_HEIGHT), BOTTOM
        panel, left, across = (bars - PANEL_GAP) / 2, LEFT + wide + GAP, free - wide
    else:
        margin = min(LEFT, max(NARROW_LEFT, width - LEFT - RIGHT))
        wide = width - margin - RIGHT
        panel, left, across = PANEL_HEIGHT, GAP, width - GAP - RIGHT
        base = 2 * BOTTOM + LABEL + 2 * panel + PANEL_GAP
    with picture(path, width, base + bars + title_room()) as made:
        _draw_bars(axes_at(made, margin, base, wide, bars), study, order)
        for c, bottom in enumerate((BOTTOM + panel + PANEL_GAP, BOTTOM)):
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
    wide_enough = look().across(LEAST_WIDTH) >= LEAST_WIDTH
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
