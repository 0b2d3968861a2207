"""The plane of the paper's Figure 1: which timescale dominates."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.label_placement import HALF_LINE, Box, place_labels, text_box
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, picture, shown
from viscodesign.results.findings import Classification

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WORDS = {
    "I": "I  uniform pressure,\nsolid inertia",
    "II": "II  distributed pressure,\nfast input",
    "III": "III  distributed pressure,\ninput as slow as the fluid",
    "IV": "IV  uniform pressure,\nquasi-static",
}
CORNERS = {"I": (1, 1), "II": (0, 1), "III": (0, 0), "IV": (1, 0)}


@dataclass(frozen=True)
class QuadrantsLayout:
    """Lengths of the picture [inch].

    The key goes below where it would leave a plane less than the least size.
    """

    left: float = 0.72
    bottom: float = 0.55
    size: float = 4.6
    above: float = 0.15
    right: float = 0.2
    key_width: float = 2.2
    key_line: float = 0.16
    least_size: float = 3.4


IN = QuadrantsLayout()
WORDS_SIZE, NARROW_WORDS_SIZE = 8.5, 6.5
"""Letters of the words in the quadrants [pt]; the second size on a smaller plane."""
LARGEST_DECADE = 9
"""Ratios beyond ten to this, up or down, are drawn at the edge."""
EDGE_DISTANCE = 0.022
"""Distance of what lies outside from the edge, of the plane's side."""
SAME_PLACE = 0.004
"""Points nearer than this, of the plane's side, are one mark."""
TOLD_COLUMNS = 17
"""Characters of a line below the plane, for an inch."""
MAX_NAMED_MARKS, MAX_NAMES_PER_MARK = 5, 3
"""So many marks, of so many names, have the names themselves beside them; more have numbers."""


@dataclass(frozen=True)
class Mark:
    """One or more specs at one place of the plane, relative to its sides."""

    x: float
    y: float
    symbol: str
    names: tuple[str, ...]


def draw_plane(
    classifications: Sequence[Classification],
    path: Path,
    beside: Mapping[str, str] | None = None,
    told: Sequence[str] = (),
) -> None:
    """Log-log, four quadrants, every spec named; png, pdf or svg by the ending.

    ``beside``: words under those of a quadrant; ``told``: lines below the plane, of which all but
    the first warn.
    """
    places = [_place(found) for found in classifications]
    decades = (_decades([x for x, _ in places]), _decades([y for _, y in places]))
    marks = _marks(classifications, places, decades)
    direct = len(marks) <= MAX_NAMED_MARKS and all(
        len(mark.names) <= MAX_NAMES_PER_MARK for mark in marks
    )
    width = look().across(IN.left + IN.size + (IN.right if direct else IN.key_width))
    is_beside = not direct and width - IN.left - IN.key_width >= IN.least_size
    size = min(IN.size, width - IN.left - (IN.key_width if is_beside else IN.right))
    below = 0.0 if direct or is_beside else 0.1 + IN.key_line * _key_lines(marks)
    lines = [line for text in told for line in textwrap.wrap(text, int(TOLD_COLUMNS * width))]
    foot = IN.key_line * len(lines) + (0.1 if lines else 0.0)
    with picture(path, width, foot + below + IN.bottom + size + IN.above) as made:
        _write_told(made, lines, foot)
        axes = axes_at(made, IN.left, foot + below + IN.bottom, size, size)
        axes.set(xlim=(0, 1), ylim=(0, 1))
        words = _draw_quadrants(axes, decades, beside or {}, size)
        _draw_ticks(axes, decades)
        texts = ["\n".join(m.names) if direct else str(k + 1) for k, m in enumerate(marks)]
        _draw_marks(axes, marks, texts, words, size)
        if not direct:
            place = (IN.left + size + 0.15, foot + IN.bottom, size)
            if not is_beside:
                place = (IN.left, foot + 0.05, below - 0.05)
            _draw_key(made, marks, *place)


def _write_told(made: Figure, lines: Sequence[str], top: float) -> None:
    """Lines from a height [inch] down; all but the first warn."""
    width, height = made.get_size_inches()
    for k, line in enumerate(lines):
        at = top - IN.key_line * (k + 1)
        colour = look().warning if k else look().ink
        made.text(0.1 / width, at / height, line, size=7.5, color=colour)


def _place(found: Classification) -> tuple[float, float]:
    """Decimal logarithms of t_s/t_f and t_s/t_i; infinite for a ratio of 0 or infinity."""
    ratios = found.scales.ratios
    x, y = (
        math.log10(ratio) if ratio > 0 else -math.inf
        for ratio in (ratios["ts_over_tf"], ratios["ts_over_ti"])
    )
    return x, y


def _decades(logarithms: list[float]) -> tuple[int, int]:
    """Whole decades that hold every point of reason, two at least on either side of one."""
    near = [value for value in logarithms if abs(value) <= LARGEST_DECADE]
    return (
        min([-2, *(math.floor(value - 0.3) for value in near)]),
        max([2, *(math.ceil(value + 0.3) for value in near)]),
    )


def _marks(
    classifications: Sequence[Classification],
    places: list[tuple[float, float]],
    decades: tuple[tuple[int, int], tuple[int, int]],
) -> list[Mark]:
    """Specs at one place become one mark; marks are sorted from the top, then from the left."""
    marks: list[Mark] = []
    for found, place in zip(classifications, places, strict=True):
        x, y = (_inside(value, ends) for value, ends in zip(place, decades, strict=True))
        symbol = _symbol(place, decades)
        name = shown(found.name, 32)
        for k, mark in enumerate(marks):
            if symbol == mark.symbol and math.hypot(x - mark.x, y - mark.y) < SAME_PLACE:
                marks[k] = Mark(mark.x, mark.y, symbol, (*mark.names, name))
                break
        else:
            marks.append(Mark(x, y, symbol, (name,)))
    return sorted(marks, key=lambda mark: (-round(mark.y, 2), mark.x))


def _inside(logarithm: float, ends: tuple[int, int]) -> float:
    part = (logarithm - ends[0]) / (ends[1] - ends[0])
    return float(np.clip(part, EDGE_DISTANCE, 1 - EDGE_DISTANCE))


def _symbol(place: tuple[float, float], decades: tuple[tuple[int, int], tuple[int, int]]) -> str:
    """A dot, or an arrow out of the plane."""
    (x, y), ((left, right), (bottom, top)) = place, decades
    if y < bottom or y > top:
        return "v" if y < bottom else "^"
    if x < left or x > right:
        return "<" if x < left else ">"
    return "o"


def _draw_quadrants(
    axes: Axes,
    decades: tuple[tuple[int, int], tuple[int, int]],
    beside: Mapping[str, str],
    size: float,
) -> list[Box]:
    """Draw them; return the room of their words and of the lines between them."""
    x, y = (-low / (high - low) for low, high in decades)
    axes.fill_between([x, 1], y, 1, color=look().shade, lw=0)
    axes.fill_between([0, x], 0, y, color=look().shade, lw=0)
    axes.axhline(y, color=look().faint, lw=1)
    axes.axvline(x, color=look().faint, lw=1)
    boxes = [
        Box(x - HALF_LINE, 0, x + HALF_LINE, 1, faint=True),
        Box(0, y - HALF_LINE, 1, y + HALF_LINE, faint=True),
    ]
    letters = WORDS_SIZE if size >= IN.least_size else NARROW_WORDS_SIZE
    for quadrant, (right, up) in CORNERS.items():
        place = (0.98 if right else 0.02, 0.98 if up else 0.02)
        across, upright = "right" if right else "left", "top" if up else "bottom"
        words = "\n".join(filter(None, (WORDS[quadrant], beside.get(quadrant))))
        axes.text(*place, words, ha=across, va=upright, fontsize=letters, color=look().note)
        boxes.append(text_box(words, place, across, upright, letters, size))
    return boxes


def _draw_ticks(axes: Axes, decades: tuple[tuple[int, int], tuple[int, int]]) -> None:
    for side, (low, high) in zip((axes.xaxis, axes.yaxis), decades, strict=True):
        step = -(-(high - low) // 8)
        major = [k for k in range(low, high + 1) if k % step == 0]
        side.set_ticks([(k - low) / (high - low) for k in major], [power_of_ten(k) for k in major])
        minor = [
            (k + math.log10(m) - low) / (high - low) for k in range(low, high) for m in range(1, 10)
        ]
        side.set_ticks(minor if step == 1 else [], minor=True)
    axes.set_xlabel("$t_s\\,/\\,t_f$   (solid over fluid)", parse_math=True)
    axes.set_ylabel("$t_s\\,/\\,t_i$   (solid over input)", parse_math=True)


def power_of_ten(exponent: int) -> str:
    """10 with its exponent above the line: 10⁻³."""
    return "10" + str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def _draw_marks(
    axes: Axes, marks: list[Mark], texts: list[str], words: list[Box], size: float
) -> None:
    for mark in marks:
        axes.plot(
            mark.x, mark.y, marker=mark.symbol, color=look().accent, mec=look().ink, mew=0.6,
            ms=6.5, ls="none", zorder=4,
        )  # fmt: skip
    points = [(mark.x, mark.y) for mark in marks]
    for label in place_labels(points, texts, words, size=8.0, side=size):
        if label.step > 0:
            ends = ([label.point[0], label.x], [label.point[1], label.y])
            axes.plot(*ends, color=look().grey, lw=0.6, zorder=3)
        axes.text(
            label.x, label.y, label.text, ha=label.across, va=label.upright, fontsize=8.0, zorder=5,
            linespacing=1.15,
        )  # fmt: skip


def _key_lines(marks: list[Mark]) -> float:
    """Height of the key in lines: every name, and a gap between marks."""
    return sum(len(mark.names) for mark in marks) + 0.4 * (len(marks) - 1)


def _draw_key(made: Figure, marks: list[Mark], left: float, bottom: float, height: float) -> None:
    """Numbers and names in a column, in the order of the marks' height; its place in inches."""
    step = min(IN.key_line, height / max(_key_lines(marks), 1.0))
    size = min(8.0, step * 72 / 1.2)
    axes = axes_at(made, left, bottom, IN.key_width - 0.2, height)
    axes.set(xlim=(0, IN.key_width - 0.2), ylim=(height, 0))
    axes.set_axis_off()
    down = step / 2
    for k, mark in enumerate(marks):
        axes.text(0.16, down, str(k + 1), ha="right", va="center", size=size, weight="bold")
        for name in mark.names:
            axes.text(0.24, down, name, va="center", size=size)
            down += step
        down += 0.4 * step
