"""The colours of a GIF: one palette for the whole film, with those that mean something in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import to_rgb

from viscodesign.report.layout.look import Look

if TYPE_CHECKING:
    from PIL.Image import Image

MAX_COLOURS = 255
"""A GIF has 256; one is left for what is transparent."""
PRESSURES = 128
"""Colours of pressures: neighbours differ by less than anybody sees."""
CELL = 8
"""Difference of a channel below which a colour may be taken for another."""
BLENDS = 6
"""Steps from the ground to the colour of a line, for its edges."""


def film_palette(frame: Image, look: Look) -> Image:
    """A picture with a palette of colours of pressures, of lines, and of a frame (RGB)."""
    from PIL import Image

    fixed = _fixed(look)
    free = MAX_COLOURS - len(fixed)
    others = frame.quantize(free, method=Image.Quantize.MEDIANCUT).getpalette() or []
    every = np.concatenate([fixed, np.array(others[: 3 * free], dtype=int).reshape(-1, 3)])
    # Pillow looks colours up in cells of a few units: the ground would take one beside its own.
    near = np.abs(every - every[0]).max(axis=1) < CELL
    every = np.concatenate([every[:1], every[~near]])
    # What is left of the 256 repeats the last colour.
    made = Image.new("P", (1, 1))
    padded = np.concatenate([every, np.repeat(every[-1:], 256 - len(every), axis=0)])
    made.putpalette(padded.astype(int).ravel().tolist())
    return made


def _fixed(look: Look) -> np.ndarray:
    """Colours (n, 3) that a frame need not hold to be in the film, the ground first."""
    ground = 255 * np.array(to_rgb(look.ground))
    lines = (look.ink, look.text, look.faint, look.grey, look.accent, *look.columns)
    shares = np.linspace(1 / BLENDS, 1, BLENDS)[:, None]
    blended = [ground + shares * (255 * np.array(to_rgb(line)) - ground) for line in lines]
    pressures = look.diverging(np.linspace(0, 1, PRESSURES), bytes=True)[:, :3]
    found = np.rint(np.concatenate([ground[None], *blended, pressures])).astype(int)
    _, first = np.unique(found, axis=0, return_index=True)
    return np.asarray(found[np.sort(first)])
