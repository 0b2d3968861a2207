"""`fit.png`: what was measured and what the fitted numbers make of it, and all that is left."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import PICTURE_UNITS
from viscodesign.results.fit_result import Fit, FittedRun

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class FitLayout:
    """Lengths of the picture [inch]."""

    left: float = 1.35
    run_width: float = 4.2
    gap: float = 1.1
    right: float = 0.75
    least_run_width: float = 1.5
    bottom: float = 0.5
    map_height: float = 1.3
    row_height: float = 0.115
    curve_height: float = 1.15
    panel_gap: float = 0.12
    header_room: float = 0.2


IN = FitLayout()
MAX_RUNS = 3
"""Recordings that are drawn side by side."""
REACH = 4.0
"""Standard deviations at which the colours of residuals end."""


def draw_fit(found: Fit, path: Path) -> None:
    """A column a recording: the last marker over time, and residuals of all channels."""
    natural = IN.left + min(len(found.runs), MAX_RUNS) * (IN.run_width + IN.gap) - IN.gap + IN.right
    width = look().across(natural)
    fitting = int((width - IN.left - IN.right + IN.gap) / (IN.least_run_width + IN.gap))
    runs = found.runs[: min(MAX_RUNS, max(1, fitting))]
    run_width = (width - IN.left - IN.right + IN.gap) / len(runs) - IN.gap
    rows = max(len(run.headers) for run in runs)
    map_height = max(IN.map_height, IN.row_height * rows)
    curves = max(len(_drawn(run)) for run in runs)
    height = (
        IN.bottom
        + map_height
        + curves * (IN.curve_height + IN.panel_gap)
        + IN.header_room
        + title_room()
    )
    with picture(path, width, height) as made:
        for k, run in enumerate(runs):
            left = IN.left + k * (run_width + IN.gap)
            image = _draw_map(axes_at(made, left, IN.bottom, run_width, map_height), run)
            if k == len(runs) - 1:
                _draw_key(made, image, left + run_width + 0.08, map_height)
            bottom = IN.bottom + map_height + IN.panel_gap
            for place in _drawn(run):
                _draw_curve(axes_at(made, left, bottom, run_width, IN.curve_height), run, place)
                bottom += IN.curve_height + IN.panel_gap
            words = shown(
                " ".join([Path(run.file).name, *run.overrides]), int(14 * (run_width + IN.right))
            )
            made.text(left / width, (bottom + 0.02) / height, words, size=8, color=look().note)
        more = len(found.runs) - len(runs)
        title = (
            f"{shown(found.name, 40)}: measured and fitted{f', and {more} more' if more else ''}"
        )
        if found.mismatch is not None:
            title = f"{shown(found.name, 40)}: the model does not describe the recording"
        draw_title(made, title, 0.1)


def _drawn(run: FittedRun) -> list[int]:
    """Channels that are drawn over time, from below: the last marker, pressure, volume."""
    places = [k for k, unit in enumerate(run.units) if unit == "m"]
    return [*places[-2:][::-1], *(k for k, unit in enumerate(run.units) if unit == "m^3")]


def _draw_curve(axes: Axes, run: FittedRun, place: int) -> None:
    unit, factor = PICTURE_UNITS[run.units[place]]
    measured, kept = factor * run.measured[:, place], run.kept[:, place]
    gross = np.isfinite(measured) & ~kept
    axes.plot(run.time[kept], measured[kept], ".", ms=2.5, color=look().faint, label="measured")
    if gross.any():
        axes.plot(
            run.time[gross],
            measured[gross],
            "x",
            ms=4,
            color=look().accent,
            label="gross, left out",
        )
    axes.plot(run.time, factor * run.expected[:, place], color=look().ink, lw=0.9, label="fitted")
    axes.set_ylabel(f"{_bare(run.headers[place])} [{unit}]", fontsize=7.5)
    axes.set_xlim(run.time[0], run.time[-1])
    axes.tick_params(labelbottom=False)
    if place == _drawn(run)[0]:
        axes.legend(fontsize=6.5, loc="best", markerscale=1.5)


def _bare(header: str) -> str:
    """A header without its unit."""
    name, _, unit = header.rpartition("_")
    return shown(name if name and len(unit) <= 3 else header, 22)


def _draw_map(axes: Axes, run: FittedRun) -> object:
    """Residuals of every channel and row."""
    residuals = np.where(run.kept, run.residuals, np.nan).T
    edges = np.concatenate([[run.time[0]], (run.time[1:] + run.time[:-1]) / 2, [run.time[-1]]])
    image = axes.pcolormesh(
        edges,
        np.arange(len(run.headers) + 1),
        np.ma.masked_invalid(residuals),
        cmap=look().diverging,
        vmin=-REACH,
        vmax=REACH,
        rasterized=True,
    )
    gross = np.isfinite(run.measured) & ~run.kept
    rows, channels = np.nonzero(gross)
    axes.plot(run.time[rows], channels + 0.5, "x", ms=2.5, mew=0.6, color=look().accent)
    axes.set_ylim(len(run.headers), 0)
    axes.set_yticks(
        np.arange(len(run.headers)) + 0.5, [_bare(h) for h in run.headers], fontsize=5.5
    )
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("time [s]")
    return image


def _draw_key(made: Figure, image: object, left: float, height: float) -> None:
    axes = axes_at(made, left, IN.bottom, 0.1, height)
    made.colorbar(image, cax=axes)  # type: ignore[arg-type]
    axes.set_ylabel("measured - fitted [sd of the noise]", fontsize=6.5)
    axes.tick_params(labelsize=6.5)
