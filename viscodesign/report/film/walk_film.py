"""A gait as a film: the robot from its side, on the ground."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.report.film.film_plan import TITLE_CHARACTERS, FilmOptions, film_rows
from viscodesign.report.folder import new_file
from viscodesign.report.picture_options import PictureOptions
from viscodesign.results.walk_study import WalkStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MIN_RADIUS = 2e-3
"""Smallest radius with which a foot is drawn [m]."""
ROOM = 0.25
"""Around the robot, in lengths of its body."""


def write_walk_film(study: WalkStudy, file: str | Path, **options: Any) -> Path:
    """Write a gait as GIF, WebP or MP4 (with ffmpeg), by the suffix of ``file``.

    ``options``: those of `FilmOptions`. Raises `UsageError` as `write_film` does.
    """
    path = Path(file)
    chosen = FilmOptions(**options).checked(path)
    rows = film_rows(study.motion.time[study.motion.rows], chosen)
    from viscodesign.report.film.encode import write_frames

    with new_file(path):
        write_frames(_frames(study, rows, chosen), len(rows), path, chosen)
    return path


def _frames(study: WalkStudy, rows: np.ndarray, options: FilmOptions) -> Iterator[np.ndarray]:
    """Pixels (height, width, 4) of the frames."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    from viscodesign.report.film.film_frames import draw_banner
    from viscodesign.report.layout.look import drawn_as
    from viscodesign.report.layout.style import own_style, shown

    with drawn_as(PictureOptions(style=options.style)), own_style():
        made = Figure(figsize=options.figure_size, dpi=options.dots_per_inch)
        canvas: Any = FigureCanvasAgg(made)
        if options.transparent:
            made.patch.set_alpha(0.0)
        scene = _SideView(made.add_axes((0.03, 0.08, 0.94, 0.8)), study)
        name = shown(study.name, int(TITLE_CHARACTERS * made.get_figwidth()))
        made.text(0.03, 0.95, name, va="top", size=12, weight="bold")
        if study.refusal:
            draw_banner(made, ["no speed is stated"])
        clock = made.text(0.97, 0.95, "", ha="right", va="top", size=12)
        for row in rows:
            scene.show(int(row))
            clock.set_text(f"t = {study.motion.time[study.motion.rows[row]]:.2f} s")
            canvas.draw()
            yield np.array(canvas.buffer_rgba())


class _SideView:
    """The robot [mm] over the ground, by recorded row."""

    def __init__(self, axes: Axes, study: WalkStudy) -> None:
        from matplotlib.patches import Circle

        from viscodesign.report.charts.walk import leg_colours
        from viscodesign.report.layout.look import look

        self.motion, motion = study.motion, study.motion
        self.ground = look().ground
        self.axes = axes
        axes.set_axis_off()
        self._frame(study)
        axes.axhline(0.0, color=look().grey, lw=1.5)
        for tick in np.arange(np.floor(self.limits[0] / 50) * 50, self.limits[1], 50.0):
            axes.plot([tick, tick - 6], [0, -6], color=look().grey, lw=0.8)
        colours = leg_colours(motion).values()
        self.legs = [axes.plot([], [], color=c, lw=4, alpha=0.8)[0] for c in colours]
        radius = 1e3 * max(motion.foot_radius, MIN_RADIUS)
        self.feet = [Circle((0, 0), radius, ec=c, lw=2) for c in colours]
        for foot in self.feet:
            axes.add_patch(foot)
        self.body = axes.plot([], [], color=look().ink, lw=9, solid_capstyle="round")[0]

    def _frame(self, study: WalkStudy) -> None:
        points = 1e3 * study.motion.axes
        room = 1e3 * ROOM * study.body_length_m
        low, high = np.nanmin(points[..., 0]) - room, np.nanmax(points[..., 0]) + room
        self.limits = low, high
        top = float(np.nanmax(points[..., 1])) + room
        self.axes.set(xlim=(low, high), ylim=(-20.0, top), aspect="equal", anchor="C")

    def show(self, row: int) -> None:
        """Move everything to a recorded row."""
        step, points = self.motion.rows[row], 1e3 * self.motion.axes[row]
        for k, leg in enumerate(self.legs):
            own = points[k][~np.isnan(points[k, :, 0])]
            leg.set_data(own[:, 0], own[:, 1])
            self.feet[k].set_center((float(own[-1, 0]), float(own[-1, 1])))
            is_loaded = self.motion.normal[step, k] > 0
            self.feet[k].set_facecolor(leg.get_color() if is_loaded else self.ground)
        hips = points[np.argsort(points[:, 0, 0]), 0]
        self.body.set_data(hips[:, 0], hips[:, 1])
