"""A figure of the paper: the plane of timescales, or panels of paths and what they show."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.charts.compare import draw_paths, frame_about
from viscodesign.report.charts.quadrants import draw_plane
from viscodesign.report.charts.tip_path import draw_path
from viscodesign.report.layout.bellow_blocks import body_widths
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import line_style
from viscodesign.report.layout.snapshots import outline, spread_instants
from viscodesign.report.layout.style import axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import channel
from viscodesign.results.paper_figure import FigurePanel, PaperCheck, PaperFigure
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class FigureLayout:
    """Lengths of the picture [inch].

    A row of panels has a title, a square, room for its axis, and lines of words.
    """

    left: float = 0.72
    side: float = 3.5
    gap: float = 1.0
    right: float = 0.25
    title: float = 0.3
    axis: float = 0.5
    line: float = 0.145
    padding: float = 0.25
    least_side: float = 2.2
    """Of a panel with another beside it."""


IN = FigureLayout()
STILL_SHARE = 1e-6
"""Way of the tip, in lengths of the actuator, below which it is steady."""
INSTANTS = 6
"""Shapes drawn along the path of a single run."""
COLUMNS = 20
"""Characters of a line of words below a panel, for an inch of its side."""
HEAD_COLUMNS = 16
"""The same of a line above all panels."""
MAX_NAME = 30


@dataclass(frozen=True, eq=False)
class DrawnPath:
    """A path with its name in the key."""

    title: str
    tip: np.ndarray
    """(T, 2) [m]"""


def draw_figure(found: PaperFigure, path: Path) -> None:
    """Draw a figure; png, pdf or svg by the ending."""
    if not found.panels:
        differing = [
            f"{check.verdict}: the paper has {check.words}, the model {check.found}"
            for check in found.checks
            if check.agrees is False
        ]
        told = [f"{found.agreement[0].upper()}{found.agreement[1:]}", *differing]
        draw_plane(found.classifications, path, found.beside, told)
        return
    width = look().across(IN.left + 2 * IN.side + IN.gap + IN.right)
    side, count = (width - IN.left - IN.gap - IN.right) / 2, 2
    if side < IN.least_side:
        side, count = width - IN.left - IN.right, 1
    rows = [found.panels[k : k + count] for k in range(0, len(found.panels), count)]
    texts = [[_lines(found, panel, side) for panel in row] for row in rows]
    heights = [
        IN.title + side + IN.axis + IN.line * max(len(own) for own in row) + IN.padding
        for row in texts
    ]
    top, lines = sum(heights), _head_lines(found, width)
    around = _shared_frame(found)
    with picture(path, width, top + IN.line * len(lines) + title_room()) as made:
        draw_title(made, shown(_title(found), 120), IN.left)
        _write_lines(made, lines, IN.left, top + IN.line * len(lines))
        for row, words, tall in zip(rows, texts, heights, strict=True):
            for k, panel in enumerate(row):
                left = IN.left + k * (side + IN.gap)
                _draw_panel(made, panel, words[k], left, top, side, around)
            top -= tall


def _title(found: PaperFigure) -> str:
    changed = f" ({', '.join(found.changes)})" if found.changes else ""
    return f"Figure {found.number}: {found.title}{changed}"


def _head_lines(found: PaperFigure, width: float) -> list[tuple[str, str]]:
    """How many statements agree, and which runs leave their model, each line with its colour."""
    told = [(f"{found.agreement[0].upper()}{found.agreement[1:]}", look().ink)]
    if found.outside:
        words = f"Outside of what the model describes: {', '.join(found.outside)}"
        told.append((words, look().warning))
    most = int(HEAD_COLUMNS * (width - IN.left))
    return [(line, colour) for text, colour in told for line in textwrap.wrap(text, most)]


def _shared_frame(found: PaperFigure) -> np.ndarray:
    """Points (n, 2) [mm] about all panels of one moving run: these are to be compared."""
    single = [p.runs[0] for p in found.panels if len(p.runs) == 1 and not _is_still(p.runs[0])]
    points = [1e3 * _bodies(run).reshape(-1, 2) for run in single]
    return np.concatenate([np.empty((0, 2)), *points])


def _bodies(run: Trajectory) -> np.ndarray:
    """Outlines (n, M, 2) along the path of a run [m]."""
    return outline(run.shape[spread_instants(run, INSTANTS)], body_widths(run))


def _lines(found: PaperFigure, panel: FigurePanel, side: float) -> list[tuple[str, str]]:
    """Words below a panel, each line with its colour."""
    lines = [
        (line, look().ink if check.agrees else look().warning)
        for check in found.of_panel(panel.name)
        for line in _wrapped(_words(check), side)
    ]
    assumed = f"Assumed: {panel.assumed}." if panel.assumed else ""
    return lines + [(line, look().note) for line in _wrapped(assumed, side)]


def _words(check: PaperCheck) -> str:
    return f"{check.verdict}: {check.words}: {check.found}"


def _wrapped(text: str, side: float) -> list[str]:
    return textwrap.wrap(text, int(COLUMNS * (side + IN.left / 2)), subsequent_indent="    ")


def _draw_panel(
    made: Figure,
    panel: FigurePanel,
    words: list[tuple[str, str]],
    left: float,
    top: float,
    side: float,
    around: np.ndarray,
) -> None:
    width, height = made.get_size_inches()
    title = f"{panel.name}  {panel.title}"
    made.text(left / width, (top - 0.19) / height, title, size=9.5, weight="bold")
    bottom = top - IN.title - side
    axes = axes_at(made, left, bottom, side, side)
    if panel.runs:
        _draw_runs(axes, panel.runs, around)
    _write_lines(made, words, left - 0.35, bottom - IN.axis)


def _write_lines(made: Figure, lines: list[tuple[str, str]], left: float, top: float) -> None:
    """Lines of words from a place [inch] down."""
    width, height = made.get_size_inches()
    for k, (line, colour) in enumerate(lines):
        at = top - IN.line * (k + 0.6)
        made.text(left / width, at / height, line, size=7.2, color=colour)


def _draw_runs(axes: Axes, runs: tuple[Trajectory, ...], around: np.ndarray) -> None:
    """Steady actuators themselves, one moving one coloured by time, or several paths.

    ``around``: points (n, 2) [mm] that the frame of a moving one holds, too.
    """
    if all(_is_still(run) for run in runs):
        still = [outline(run.shape[-1:], body_widths(run)) for run in runs]
        _draw_bodies(axes, still, np.empty((0, 2)))
        for k, run in enumerate(runs):
            axis, colour = 1e3 * run.shape[-1], line_style(k).colour
            axes.plot(*axis.T, color=colour, lw=1.8, zorder=4, label=shown(run.name, MAX_NAME))
            axes.plot(*axis[-1], marker="o", ms=5, mfc=look().ground, mec=colour, zorder=5)
    elif len(runs) == 1:
        run = runs[0]
        _draw_bodies(axes, [_bodies(run)], around)
        lines = draw_path(axes, run, 0.8)
        bar = axes.figure.colorbar(lines, cax=axes.inset_axes((0.03, 0.03, 0.025, 0.28)))
        bar.set_label(channel("time").label, size=7)
        bar.ax.tick_params(labelsize=6.5)
        bar.outline.set_visible(False)
        return
    else:
        draw_paths(axes, [DrawnPath(shown(run.name, MAX_NAME), run.tip[:, :2]) for run in runs])
    axes.legend(
        loc="best", fontsize=7, handlelength=1.6, frameon=True, framealpha=0.8, edgecolor="none"
    )


def _is_still(run: Trajectory) -> bool:
    return float(np.ptp(run.tip[:, :2], axis=0).max()) <= STILL_SHARE * run.length


def _draw_bodies(axes: Axes, bodies: list[np.ndarray], around: np.ndarray) -> None:
    """Outlines (n, M, 2) [m] in light grey, in a frame about all of them and other points."""
    every = 1e3 * np.concatenate(bodies)
    frame_about(axes, np.concatenate([every.reshape(-1, 2), around]))
    axes.add_collection(
        PolyCollection(
            list(every), facecolors=look().body, edgecolors=look().faint, lw=0.6, alpha=0.6
        )
    )
