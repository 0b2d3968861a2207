"""`sweep.png`: one metric of a sweep, as lines, as a heat map, or key by key."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import PICTURE_UNITS
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sweep_table import FAILED, Sweep, SweptColumn, value_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

METRIC_UNITS = {"m": ("mm", 1e3), "m2": ("cm²", 1e4), "s": ("s", 1.0)}
"""Last word of a metric -> what a picture shows, and how many of these it is."""


@dataclass(frozen=True)
class SweepLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.85
    bottom: float = 0.62
    width: float = 5.2
    height: float = 3.4
    bar_room: float = 0.95
    right: float = 0.25
    panel: float = 1.75
    least_panel: float = 1.2
    panel_gap: float = 0.42


IN = SweepLayout()
MAX_PANELS, ACROSS = 12, 4
MAX_TICKS = 8
MAX_MEANS = 10


def draw_sweep(sweep: Sweep, metric: str, path: Path) -> None:
    """Lines for one key, a heat map for the grid of two, else the metric against every key."""
    if len(sweep.columns) == 1:
        _draw_line(sweep, metric, path)
    elif len(sweep.columns) == 2 and sweep.sample is None:
        _draw_map(sweep, metric, path)
    else:
        _draw_keys(sweep, metric, path)


# -- one key --------------------------------------------------------------------------


def _draw_line(sweep: Sweep, metric: str, path: Path) -> None:
    width, height = (
        look().across(IN.left + IN.width + IN.right),
        IN.bottom + IN.height + title_room(),
    )
    (column,), values = sweep.columns, _values(sweep, metric)
    with picture(path, width, height) as made:
        axes = axes_at(made, IN.left, IN.bottom, width - IN.left - IN.right, IN.height)
        places = _places(sweep, 0)
        order = np.argsort(places, kind="stable")
        axes.plot(places[order], values[order], "o-", color=look().main, ms=3.5, lw=1.2)
        _label_axis(axes, column, "x", _is_spread(column))
        axes.set_ylabel(_metric_words(metric))
        axes.grid(color=look().grid, lw=0.6)
        _mark_failures(axes, sweep, places)
        _title(made, sweep, metric)


def _mark_failures(axes: Axes, sweep: Sweep, places: np.ndarray) -> None:
    """A cross at the bottom for every row that failed."""
    rows = [found.row for found in sweep.failures]
    if rows:
        axes.plot(
            places[rows], [0.02] * len(rows), "x", color=look().accent, ms=5, clip_on=False,
            transform=axes.get_xaxis_transform(), label="failed",
        )  # fmt: skip
        axes.legend(loc="best")


# -- two keys -------------------------------------------------------------------------


def _draw_map(sweep: Sweep, metric: str, path: Path) -> None:
    """The first key upwards, the second across; what failed is crossed out."""
    width, height = (
        look().across(IN.left + IN.width + IN.bar_room),
        IN.bottom + IN.height + title_room(),
    )
    up, across = sweep.columns
    counts = [len(column.values or ()) for column in (up, across)]
    with picture(path, width, height) as made:
        axes = axes_at(made, IN.left, IN.bottom, width - IN.left - IN.bar_room, IN.height)
        table = np.ma.masked_invalid(_values(sweep, metric).reshape(counts))
        shown_map = axes.pcolormesh(
            np.arange(counts[1] + 1), np.arange(counts[0] + 1), table, cmap=look().sequential
        )
        for found in sweep.failures:
            row, place = divmod(found.row, counts[1])
            axes.plot(place + 0.5, row + 0.5, "x", color=look().accent, ms=5)
        _ticks(axes, across, "x", 0.5)
        _ticks(axes, up, "y", 0.5)
        bar = axes_at(made, width - IN.bar_room + 0.15, IN.bottom, 0.14, IN.height)
        made.colorbar(shown_map, cax=bar).set_label(_metric_words(metric))
        _title(made, sweep, metric)


# -- more -----------------------------------------------------------------------------


def _draw_keys(sweep: Sweep, metric: str, path: Path) -> None:
    """The metric against each key, those first that it follows most."""
    values = _values(sweep, metric)
    order = sorted(range(len(sweep.columns)), key=lambda k: -_dependence(_places(sweep, k), values))
    order = order[:MAX_PANELS]
    natural = IN.left + min(ACROSS, len(order)) * (IN.panel + IN.panel_gap)
    width = look().across(natural)
    across = max(
        1, min(len(order), int((width - IN.left) / (IN.least_panel + IN.panel_gap)), ACROSS)
    )
    panel = (width - IN.left) / across - IN.panel_gap
    down = math.ceil(len(order) / across)
    height = down * (IN.panel + IN.bottom) + title_room() + 0.1
    with picture(path, width, height) as made:
        for place, k in enumerate(order):
            row, column = divmod(place, across)
            left, bottom = IN.left + column * (panel + IN.panel_gap), height - title_room() - 0.1
            axes = axes_at(
                made, left, bottom - row * (IN.panel + IN.bottom) - IN.panel, panel, IN.panel
            )
            _draw_key(axes, sweep, k, values)
            if column == 0:
                axes.set_ylabel(_metric_words(metric))
        left_out = len(sweep.columns) - len(order)
        _title(
            made, sweep, metric, f" ({left_out} keys with less effect not shown)" * (left_out > 0)
        )


def _draw_key(axes: Axes, sweep: Sweep, k: int, values: np.ndarray) -> None:
    column, places = sweep.columns[k], _places(sweep, k)
    axes.plot(places, values, ".", color=look().main, ms=2.0, alpha=0.5, rasterized=True)
    middles, means = _running_mean(places, values)
    axes.plot(middles, means, color=look().accent, lw=1.4)
    _label_axis(axes, column, "x", _is_spread(column))
    axes.xaxis.label.set_fontsize(7)
    axes.tick_params(labelsize=6.5)


def _running_mean(places: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Means of the metric at each value of a key, or over equal parts of its rows."""
    known = np.isfinite(values)
    places, values = places[known], values[known]
    order = np.argsort(places, kind="stable")
    starts = np.flatnonzero(np.diff(places[order])) + 1
    if len(starts) >= MAX_MEANS:
        parts = np.array_split(order, max(2, min(MAX_MEANS, len(order) // 10)))
    else:
        parts = np.split(order, starts)
    pairs = [(places[own].mean(), values[own].mean()) for own in parts if own.size]
    found = np.array(pairs).reshape(-1, 2)
    return found[:, 0], found[:, 1]


def _dependence(places: np.ndarray, values: np.ndarray) -> float:
    """Spread of the running mean: how much a metric follows a key."""
    _, means = _running_mean(places, values)
    return float(np.ptp(means)) if means.size else 0.0


# -- shared ---------------------------------------------------------------------------


def _values(sweep: Sweep, metric: str) -> np.ndarray:
    """The metric of every row in the unit of the picture; NaN where there is none."""
    k, (_, factor) = METRIC_NAMES.index(metric), METRIC_UNITS[metric.rpartition("_")[2]]
    found = np.full(len(sweep.designs), np.nan)
    for row, result in sweep.results.items():
        if result.status != FAILED:
            found[row] = factor * result.metrics[k]
    return found


def _places(sweep: Sweep, k: int) -> np.ndarray:
    """Where each row stands on the axis of a key: its number, or the place of its word."""
    column, given = sweep.columns[k], [design[k] for design in sweep.designs]
    if column.is_number:
        return np.array(given, dtype=float) * _unit(column)[1]
    words = list(dict.fromkeys(column.values or given))
    return np.array([words.index(value) for value in given], dtype=float)


def _unit(column: SweptColumn) -> tuple[str, float]:
    unit = column.unit or "1"
    return PICTURE_UNITS.get(unit, (unit, 1.0))


def _is_spread(column: SweptColumn) -> bool:
    """Whether its values spread over more than a decade in about equal ratios."""
    values = column.values
    if column.scale == "log":
        return True
    if not column.is_number or values is None or len(values) < 3 or min(values) <= 0:
        return False
    ratios = np.diff(np.log(np.sort(np.array(values, dtype=float))))
    return bool(max(values) > 10 * min(values) and np.ptp(ratios) < 0.5 * ratios.mean())


def _label_axis(axes: Axes, column: SweptColumn, axis: str, is_log: bool) -> None:
    if not column.is_number:
        _ticks(axes, column, axis, 0.0)
        return
    unit, _ = _unit(column)
    words = column.key if unit == "1" else f"{column.key} [{unit}]"
    axes.set(**{f"{axis}label": shown(words, 44)})
    if is_log:
        axes.set(**{f"{axis}scale": "log"})
        own = axes.xaxis if axis == "x" else axes.yaxis
        own.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=MAX_TICKS))
        own.set_major_formatter(StrMethodFormatter("{x:g}"))
        own.set_minor_formatter(NullFormatter())


def _ticks(axes: Axes, column: SweptColumn, axis: str, offset: float) -> None:
    """Values as words along an axis, some of them where they are many."""
    values: Sequence[Any] = column.values or ()
    step = math.ceil(len(values) / MAX_TICKS)
    unit, factor = _unit(column)
    words = [
        f"{factor * value:.3g}" if isinstance(value, float) else shown(value_words(value, None), 14)
        for value in values
    ]
    places = [k + offset for k in range(0, len(values), step)]
    axes.set(**{f"{axis}ticks": places, f"{axis}ticklabels": words[::step]})
    axes.set(**{f"{axis}label": column.key if unit == "1" else f"{column.key} [{unit}]"})


def _metric_words(metric: str) -> str:
    name, _, word = metric.rpartition("_")
    return f"{name} [{METRIC_UNITS[word][0]}]"


def _title(made: Figure, sweep: Sweep, metric: str, more: str = "") -> None:
    count, failed, missing = len(sweep.designs), len(sweep.failures), len(sweep.missing)
    words = f"{_metric_words(metric)} of {count} designs{more}"
    words += f", {failed} failed" * (failed > 0) + f", {missing} missing" * (missing > 0)
    draw_title(made, f"{shown(sweep.name, 40)}: {words}", 0.1)
