"""PNG files hold the pixels that they were given."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from viscodesign.report.layout.png import png_bytes
from viscodesign.report.layout.style import RC, axes_at, picture


@pytest.mark.parametrize("shape", [(1, 1), (3, 2), (50, 301)])
def test_pixels_come_back(shape: tuple[int, int]) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (*shape, 3), dtype=np.uint8)
    found = Image.open(io.BytesIO(png_bytes(pixels, 200)))
    assert np.array_equal(np.asarray(found), pixels)
    assert found.info["dpi"] == pytest.approx((200, 200), abs=0.01)


def drawn(made: Figure) -> None:
    axes = axes_at(made, 0.5, 0.4, 2.0, 1.0)
    axes.plot([0, 1, 2], [3, 1, 2], alpha=0.4)
    axes.set(xlabel="a", title="b")


def test_a_picture_is_what_matplotlib_saves(tmp_path: Path) -> None:
    import matplotlib as mpl

    with picture(tmp_path / "own.png", 3.3, 1.7) as made:
        drawn(made)
    with mpl.rc_context(RC):
        made = Figure(figsize=(3.3, 1.7))
        FigureCanvasAgg(made)
        drawn(made)
        made.savefig(tmp_path / "saved.png")
    own, saved = (Image.open(tmp_path / name) for name in ("own.png", "saved.png"))
    assert own.info["dpi"] == saved.info["dpi"]
    assert np.array_equal(np.asarray(own), np.asarray(saved.convert("RGB")))
    assert np.min(np.asarray(saved)[..., 3]) == 255
