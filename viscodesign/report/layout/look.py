"""How pictures look: colours, width, and whether they have titles. Every picture reads it here."""

from __future__ import annotations

import contextlib
import contextvars
import functools
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.colors import Colormap, ListedColormap

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import PictureOptions

INCH_MM = 25.4


@functools.cache
def _part(name: str, low: float, high: float) -> Colormap:
    return ListedColormap(mpl.colormaps[name](np.linspace(low, high, 256)))


OKABE_ITO = ("#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""Colours that the colour-blind tell apart, without the yellow, which is too pale for a line."""
DARK_OKABE_ITO = ("#d55e00", "#0072b2", "#007a59", "#b4508a", "#a67300", "#2b83ba")
"""The same hues, darkened until each has a contrast of 3 with white."""
LIGHT_OKABE_ITO = ("#ff8a4a", "#5aa9e6", "#2fc29a", "#e59cc4", "#f0b429", "#8fd0f5")
"""The same hues on a dark ground."""


@dataclass(frozen=True)
class Look:
    """Colours and measures of a picture."""

    ground: str = "white"
    text: str = "black"
    """Titles, labels, ticks."""
    ink: str = "#222222"
    """Lines that matter most."""
    note: str = "#555555"
    """Words beside the matter."""
    grey: str = "#8a8a8a"
    faint: str = "#b8b8b8"
    grid: str = "#e6e6e6"
    body: str = "#eeeeee"
    """The actuator where its pressures are not shown."""
    shade: str = "#f4f4f4"
    """Part of a plane that is set apart."""
    band: str = "#c3d3e6"
    accent: str = "#d55e00"
    warning: str = "#b23c00"
    """Words that warn, and behind white ones."""
    curves: tuple[str, ...] = OKABE_ITO
    """Different things; the first is the accent's hue."""
    columns: tuple[str, str] = ("#1b7f79", "#a3308f")
    """The right column of bellows, and the left one."""
    viridis: tuple[float, float] = (0.0, 0.9)
    """The part of it that is seen on the ground: its palest end vanishes on paper."""
    titles: bool = True
    width: float | None = None
    """[inch]; None: as the picture is made."""
    enlarged: float = 1.0
    """Factor on the number of dots per inch of a PNG."""

    @property
    def sequential(self) -> Colormap:
        """Colours of numbers that grow."""
        return _part("viridis", *self.viridis)

    @property
    def diverging(self) -> Colormap:
        """Colours of numbers above and below a level."""
        return mpl.colormaps["RdBu_r"]

    @property
    def main(self) -> Any:
        """Colour of what a picture is about."""
        return self.sequential(0.25)

    @property
    def motions(self) -> tuple[str, ...]:
        """Colours of several motions, the first that of the text."""
        return (self.text, *self.curves)

    @property
    def inlets(self) -> tuple[str, ...]:
        """Colours of inlets: none occurs in ``sequential``, which is that of their bellows."""
        vermillion, _, _, purple, orange, _ = self.curves
        return (vermillion, purple, self.text, orange)

    @property
    def models(self) -> tuple[str, ...]:
        """Colours of things beside the accent: all but its hue."""
        _, blue, green, purple, orange, sky = self.curves
        return (blue, orange, green, purple, sky, self.text)

    def across(self, natural: float) -> float:
        """Width [inch] of a picture whose default width is ``natural``."""
        return natural if self.width is None else self.width

    @property
    def settings(self) -> dict[str, Any]:
        """Matplotlib's settings that follow."""
        inked = ("text.color", "axes.labelcolor", "axes.edgecolor", "xtick.color", "ytick.color")
        grounds = ("axes.facecolor", "figure.facecolor", "savefig.facecolor")
        return {
            **dict.fromkeys((*inked, "patch.edgecolor", "hatch.color"), self.text),
            **dict.fromkeys(grounds, self.ground),
            "grid.color": self.grid,
        }


PLAIN = Look()
PAPER = replace(PLAIN, titles=False, curves=DARK_OKABE_ITO, enlarged=3.0)
TALK = replace(PLAIN, curves=DARK_OKABE_ITO, enlarged=2.0)
DARK = Look(
    ground="#14161a",
    text="#e8eaee",
    ink="#dfe2e8",
    note="#a5abb5",
    grey="#848b97",
    faint="#5b626e",
    grid="#2b3038",
    body="#2b3038",
    shade="#1d2026",
    band="#34506f",
    accent="#ff9256",
    warning="#ff9256",
    curves=LIGHT_OKABE_ITO,
    columns=("#3fb8b0", "#e07fd0"),
    viridis=(0.38, 1.0),
)
LOOKS = {"plain": PLAIN, "paper": PAPER, "talk": TALK, "dark": DARK}

_CURRENT: contextvars.ContextVar[Look] = contextvars.ContextVar("look", default=PLAIN)


def look() -> Look:
    """The look of the picture that is drawn now; the plain one unless told otherwise."""
    return _CURRENT.get()


@contextlib.contextmanager
def drawn_as(options: PictureOptions) -> Iterator[Look]:
    """Draw all pictures in this block as the options ask, in this thread alone."""
    width = options.width_mm
    chosen = replace(LOOKS[options.style], width=None if width is None else width / INCH_MM)
    token = _CURRENT.set(chosen)
    try:
        yield chosen
    finally:
        _CURRENT.reset(token)
