"""The plane of the paper's Figure 1: which timescale rules."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.report.style import ACCENT, FAINT, INK, picture
from viscodesign.trajectory import Classification

if TYPE_CHECKING:
    from matplotlib.axes import Axes

WORDS = {
    "I": (0.98, 0.97, "right", "top", "I  uniform pressure,\nthe solid's inertia"),
    "II": (0.02, 0.97, "left", "top", "II  pressure distribution,\nsteep input"),
    "III": (
        0.02,
        0.03,
        "left",
        "bottom",
        "III  pressure distribution,\ninput as slow as the fluid",
    ),
    "IV": (0.98, 0.03, "right", "bottom", "IV  uniform pressure,\nquasi-static"),
}
SMALLEST, LARGEST = 1e-9, 1e9


def draw_plane(classifications: Sequence[Classification], path: Path) -> None:
    """Log-log, four quadrants, every spec a labelled point; png, pdf or svg by the ending."""
    with picture(path, 6.4, 5.0) as made:
        axes = made.add_axes((0.12, 0.12, 0.8, 0.84))
        places = [_place(c) for c in classifications]
        limits = _limits(places)
        axes.set(xscale="log", yscale="log", xlim=limits[0], ylim=limits[1])
        _draw_quadrants(axes, limits)
        _draw_points(axes, classifications, places, limits)
        axes.set_xlabel("t_s / t_f   (solid over fluid)")
        axes.set_ylabel("t_s / t_i   (solid over input)")


def _place(found: Classification) -> tuple[float, float]:
    ratios = found.scales.ratios
    return ratios["ts_over_tf"], ratios["ts_over_ti"]


def _limits(places: list[tuple[float, float]]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Decades that hold every finite point, two at least on both sides of one."""
    spans = []
    for k in (0, 1):
        finite = [p[k] for p in places if math.isfinite(p[k]) and SMALLEST <= p[k] <= LARGEST]
        low = min([0.0, *(math.log10(v) for v in finite)])
        high = max([0.0, *(math.log10(v) for v in finite)])
        spans.append(
            (10 ** (min(-2, math.floor(low - 0.5))), 10 ** (max(2, math.ceil(high + 0.5))))
        )
    return spans[0], spans[1]


def _draw_quadrants(axes: Axes, limits: tuple[tuple[float, float], tuple[float, float]]) -> None:
    (left, right), (bottom, top) = limits
    axes.fill_between([1, right], 1, top, color="#f4f4f4", lw=0)
    axes.fill_between([left, 1], bottom, 1, color="#f4f4f4", lw=0)
    axes.axhline(1, color=FAINT, lw=1)
    axes.axvline(1, color=FAINT, lw=1)
    for x, y, across, up, words in WORDS.values():
        axes.text(
            x, y, words, transform=axes.transAxes, ha=across, va=up, fontsize=9, color="#555555"
        )


def _draw_points(
    axes: Axes,
    classifications: Sequence[Classification],
    places: list[tuple[float, float]],
    limits: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    groups: dict[tuple[float, float], list[str]] = {}
    for found, place in zip(classifications, places, strict=True):
        shown = (_inside(place[0], limits[0]), _inside(place[1], limits[1]))
        key = (round(math.log10(shown[0]), 1), round(math.log10(shown[1]), 1))
        groups.setdefault(key, []).append(found.name)
        markers = {-1: "v" if place[1] < limits[1][0] else "<", 1: "^", 0: "o"}
        outside = _outside(place, limits)
        axes.plot(
            *shown,
            marker=markers[outside],
            color=ACCENT,
            mec=INK,
            mew=0.6,
            ms=7,
            ls="none",
            zorder=4,
        )
    _label(axes, groups, limits)


def _inside(value: float, limit: tuple[float, float]) -> float:
    edge = 10 ** (0.02 * math.log10(limit[1] / limit[0]))
    return float(np.clip(value, limit[0] * edge, limit[1] / edge))


def _outside(
    place: tuple[float, float], limits: tuple[tuple[float, float], tuple[float, float]]
) -> int:
    if place[0] < limits[0][0] or place[1] < limits[1][0]:
        return -1
    return 1 if place[0] > limits[0][1] or place[1] > limits[1][1] else 0


def _label(
    axes: Axes,
    groups: dict[tuple[float, float], list[str]],
    limits: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    """Names in a column beside the plane, in the order of their points' height.

    Specs at one place share a line to it, so that many stay legible.
    """
    (left, right), (bottom, top) = ((math.log10(a), math.log10(b)) for a, b in limits)
    count = sum(len(names) for names in groups.values())
    step = min(0.045, 1.0 / max(count + len(groups), 1))
    ordered = sorted(groups.items(), key=lambda item: (-item[0][1], item[0][0]))
    total = step * (count + 0.5 * (len(groups) - 1))
    heights = [(y - bottom) / (top - bottom) for (_, y), _ in ordered]
    place = min(max(float(np.mean(heights)) + total / 2, total), 1.0)
    for (x, y), names in ordered:
        u, v = (x - left) / (right - left), (y - bottom) / (top - bottom)
        middle = place - step * len(names) / 2
        axes.annotate(
            "\n".join(names),
            xy=(u, v),
            xytext=(1.06, middle),
            xycoords="axes fraction",
            textcoords="axes fraction",
            ha="left",
            va="center",
            fontsize=8 if step > 0.03 else 6,
            linespacing=1.15,
            arrowprops={"arrowstyle": "-", "color": "#8a8a8a", "lw": 0.6, "shrinkB": 4},
            zorder=3,
        )
        place -= step * (len(names) + 0.5)
