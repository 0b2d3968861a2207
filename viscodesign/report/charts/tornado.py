"""`sensitivity.png`: what moves the tip how far, and when."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.report.layout.style import (
    ACCENT,
    FAINT,
    INK,
    SEQUENTIAL,
    TITLE_ROOM,
    axes_at,
    picture,
    shown,
)
from viscodesign.results.sensitivity_study import AXES, SensitivityStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEFT, BARS_WIDTH, GAP, PATH_WIDTH, RIGHT = 2.15, 3.0, 0.8, 3.3, 0.2
BOTTOM, ROW_HEIGHT, LEAST_HEIGHT, PANEL_GAP = 0.55, 0.27, 3.0, 0.12
WIDTH = LEFT + BARS_WIDTH + GAP + PATH_WIDTH + RIGHT
"""In inches."""
MOST_ROWS = 16
DEVIATIONS = 2
"""Half width of a drawn band, in standard deviations."""
LINES = 3
"""Numbers whose shifts are drawn against time where there is no band."""


def draw_tornado(study: SensitivityStudy, path: Path) -> None:
    """Bars of the largest shifts, the farthest on top; beside them x and z against time."""
    order = study.order[:MOST_ROWS]
    height = max(ROW_HEIGHT * len(order), LEAST_HEIGHT)
    with picture(path, WIDTH, BOTTOM + height + TITLE_ROOM) as made:
        _draw_bars(axes_at(made, LEFT, BOTTOM, BARS_WIDTH, height), study, order)
        panel = (height - PANEL_GAP) / 2
        left = LEFT + BARS_WIDTH + GAP
        for c, bottom in enumerate((BOTTOM + panel + PANEL_GAP, BOTTOM)):
            axes = axes_at(made, left, bottom, PATH_WIDTH, panel)
            _draw_band(axes, study, c) if study.has_band else _draw_shifts(axes, study, c, order)
            axes.tick_params(labelbottom=c == 1)
            if c == 1:
                axes.set_xlabel("time [s]")
        title = f"{shown(study.name, 40)}: {_words(study, len(order))}"
        made.text(0.1 / WIDTH, 1 - 0.21 / made.get_size_inches()[1], title, size=10, va="baseline")


def _words(study: SensitivityStudy, rows: int) -> str:
    more = len(study.numbers) - rows
    left_out = f" ({more} that move it less left out)" if more > 0 else ""
    if study.has_band:
        return f"shift of the tip by one standard deviation of each number{left_out}"
    return f"shift of the tip by one percent of each number{left_out}"


def _draw_bars(axes: Axes, study: SensitivityStudy, order: list[int]) -> None:
    """To the right what a larger number does at its worst time, to the left a smaller one."""
    sizes = study.sizes[:, order].max(axis=0)
    places = range(len(order))
    colour = SEQUENTIAL(0.25)
    axes.barh(places, sizes, 0.62, color=colour)
    axes.barh(places, -sizes, 0.62, color=FAINT)
    for place, size in zip(places, sizes, strict=True):
        axes.annotate(
            f"{size:.2g}", (size, place), (3, 0), textcoords="offset points", va="center", size=6.5
        )
    reach = 1.18 * max(sizes.max(initial=0.0), 1e-12)
    axes.set(xlim=(-reach, reach), ylim=(len(order) - 0.5, -0.5))
    axes.set_yticks(places, [shown(study.numbers[k].key, 36) for k in order], fontsize=7)
    axes.tick_params(axis="y", length=0)
    axes.axvline(0.0, color=INK, lw=0.8)
    axes.set_xlabel("largest shift of the tip, number smaller | larger [mm]", fontsize=8)


def _draw_band(axes: Axes, study: SensitivityStudy, c: int) -> None:
    tip, half = 1e3 * study.tip[:, c], 1e3 * DEVIATIONS * study.band[:, c]
    axes.fill_between(study.time, tip - half, tip + half, color=ACCENT, alpha=0.35, lw=0)
    axes.plot(study.time, tip, color=INK, lw=1.0)
    axes.set_ylabel(f"{AXES[c]} ± {DEVIATIONS} sd [mm]")


def _draw_shifts(axes: Axes, study: SensitivityStudy, c: int, order: list[int]) -> None:
    for place, k in enumerate(order[:LINES]):
        axes.plot(
            study.time, study.mm_per_percent[:, c, k], lw=1.1,
            color=SEQUENTIAL(place / LINES), label=shown(study.numbers[k].key, 32),
        )  # fmt: skip
    axes.set_ylabel(f"{AXES[c]} [mm per percent]")
    if c == 0:
        axes.legend(fontsize=6.5, loc="best")
