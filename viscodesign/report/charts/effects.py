"""`effects.png`: the tip displacement of every effect, estimated and measured."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullLocator, StrMethodFormatter

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.label_placement import CHARACTER_WIDTH, POINTS_PER_INCH
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import (
    NOTE,
    Target,
    axes_at,
    draw_note,
    head,
    head_room,
    picture,
    shown,
)
from viscodesign.results.channels import RESOLVED_MM
from viscodesign.results.findings import NOT_APPLICABLE
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class EffectsLayout:
    """Lengths of the picture [inch]."""

    left: float = 2.05
    bottom: float = 0.5
    plot_width: float = 4.6
    right: float = 0.3
    row_height: float = 0.36
    legend_row: float = 0.2
    legend_column: float = 1.65
    number_width: float = 0.75
    """Space for a number to the right of the longest bar."""
    least_width: float = 4.6
    """With the whole margin."""
    narrow_left: float = 1.75
    """The margin below the least width."""
    narrow_number_width: float = 0.45
    least_legend: float = 4.5
    """Width of the bars from which on the key is as wide."""
    least_label: float = 3.4
    """Width of the bars from which on the whole label of the axis fits."""
    note_line: float = 0.15
    """A line of what is not applicable."""


IN = EffectsLayout()
LEGEND_ENTRIES = 5
WRONG, SHORT_WRONG = "NEGLECTED BUT SIGNIFICANT", "NEGLECTED, TOO LARGE"
BAR_THICKNESS = 0.36
"""Thickness of a bar, as a share of its row."""
HATCH = "/////"
BUDGET_DASHES = (0, (5, 2))
NUMBER_SIZE, NUMBER_GAP = 6.5, 3.0
"""Letters of numbers, and the room beside them [pt]."""
SMALLEST_BAR = 1e-5
"""Smallest displacement that is drawn as a bar, as a share of the requested error."""


@dataclass(frozen=True)
class EffectRow:
    """One effect; displacements in mm, None where there is no number."""

    name: str
    decision: str
    estimated: float | None
    measured: float | None
    note: str = ""
    """What is written in place of a measurement."""

    @property
    def is_included(self) -> bool:
        """Whether the run has it."""
        return self.decision == "included"

    @property
    def is_applicable(self) -> bool:
        """Whether the scene has what it acts on."""
        return self.decision != NOT_APPLICABLE

    @property
    def size(self) -> tuple[float, float]:
        """The sort key: measured if that is known, else estimated."""
        known = self.estimated if self.measured is None else self.measured
        return known or 0.0, self.estimated or 0.0


def draw_effects(trajectory: Trajectory, path: Target) -> None:
    """One row per effect, the largest displacement on top; the requested error as a line."""
    every = effect_rows(trajectory)
    rows = [row for row in every if row.is_applicable] or every
    budget = 1e3 * trajectory.accuracy.requested_m
    height = IN.row_height * len(rows)
    width = look().across(IN.left + IN.plot_width + IN.right)
    left = IN.left if width >= IN.least_width else IN.narrow_left
    wide = width - left - IN.right
    number = (IN.number_width if left == IN.left else IN.narrow_number_width) / wide
    columns = 3 if wide >= IN.least_legend else min(2, int(width / IN.legend_column))
    legend = IN.legend_row * -(-LEGEND_ENTRIES // columns) + 0.1
    notes = _absent_lines([row.name for row in every if row not in rows], width - 0.2)
    bottom = IN.bottom + IN.note_line * len(notes)
    with picture(path, width, bottom + height + legend + head_room(trajectory, width)) as made:
        axes = axes_at(made, left, bottom, wide, height)
        limits = _limits(rows, budget, number)
        axes.set(xscale="log", xlim=limits, ylim=(len(rows) - 0.5, -0.5))
        words = "tip displacement when only this effect is switched [mm]"
        axes.set_xlabel(words if wide >= IN.least_label else "tip displacement [mm]")
        axes.xaxis.set_major_locator(LogLocator(numticks=max(3, int(2 * wide))))
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.grid(axis="x", color=look().grid, lw=0.6)
        axes.set_axisbelow(True)
        axes.axvline(budget, zorder=2, **_budget_line())
        for k, row in enumerate(rows):
            _draw_row(axes, k, row, number)
        _draw_names(axes, rows, budget, WRONG if left == IN.left else SHORT_WRONG)
        _draw_legend(made, budget, left, bottom + height, columns)
        for k, line in enumerate(reversed(notes)):
            draw_note(made, line, 0.1, 0.07 + IN.note_line * k)
        head(made, trajectory, "tip displacement by effect", 0.1)


def _absent_lines(names: list[str], width: float) -> list[str]:
    """What is said of effects without a row, in lines of a width [inch]."""
    if not names:
        return []
    columns = int(width * POINTS_PER_INCH / (CHARACTER_WIDTH * NOTE))
    return textwrap.wrap(f"{NOT_APPLICABLE}: {', '.join(names)}", columns)


def effect_rows(trajectory: Trajectory) -> list[EffectRow]:
    """One row per effect, by size; effects that are not applicable come last."""
    ablations = {ablation.name: ablation for ablation in trajectory.proof}
    rows = []
    for verdict in trajectory.effects:
        estimated = 1e3 * verdict.contribution_m
        ablation = ablations.get(verdict.name)
        if ablation is None:
            measured, note = None, "not measured" if estimated else ""
        elif ablation.measured_m is None:
            word = "without" if ablation.taken else "with"
            measured, note = None, f"no solution {word} it"
        else:
            measured, note = 1e3 * ablation.measured_m, ""
        rows.append(EffectRow(verdict.name, verdict.decision, estimated, measured, note))
    return sorted(rows, key=lambda row: row.size, reverse=True)


def _limits(rows: Iterable[EffectRow], budget: float, number: float) -> tuple[float, float]:
    """Limits of the axis around all bars and the line; ``number`` is its share for numbers."""
    moves = [m for row in rows for m in (row.estimated, row.measured) if m and math.isfinite(m)]
    seen = [budget, *(m for m in moves if m > SMALLEST_BAR * budget)]
    low = 10.0 ** math.floor(math.log10(0.5 * min(seen)))
    return low, low * (max(seen) / low) ** (1 / (1 - number))


def _draw_row(axes: Axes, k: int, row: EffectRow, number: float) -> None:
    if not row.estimated and not row.measured and not row.note:
        _write(axes, axes.get_xlim()[0], k, "none")
        return
    above, below = k - BAR_THICKNESS / 2, k + BAR_THICKNESS / 2
    _draw_bar(axes, below, row.estimated, row.is_included, look().faint, "", number)
    _draw_bar(axes, above, row.measured, row.is_included, look().main, row.note, number)


def _draw_bar(
    axes: Axes, y: float, move: float | None, taken: bool, colour: Any, note: str, number: float
) -> None:
    """A filled or hatched bar, with its number at its end."""
    low, high = axes.get_xlim()
    if move is None or move <= low:
        _write(axes, low, y, note if move is None else _small(move))
        return
    end = min(move, low * (high / low) ** (1 - number))
    edge = look().grey if colour == look().faint else colour
    style: dict[str, Any] = (
        {"color": colour}
        if taken
        else {"facecolor": look().ground, "edgecolor": edge, "hatch": HATCH}
    )
    axes.barh(y, end - low, BAR_THICKNESS, left=low, zorder=3, linewidth=0.8, **style)
    _write(axes, end, y, f"{move:.3g}" if math.isfinite(move) else "unbounded")


def _small(move: float) -> str:
    """A number too small for a bar."""
    if not move:
        return "none"
    return f"< {RESOLVED_MM:g}" if move < RESOLVED_MM else f"{move:.2g}"


def _write(axes: Axes, x: float, y: float, words: str) -> None:
    """Words right of a place; right of the limit's line where they would lie on it."""
    axes.annotate(
        words, xy=(_beside_line(axes, x, words), y), xytext=(NUMBER_GAP, 0),
        textcoords="offset points", va="center_baseline", fontsize=NUMBER_SIZE, color=look().ink,
        zorder=5, bbox={"facecolor": look().ground, "edgecolor": "none", "pad": 0.4},
    )  # fmt: skip


def _beside_line(axes: Axes, x: float, words: str) -> float:
    low, high = axes.get_xlim()
    wide = axes.bbox.width / axes.figure.dpi * POINTS_PER_INCH
    line, at = (wide * math.log(v / low) / math.log(high / low) for v in (_limit_of(axes), x))
    width = NUMBER_GAP + len(words) * CHARACTER_WIDTH * NUMBER_SIZE + NUMBER_GAP
    return _limit_of(axes) if at < line < at + width else x


def _limit_of(axes: Axes) -> float:
    """Where the line of the requested error is."""
    return float(np.asarray(axes.lines[0].get_xdata(), dtype=float)[0])


def _draw_names(axes: Axes, rows: list[EffectRow], budget: float, warning: str) -> None:
    """Name and decision; a wrong decision stands out."""
    wrongly = [not row.is_included and (row.measured or 0.0) > budget for row in rows]
    words = [
        f"{shown(row.name, 24)}\n{warning if wrong else row.decision}"
        for row, wrong in zip(rows, wrongly, strict=True)
    ]
    axes.set_yticks(range(len(rows)), words, fontsize=7.5, linespacing=1.0)
    axes.tick_params(axis="y", length=0)
    for label, wrong in zip(axes.get_yticklabels(), wrongly, strict=True):
        label.set(
            weight="bold" if wrong else "normal", color=look().warning if wrong else look().ink
        )


def _budget_line() -> dict[str, Any]:
    return {"color": look().accent, "lw": 1.4, "ls": BUDGET_DASHES}


def _draw_legend(made: Figure, budget: float, left: float, top: float, columns: int) -> None:
    width, height = made.get_size_inches()
    handles = [
        Patch(facecolor=look().main, label="measured"),
        Patch(facecolor=look().faint, label="estimated"),
        Patch(facecolor=look().ink, label="included: filled"),
        Patch(
            facecolor=look().ground, edgecolor=look().ink, hatch=HATCH, label="neglected: hatched"
        ),
        Line2D([], [], **_budget_line(), label=f"requested error: {budget:.3g} mm"),
    ]
    made.legend(
        handles=handles, loc="lower left", ncols=columns, borderaxespad=0, columnspacing=1.4,
        bbox_to_anchor=((left if columns == 3 else 0.1) / width, (top + 0.08) / height),
    )  # fmt: skip
