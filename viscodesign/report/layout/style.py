"""One style for every picture: readable in print, safe for the colour-blind."""

from __future__ import annotations

import contextlib
import functools
import io
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import findfont, get_font

from viscodesign.report.layout.drawing_library import plain_settings
from viscodesign.report.layout.label_placement import CHARACTER_WIDTH, POINTS_PER_INCH
from viscodesign.report.layout.look import look
from viscodesign.report.layout.png import png_bytes
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import replaced

if TYPE_CHECKING:
    from matplotlib.axes import Axes

RC: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "hatch.linewidth": 0.6,
    "savefig.dpi": 200,
    "pdf.fonttype": 42,  # as letters that a publisher can edit
    # Names are printed as they are: a dollar sign in one is not a formula.
    "text.parse_math": False,
    "text.usetex": False,
    "svg.hashsalt": "viscodesign",  # the same picture is the same file
}
SAVING: Any = {
    "svg": {"metadata": {"Date": None}},
    "pdf": {"metadata": {"CreationDate": None}},
}
"""How other formats than PNG are written: the same picture is the same file."""
TIME_DIGITS = (-4, 5)
"""Powers of ten between which times are written in full; five digits fit."""
TITLE_ROOM, NO_TITLE_ROOM = 0.34, 0.08
"""Above a picture with a title, and without one [inch]."""
TITLE, SMALLEST_TITLE = 10.0, 7.0
"""Font sizes [pt]; a smaller one where the width that was asked for needs it."""
NOTE, NOTE_ROOM = 7.5, 0.22
"""Font size of a line of explanation [pt], and its room [inch]."""
BANNER_LINE = 0.17
BANNER_LINES = 3


class Screen:
    """Where a picture goes that is to be looked at: a figure of pyplot, which stays."""

    axes: list[Axes]
    """Axes of the figure, in the order in which they were made."""

    def figure(self, width: float, height: float) -> Figure:
        """A new figure of this size [inch], with a colour behind it that the text is made for."""
        from matplotlib import pyplot

        return pyplot.figure(figsize=(width, height), facecolor=look().ground)


Target = Path | Screen
"""A file, or a figure to look at."""


@contextlib.contextmanager
def own_style() -> Iterator[None]:
    """The look in force, whatever the settings of the user's are, such as a dark theme."""
    settings: Any = mpl.rcParams
    with mpl.rc_context():
        dict.update(settings, plain_settings())  # valid already: checking all takes long
        settings.update(RC | look().settings)
        settings["savefig.dpi"] = RC["savefig.dpi"] * look().enlarged
        try:
            yield
        finally:
            wanted = settings["interactive"]
    # A notebook's backend asks for this when the first figure loads it.
    settings["interactive"] = wanted


@contextlib.contextmanager
def picture(path: Target, width: float, height: float) -> Iterator[Figure]:
    """A figure in inches, written completely to ``path`` at the end; leaves no global state.

    The suffix of ``path`` determines the format (png, pdf, svg; png without one).
    """
    with own_style():
        if isinstance(path, Screen):
            shown = path.figure(width, height)
            yield shown
            path.axes = shown.axes
            return
        made = Figure(figsize=(width, height))
        canvas = FigureCanvasAgg(made)
        yield made
        kind = path.suffix.lstrip(".").lower() or "png"
        with replaced(path) as file:
            if kind == "png":
                file.write(png_bytes(_pixels(made, canvas), mpl.rcParams["savefig.dpi"]))
            else:
                made.savefig(file, format=kind, **SAVING.get(kind, {}))


def _pixels(made: Figure, canvas: Any) -> np.ndarray:
    """A figure as opaque pixels (height, width, 3)."""
    raw = io.BytesIO()
    made.savefig(raw, format="rgba")
    size = int(canvas.renderer.height), int(canvas.renderer.width), 4
    return np.frombuffer(raw.getbuffer(), dtype=np.uint8).reshape(size)[..., :3]


def axes_at(made: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Axes at a place of the figure that is given in inches."""
    across, up = made.get_size_inches()
    return made.add_axes((left / across, bottom / up, width / across, height / up))


def title_room() -> float:
    """Height [inch] that `draw_title` takes."""
    return TITLE_ROOM if look().titles else NO_TITLE_ROOM


def draw_title(made: Figure, words: str, left: float, below: float = 0.0) -> None:
    """Words from ``left``, ``below`` the upper edge [inch]; none in a look without titles."""
    if not look().titles:
        return
    width, height = made.get_size_inches()
    size = TITLE
    if look().width is not None:
        room = (width - left) * POINTS_PER_INCH / CHARACTER_WIDTH
        size = min(TITLE, max(SMALLEST_TITLE, room / len(words)))
        words = shown(words, int(room / size))
    made.text(left / width, (height - below - 0.21) / height, words, size=size, va="baseline")


def draw_note(made: Figure, words: str, left: float, level: float = 0.08) -> None:
    """A line of explanation from ``left``, ``level`` above the lower edge [inch]."""
    width, height = made.get_size_inches()
    size = min(NOTE, (width - left) * POINTS_PER_INCH / (CHARACTER_WIDTH * len(words)))
    made.text(left / width, level / height, words, size=size, color=look().note)


def head_room(trajectory: Trajectory, width: float) -> float:
    """Height [inch] that `head` takes on a figure of ``width``."""
    return title_room() + BANNER_LINE * len(_banner_lines(trajectory, width))


def head(made: Figure, trajectory: Trajectory, words: str, left: float) -> None:
    """Title from ``left`` [inch]; for an incomplete run, the reason above it."""
    width, height = made.get_size_inches()
    lines = _banner_lines(trajectory, width)
    top = height - BANNER_LINE * len(lines)
    name = shown(trajectory.name, _characters(width - left, TITLE) - len(words) - 2)
    draw_title(made, f"{name}: {words}", left, height - top)
    if lines:
        axes = axes_at(made, 0, top, width, height - top)
        axes.set_axis_off()
        axes.add_patch(mpl.patches.Rectangle((0, 0), 1, 1, facecolor=look().warning))
        axes.text(
            0.5, 0.5, "\n".join(lines), ha="center", va="center_baseline",
            color=look().ground, weight="bold", size=8, linespacing=1.15,
        )  # fmt: skip


def _banner_lines(trajectory: Trajectory, width: float) -> list[str]:
    if trajectory.status == "complete":
        return []
    text = f"run {trajectory.status}, ended at t = {trajectory.time[-1]:.4g} s"
    if trajectory.failure:
        text += f": {trajectory.failure}"
    # Bold characters are wider.
    columns = int(0.88 * _characters(width - 0.3, 8.0))
    return textwrap.wrap(shown(text, 10_000), columns, max_lines=BANNER_LINES, placeholder=" ...")


def _characters(width: float, size: float) -> int:
    """How many characters of ``size`` [pt] fit into ``width`` [inch]."""
    return max(8, int(width * POINTS_PER_INCH / (CHARACTER_WIDTH * size)))


def shown(text: str, limit: int) -> str:
    """One line of at most ``limit`` characters, with those that the font lacks replaced."""
    known = _font_characters()
    line = " ".join(text.split())
    line = "".join(c if ord(c) in known else "\N{WHITE SQUARE}" for c in line)
    return line if len(line) <= limit else line[: max(limit - 3, 1)] + "..."


@functools.cache
def _font_characters() -> frozenset[int]:
    return frozenset(get_font(findfont(RC["font.family"])).get_charmap())
