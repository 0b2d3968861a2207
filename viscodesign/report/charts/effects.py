"""`effects.png`: the tip displacement of every effect, estimated and measured."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from matplotlib.colors import to_hex
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullLocator, StrMethodFormatter

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.style import (
    ACCENT,
    FAINT,
    GREY,
    INK,
    SEQUENTIAL,
    Target,
    axes_at,
    head,
    head_room,
    picture,
    shown,
)
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEFT, BOTTOM, PLOT_WIDTH, RIGHT = 2.05, 0.5, 4.6, 0.3
WIDTH = LEFT + PLOT_WIDTH + RIGHT
ROW_HEIGHT, LEGEND_HEIGHT = 0.36, 0.5
NUMBER_WIDTH = 0.75
"""Space to the right of the longest bar, for its number; all in inches."""
BAR_THICKNESS = 0.36
"""Thickness of a bar, as a share of its row."""
MEASURED, ESTIMATED = to_hex(SEQUENTIAL(0.25)), FAINT
HATCH = "/////"
BUDGET_LINE: Any = {"color": ACCENT, "lw": 1.4, "ls": (0, (5, 2))}
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
    def size(self) -> tuple[float, float]:
        """The sort key: measured if that is known, else estimated."""
        known = self.estimated if self.measured is None else self.measured
        return known or 0.0, self.estimated or 0.0


def draw_effects(trajectory: Trajectory, path: Target) -> None:
    """One row per effect, the largest displacement on top; the requested error as a line."""
    rows = effect_rows(trajectory)
    budget = 1e3 * trajectory.accuracy.requested_m
    height = ROW_HEIGHT * len(rows)
    with picture(
        path, WIDTH, BOTTOM + height + LEGEND_HEIGHT + head_room(trajectory, WIDTH)
    ) as made:
        axes = axes_at(made, LEFT, BOTTOM, PLOT_WIDTH, height)
        limits = _limits(rows, budget)
        axes.set(xscale="log", xlim=limits, ylim=(len(rows) - 0.5, -0.5))
        axes.set_xlabel("tip displacement when only this effect is switched [mm]")
        axes.xaxis.set_major_locator(LogLocator(numticks=9))
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.grid(axis="x", color="#e6e6e6", lw=0.6)
        axes.set_axisbelow(True)
        axes.axvline(budget, zorder=4, **BUDGET_LINE)
        for k, row in enumerate(rows):
            _draw_row(axes, k, row, limits[0])
        _draw_names(axes, rows, budget)
        _draw_legend(made, budget, BOTTOM + height)
        head(made, trajectory, "tip displacement by effect", 0.1)


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


def _limits(rows: Iterable[EffectRow], budget: float) -> tuple[float, float]:
    """Limits of the axis, around all bars and the requested error."""
    moves = [m for row in rows for m in (row.estimated, row.measured) if m and math.isfinite(m)]
    seen = [budget, *(m for m in moves if m > SMALLEST_BAR * budget)]
    low = 10.0 ** math.floor(math.log10(0.5 * min(seen)))
    return low, low * (max(seen) / low) ** (PLOT_WIDTH / (PLOT_WIDTH - NUMBER_WIDTH))


def _draw_row(axes: Axes, k: int, row: EffectRow, low: float) -> None:
    if not row.estimated and not row.measured and not row.note:
        _write(axes, low, k, "none")
        return
    _draw_bar(axes, k + BAR_THICKNESS / 2, row.estimated, row.is_included, ESTIMATED, "")
    _draw_bar(axes, k - BAR_THICKNESS / 2, row.measured, row.is_included, MEASURED, row.note)


def _draw_bar(
    axes: Axes, y: float, move: float | None, taken: bool, colour: str, note: str
) -> None:
    """A filled or hatched bar, with its number at its end."""
    low, high = axes.get_xlim()
    if move is None or move <= low:
        words = note if move is None else f"{move:.2g}" if move else "none"
        _write(axes, low, y, words)
        return
    end = min(move, low * (high / low) ** (1 - NUMBER_WIDTH / PLOT_WIDTH))
    edge = colour if colour == MEASURED else GREY
    style: dict[str, Any] = (
        {"color": colour} if taken else {"facecolor": "white", "edgecolor": edge, "hatch": HATCH}
    )
    axes.barh(y, end - low, BAR_THICKNESS, left=low, zorder=3, linewidth=0.8, **style)
    _write(axes, end, y, f"{move:.3g}" if math.isfinite(move) else "unbounded")


def _write(axes: Axes, x: float, y: float, words: str) -> None:
    axes.annotate(
        words, xy=(x, y), xytext=(3, 0), textcoords="offset points", va="center_baseline",
        fontsize=6.5, color=INK, zorder=5,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.4},
    )  # fmt: skip


def _draw_names(axes: Axes, rows: list[EffectRow], budget: float) -> None:
    """Name and decision; a wrong decision stands out."""
    wrongly = [not row.is_included and (row.measured or 0.0) > budget for row in rows]
    words = [
        f"{shown(row.name, 24)}\n{'NEGLECTED BUT SIGNIFICANT' if wrong else row.decision}"
        for row, wrong in zip(rows, wrongly, strict=True)
    ]
    axes.set_yticks(range(len(rows)), words, fontsize=7.5, linespacing=1.0)
    axes.tick_params(axis="y", length=0)
    for label, wrong in zip(axes.get_yticklabels(), wrongly, strict=True):
        label.set(weight="bold" if wrong else "normal", color=ACCENT if wrong else INK)


def _draw_legend(made: Figure, budget: float, top: float) -> None:
    width, height = made.get_size_inches()
    handles = [
        Patch(facecolor=MEASURED, label="measured"),
        Patch(facecolor=ESTIMATED, label="estimated"),
        Patch(facecolor=INK, label="included: filled"),
        Patch(facecolor="white", edgecolor=INK, hatch=HATCH, label="neglected: hatched"),
        Line2D([], [], **BUDGET_LINE, label=f"requested error: {budget:.3g} mm"),
    ]
    made.legend(
        handles=handles, loc="lower left", ncols=3, borderaxespad=0, columnspacing=1.4,
        bbox_to_anchor=(LEFT / width, (top + 0.08) / height),
    )  # fmt: skip
