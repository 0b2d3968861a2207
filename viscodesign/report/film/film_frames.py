"""The frames of a film: the actuator in motion, and its pressures against time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

from viscodesign.report.film.film_plan import TITLE_CHARACTERS, FilmOptions
from viscodesign.report.ground_outline import feet, ground_outline
from viscodesign.report.layout.bellow_blocks import bellow_blocks, section_widths
from viscodesign.report.layout.downsampling import envelope
from viscodesign.report.layout.look import drawn_as, look
from viscodesign.report.layout.pressure_colours import pressure_colours
from viscodesign.report.layout.snapshots import clamp_strokes
from viscodesign.report.layout.style import own_style, shown
from viscodesign.report.layout.tube_lines import MAX_TUBE_LINES, inlet_places, tube_lines
from viscodesign.report.page.page_data import GROUND_REACH
from viscodesign.report.page.shown_rows import shapes_near
from viscodesign.report.page.sketch_numbers import ground_of
from viscodesign.report.picture_options import PictureOptions
from viscodesign.results.findings import outside_words
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes, rows_at

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BANNER_CHARACTERS = 7.5
"""Of a line of a banner, for an inch of the width."""
LEGEND_COLUMN = 1.0
"""Room for a name of the legend [inch]."""
MAX_CURVES = 16
"""Largest number of curves of a column."""


def film_frames(
    run: Trajectory, tubes: list[list[str]], rows: np.ndarray, options: FilmOptions
) -> Iterator[np.ndarray]:
    """Pixels (height, width, 4) of the frames at some rows of a run.

    What does not move is drawn once; ``tubes`` are both ends of every tube.
    """
    with drawn_as(PictureOptions(style=options.style)), own_style():
        made = Figure(figsize=options.figure_size, dpi=options.dots_per_inch)
        canvas: Any = FigureCanvasAgg(made)
        body = _Body(made, run, tubes, rows, options)
        curves = _Curves(made, run) if options.pressures else None
        clock = made.text(0.97, 0.95, "", ha="right", va="top", size=12, animated=True)
        _draw_title(made, run)
        if options.transparent:
            made.patch.set_alpha(0.0)
            for axes in made.axes:
                axes.patch.set_alpha(0.0)
        canvas.draw()
        ground = canvas.copy_from_bbox(made.bbox)
        for row, shape in zip(rows, shapes_near(run, rows), strict=True):
            canvas.restore_region(ground)
            clock.set_text(f"t = {run.time[row]:.{_decimals(run.time)}f} s")
            parts = [*body.at(row, shape), *(curves.at(row) if curves else []), clock]
            for part in parts:
                part.axes.draw_artist(part) if part.axes else made.draw_artist(part)
            yield np.array(canvas.buffer_rgba())


def _decimals(time: np.ndarray) -> int:
    """Decimals of a time by which the output times of a run can be told apart."""
    step = float(time[-1] - time[0]) / max(len(time) - 1, 1)
    return int(np.clip(np.ceil(-np.log10(step) - 1e-9), 0, 9)) if step > 0 else 2


def _draw_title(made: Figure, run: Trajectory) -> None:
    name = shown(run.name, int(TITLE_CHARACTERS * made.get_figwidth()))
    made.text(0.03, 0.95, name, va="top", size=12, weight="bold")
    told = []
    if run.status != "complete":
        told.append(f"run {run.status}, ended at t = {run.time[-1]:.4g} s")
    if run.violations:
        told.append(outside_words(run.violations))
    draw_banner(made, told)


def draw_banner(made: Figure, lines: list[str]) -> None:
    """What a viewer has to know, below the name."""
    columns = int(BANNER_CHARACTERS * made.get_figwidth())
    for k, words in enumerate(lines):
        made.text(
            0.03, 0.895 - 0.055 * k, shown(words, columns), va="top", size=10, weight="bold",
            color=look().ground, bbox={"facecolor": look().accent, "edgecolor": "none", "pad": 3},
        )  # fmt: skip


class _Body:
    """The actuator [mm], z pointing down."""

    def __init__(
        self,
        made: Figure,
        run: Trajectory,
        tubes: list[list[str]],
        rows: np.ndarray,
        options: FilmOptions,
    ) -> None:
        self.run, self.widths = run, 1e3 * section_widths(run)
        self.width = float(np.max(self.widths))
        self.ground = ground_of(run)
        self.tubes = tubes if len(tubes) <= MAX_TUBE_LINES else []
        across = 0.4 if options.pressures else 0.9
        self.axes = made.add_axes((0.03, 0.14, across, 0.74))
        self.axes.set_axis_off()
        self._frame(rows)
        limits = np.hstack([extremes(run.pressure), extremes(run["inlet_pressure"])])
        colours, norm, occurring = pressure_colours(limits)
        edges = look().ink if len(run.bellows) <= 64 else "face"
        self.cells = PolyCollection(
            [], cmap=colours, norm=norm, edgecolors=edges, linewidths=0.6, animated=True
        )
        self.lines = LineCollection([], colors=look().ink, linewidths=1.1, animated=True)
        self.axis = self.axes.plot([], [], color=look().ink, lw=1.2, animated=True)[0]
        self.feet = LineCollection([], colors=look().accent, linewidths=1.2, animated=True)
        self.inlets = inlet_places(run.inlets, tubes, self.width)
        across_mm, down_mm = np.transpose(list(self.inlets.values()))
        self.marks = self.axes.scatter(
            across_mm, down_mm, s=90, marker="v", c=[0.0] * len(run.inlets),
            cmap=colours, norm=norm, edgecolors=look().ink, linewidths=0.8, animated=True,
        )  # fmt: skip
        for part in (self.lines, self.cells, self.feet):
            self.axes.add_collection(part)
        self._still_parts()
        self._bar(made, across, occurring)

    def _frame(self, rows: np.ndarray) -> None:
        """Room for all shapes of the film."""
        every = np.unique(shapes_near(self.run, rows))
        low, high = extremes(1e3 * rows_at(self.run.shape, every).reshape(-1, 2))
        reach = 0.75 * self.width
        left, right = min(low[0], 0) - reach, max(high[0], 0) + reach
        top, bottom = min(low[1] - reach, -0.55 * self.width), high[1] + reach
        self.axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal", anchor="C")

    def _still_parts(self) -> None:
        half, hatch = 0.7 * self.width, 0.14 * self.width
        plate = np.array([[(-half, 0.0), (half, 0.0)]])
        for lines, pen in ((clamp_strokes(half, hatch, 9), 0.8), (plate, 2.0)):
            self.axes.add_collection(LineCollection(list(lines), colors=look().ink, linewidths=pen))
        if self.ground is not None:
            line = 1e3 * ground_outline(self.ground, GROUND_REACH * self.run.length)
            self.axes.plot(
                *line.T, color=look().accent, lw=1.2, ls=(0, (6, 2)), scalex=False, scaley=False
            )
        if len(self.run.time) > 1:
            path = 1e3 * envelope(self.run.time, self.run.tip[:, :2])[1]
            self.axes.plot(path[:, 0], path[:, 1], color=look().faint, lw=1.2, zorder=0)

    def _bar(self, made: Figure, across: float, occurring: tuple[float, float]) -> None:
        place = made.add_axes((0.03 + 0.1 * across, 0.1, 0.8 * across, 0.022))
        bar = made.colorbar(self.cells, cax=place, orientation="horizontal")
        place.set_xlim(*occurring)
        bar.outline.set_visible(False)
        place.set_xlabel("gauge pressure [kPa]", labelpad=1)

    def at(self, row: int, shape: int) -> list[Any]:
        """The moving parts at a row, from below."""
        run = self.run
        axis = 1e3 * run.shape[shape]
        blocks = bellow_blocks(axis[None], 1e3 * run.arc, run.bellows, self.widths)[0]
        self.cells.set_verts(list(blocks))
        self.cells.set_array(run.pressure[row] / 1e3)
        self.axis.set_data(axis[:, 0], axis[:, 1])
        self.lines.set_segments(
            tube_lines(blocks, run.bellows, self.inlets, self.tubes, self.width)
        )
        self.marks.set_array(run["inlet_pressure"][row] / 1e3)
        if self.ground is not None:
            self.feet.set_segments(list(1e3 * feet(self.ground, 1e-3 * axis[-1:])))
        return [self.lines, self.cells, self.axis, self.marks, self.feet]


class _Curves:
    """Pressures of inlets and bellows [kPa], with a cursor."""

    def __init__(self, made: Figure, run: Trajectory) -> None:
        self.run = run
        wide, names = 0.43 * made.get_figwidth(), 2 + len(run.inlets)
        self.columns = min(names, int(wide / LEGEND_COLUMN))
        high = 0.68 - 0.08 * (-(-names // self.columns) - 1)
        self.axes = made.add_axes((0.53, 0.14, 0.43, high))
        self.axes.grid(color=look().grid, lw=0.6)
        self.axes.axhline(0.0, color=look().grey, lw=0.9)
        start, end = float(run.time[0]), float(run.time[-1])
        self.axes.set(
            xlim=(start, end if end > start else start + 1.0),
            xlabel="time [s]", ylabel="gauge pressure [kPa]",
        )  # fmt: skip
        self._draw(self.axes)
        self.cursor = self.axes.axvline(start, color=look().accent, lw=1.4, animated=True)

    def _draw(self, axes: Axes) -> None:
        run = self.run
        for side, colour in zip("RL", look().columns, strict=True):
            own = [k for k, name in enumerate(run.bellows) if name.startswith(side)]
            some = np.unique(np.linspace(0, len(own) - 1, min(len(own), MAX_CURVES)).astype(int))
            time, values = envelope(run.time, run.pressure)
            axes.plot(time, values[:, [own[k] for k in some]] / 1e3, color=colour, lw=0.9)
            axes.plot([], [], color=colour, label=f"{side} column")
        time, inlets = envelope(run.time, run["inlet_pressure"])
        for k, name in enumerate(run.inlets):
            label = "inlet" if len(run.inlets) == 1 else f"inlet {shown(name, 12)}"
            axes.plot(
                time, inlets[:, k] / 1e3, color=look().ink, lw=2, ls=("-", "--")[k > 0], label=label
            )
        axes.legend(
            loc="lower left", bbox_to_anchor=(0, 1), ncols=self.columns, borderaxespad=0.2,
            columnspacing=1.2, handlelength=1.6,
        )  # fmt: skip

    def at(self, row: int) -> list[Any]:
        """The cursor at a row."""
        self.cursor.set_xdata([self.run.time[row]] * 2)
        return [self.cursor]
