"""Every picture in every style: all of it on the page, at the width asked for, and legible."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from matplotlib.colors import to_rgb, to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.text import Text
from PIL import Image

from tests.trajectories import made_run
from tests.unit.report.charts.conftest import assert_on_page
from tests.unit.report.every_picture import EVERY, draw
from viscodesign.errors import UsageError
from viscodesign.report.layout.look import LOOKS, drawn_as, look
from viscodesign.report.layout.style import RC
from viscodesign.report.picture_options import STYLES, PictureOptions, picture_options
from viscodesign.results.trajectory import Trajectory

WIDTHS = (("paper", "single"), ("talk", None), ("dark", "double"))
LEGIBLE_TEXT, VISIBLE_LINE = 4.5, 3.0
"""Contrasts that WCAG 2.2 asks for (1.4.3, 1.4.11)."""


def luminance(colour: Any) -> float:
    """Relative luminance as WCAG 2.2 defines it."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(colour)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a: Any, b: Any) -> float:
    """Contrast of two colours, from 1 to 21."""
    dark, light = sorted((luminance(a), luminance(b)))
    return (light + 0.05) / (dark + 0.05)


@pytest.fixture(scope="module", params=WIDTHS, ids=lambda words: f"{words[0]}-{words[1]}")
def drawn(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[str, str | None, dict[str, Figure]]:
    """All pictures in a style, as they were saved, at a low resolution."""
    style, width = request.param
    folder = tmp_path_factory.mktemp(style)
    figures: list[Figure] = []
    save = Figure.savefig

    def keep(figure: Figure, *words: Any, **options: Any) -> None:
        figures.append(figure)
        save(figure, *words, **options)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Figure, "savefig", keep)
        patch.setitem(RC, "savefig.dpi", 20)
        with drawn_as(picture_options("png", style, width)):
            for name in EVERY:
                draw(name, folder / f"{name}.png")
    return style, width, dict(zip(EVERY, figures, strict=True))


Drawn = tuple[str, str | None, dict[str, Figure]]


def test_all_of_it_is_on_the_page(drawn: Drawn) -> None:
    for figure in drawn[2].values():
        assert_on_page(figure)


def test_pictures_are_as_wide_as_asked(drawn: Drawn) -> None:
    width = {"paper": 89.0, "talk": 130.0, "dark": 183.0}[drawn[0]]
    for figure in drawn[2].values():
        assert 25.4 * figure.get_size_inches()[0] == pytest.approx(width)


def ground_of(text: Text, figure: Figure) -> Any:
    """The colour behind a text: its own box, an opaque patch of its axes, or the page."""
    box = text.get_bbox_patch()
    if box is not None and box.get_facecolor()[3] > 0.5:
        return box.get_facecolor()
    for patch in text.axes.patches if text.axes is not None else ():
        if isinstance(patch, Rectangle) and patch.get_width() == patch.get_height() == 1:
            return patch.get_facecolor()
    return figure.get_facecolor()


def test_every_word_can_be_read(drawn: Drawn) -> None:
    for name, figure in drawn[2].items():
        texts: list[Text] = figure.findobj(Text)
        shown = [text for text in texts if text.get_visible() and text.get_text().strip()]
        assert shown
        for text in shown:
            found = contrast(text.get_color(), ground_of(text, figure))
            assert found >= LEGIBLE_TEXT, (name, text.get_text(), text.get_color())
            assert text.get_fontsize() >= 5.5, (name, text.get_text())


def test_every_curve_can_be_seen(drawn: Drawn) -> None:
    """Lines that carry data: not the grid, nor what lies pale behind others."""
    pale = LOOKS[drawn[0]].faint
    for name, figure in drawn[2].items():
        for line in (line for axes in figure.axes for line in axes.lines):
            colour = to_rgba(line.get_color(), line.get_alpha())
            is_line = line.get_linestyle() != "None" and len(line.get_xydata()) > 1
            if is_line and colour[3] > 0.9 and line.get_color() != pale:
                found = contrast(colour, figure.get_facecolor())
                assert found >= VISIBLE_LINE, (name, line, colour)


def test_only_paper_leaves_out_titles(drawn: Drawn) -> None:
    texts = [text.get_text() for text in drawn[2]["tip"].texts]
    assert ("leg_made_up: tip path" in texts) == (drawn[0] != "paper")
    failed = [text.get_text() for text in drawn[2]["failed"].findobj(Text)]
    assert any(text.startswith("run failed, ended at") for text in failed)


def test_colours_of_curves_are_apart_in_every_style() -> None:
    for name in STYLES:
        colours = LOOKS[name].motions
        assert len({to_rgb(colour) for colour in colours}) == len(colours)
        if name != "plain":
            assert min(contrast(c, LOOKS[name].ground) for c in colours) >= VISIBLE_LINE


def test_a_style_ends_with_its_block() -> None:
    before = look()
    with drawn_as(PictureOptions(style="dark")), drawn_as(PictureOptions(style="paper")):
        assert look() == replace(LOOKS["paper"])
    assert look() is before


@pytest.mark.parametrize("width", ["", "wide", "79", "401", "nan", "-89", 0.0])
def test_a_width_that_there_is_not_is_refused(width: str | float) -> None:
    with pytest.raises(
        UsageError, match="use single \\(89 mm\\), double \\(183 mm\\), or 80 to 400"
    ):
        picture_options(width=width)


@pytest.mark.parametrize(("width", "mm"), [("single", 89.0), ("120 mm", 120.0), (150, 150.0)])
def test_widths(width: str | float, mm: float) -> None:
    assert picture_options(width=width).width_mm == mm


def test_another_style_is_refused() -> None:
    with pytest.raises(UsageError, match="must be one of plain, paper, talk, dark; got 'drak'"):
        picture_options(style="drak")  # type: ignore[arg-type]


def test_a_run_is_saved_in_a_style(tmp_path: Path) -> None:
    run: Trajectory = made_run()
    run.save(tmp_path, report=False, style="dark", width="single")
    with Image.open(tmp_path / "tip.png") as picture:
        assert picture.size[0] == pytest.approx(89 / 25.4 * 200, abs=1)
        assert picture.convert("RGB").getpixel((1, 1)) == (0x14, 0x16, 0x1A)
