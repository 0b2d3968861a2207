"""Every picture says what it shows, has all of it on the page, and draws without a warning."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.collections import LineCollection, PathCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.text import Text

from tests.unit.report.cases import CASES
from tests.unit.report.conftest import Made
from viscodesign.report.charts.pressures import draw_pressures
from viscodesign.report.charts.shapes import draw_shapes, scale_length, time_labels
from viscodesign.report.charts.tip import draw_tip
from viscodesign.report.layout.snapshots import spread_instants
from viscodesign.report.layout.style import RC, shown
from viscodesign.results.trajectory import Trajectory

Draw = Callable[[Trajectory, Path], None]
DRAWERS: dict[str, Draw] = {
    "tip": draw_tip,
    "pressures": draw_pressures,
    "shapes": draw_shapes,
}


Drawn = Callable[[str, str], Figure]


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Drawn]:
    """Draws a case once and returns the figure as it was saved, at a low resolution."""
    folder = tmp_path_factory.mktemp("pictures")
    figures: list[Figure] = []
    save = Figure.savefig

    def keep(figure: Figure, *words: Any, **options: Any) -> None:
        figures.append(figure)
        save(figure, *words, **options)

    @functools.cache
    def draw(case: str, picture: str) -> Figure:
        path = folder / f"{case}_{picture}.png"
        DRAWERS[picture](CASES[case](), path)
        assert path.read_bytes().startswith(b"\x89PNG")
        return figures[-1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Figure, "savefig", keep)
        patch.setitem(RC, "savefig.dpi", 40)
        yield draw


def words(figure: Figure) -> set[str]:
    texts: list[Text] = figure.findobj(Text)
    return {text.get_text() for text in texts if text.get_visible()}


def has(figure: Figure, part: str) -> bool:
    return any(part in text for text in words(figure))


@pytest.mark.parametrize("picture", DRAWERS)
@pytest.mark.parametrize("case", CASES)
def test_everything_drawn_lies_on_the_page(drawn: Drawn, case: str, picture: str) -> None:
    figure = drawn(case, picture)
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    assert box.x0 >= -0.01
    assert box.y0 >= -0.01
    assert box.x1 <= width + 0.01
    assert box.y1 <= height + 0.01
    assert max(width, height) < 9


def test_the_picture_of_the_tip_labels_axes_ends_and_time(drawn: Drawn) -> None:
    figure = drawn("leg", "tip")
    expected = {"x [mm]", "z [mm], down from the clamp", "time [s]", "start", "end"}
    assert expected <= words(figure)
    axes = figure.axes[0]
    assert axes.yaxis_inverted()
    box = axes.get_position()
    width, height = figure.get_size_inches()
    across, down = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
    assert box.width * width / across == pytest.approx(box.height * height / down)


def test_a_short_path_is_also_drawn_enlarged(drawn: Drawn) -> None:
    assert has(drawn("far_above", "tip"), "enlarged")
    assert not has(drawn("leg", "tip"), "enlarged")
    assert not has(drawn("all_zero", "tip"), "enlarged")


def test_a_long_path_is_drawn_in_few_pieces_with_all_its_points(
    drawn: Drawn,
) -> None:
    lines = [c for c in drawn("long", "tip").axes[0].collections if isinstance(c, LineCollection)]
    pieces = max((line.get_segments() for line in lines), key=len)
    assert len(pieces) <= 1500
    assert sum(len(piece) - 1 for piece in pieces) == 20000


def test_the_pressures_picture_names_columns_inlet_and_levels(drawn: Drawn) -> None:
    figure = drawn("leg", "pressures")
    assert {"left column, L1 to L8", "right column, R1 to R8", "inlet"} <= words(figure)
    assert {"time [s]", "gauge pressure [kPa]", "ambient", "vacuum"} <= words(figure)
    left, right = figure.axes[:2]
    assert left.get_ylim() == right.get_ylim()
    curves = next(c for c in right.collections if isinstance(c, LineCollection))
    assert len(curves.get_segments()) == 8


def test_vacuum_lies_one_ambient_pressure_below_ambient(drawn: Drawn) -> None:
    assert not has(drawn("far_above", "pressures"), "vacuum")
    for case, level in (("leg", -101.325), ("thin_air", -60.0)):
        axes = drawn(case, "pressures").axes[0]
        label = next(text for text in axes.texts if text.get_text() == "vacuum")
        assert label.xy[1] == pytest.approx(level)  # type: ignore[attr-defined]
        assert any(line.get_ydata()[0] == pytest.approx(level) for line in axes.lines)


def test_several_inlets_are_told_apart(drawn: Drawn) -> None:
    assert {"inlet left", "inlet right"} <= words(drawn("two_inlets", "pressures"))


def test_the_filmstrip_has_times_scale_and_every_bellow(drawn: Drawn) -> None:
    figure = drawn("leg", "shapes")
    assert {"20 mm", "gauge pressure [kPa]", "L", "R", "t = 0.00 s", "t = 8.00 s"} <= words(figure)
    blocks = next(c for c in figure.axes[0].collections if isinstance(c, PolyCollection))
    assert len(blocks.get_paths()) == 8 * 16
    assert blocks.norm.vmin == -blocks.norm.vmax  # type: ignore[operator]


def test_pressures_far_from_the_ambient_keep_their_differences_visible(
    drawn: Drawn,
) -> None:
    figure = drawn("far_above", "shapes")
    blocks = next(c for c in figure.axes[0].collections if isinstance(c, PolyCollection))
    run = CASES["far_above"]()
    lowest = min(run.pressure.min(), run["inlet_pressure"].min())
    assert blocks.norm.vmin == pytest.approx(lowest / 1e3)


def test_the_filmstrip_has_every_tube_and_the_inlet_in_its_pressure(drawn: Drawn) -> None:
    figure = drawn("leg", "shapes")
    run = CASES["leg"]()
    assert "inlet" in words(figure)
    (marks,) = (c for c in figure.axes[0].collections if isinstance(c, PathCollection))
    rows = run.shape_rows[spread_instants(run, 8, pressures=True)]
    np.testing.assert_allclose(marks.get_array(), run["inlet_pressure"][rows, 0] / 1e3)
    bundles = [c for c in figure.axes[0].collections if isinstance(c, LineCollection)]
    assert len(bundles[0].get_segments()) == 8 * len(run.tubes)
    below = np.array([segment[:, 1].max() for segment in bundles[0].get_segments()])
    assert np.all(below > 0)


@pytest.mark.parametrize("picture", DRAWERS)
def test_a_run_that_ended_early_says_so(drawn: Drawn, picture: str) -> None:
    figure = drawn("failed", picture)
    assert has(figure, "run failed, ended at t = 1.23 s: pressure R3")
    assert has(drawn("interrupted", picture), "run interrupted, ended at t = 1.23 s")
    assert not has(drawn("leg", picture), "ended at")


@pytest.mark.parametrize("picture", DRAWERS)
def test_drawing_leaves_no_trace_in_matplotlib(
    run: Trajectory, tmp_path: Path, picture: str
) -> None:
    before = dict(mpl.rcParams)
    DRAWERS[picture](run, tmp_path / "picture.png")
    assert dict(mpl.rcParams) == before


def test_names_are_shown_in_one_line_of_characters_that_the_font_has() -> None:
    assert shown("a\n b\t c", 20) == "a b c"
    assert shown("x" * 30, 10) == "xxxxxxx..."
    assert shown("\N{PILE OF POO}μ", 5) == "□μ"


def test_instants_are_spread_over_what_occurs(run: Trajectory, made: Made) -> None:
    chosen = spread_instants(run, 8)
    assert chosen[0] == 0
    assert len(set(chosen.tolist())) == 8
    assert list(chosen) == sorted(chosen)
    still = made(inlet=lambda t: 0 * t)
    assert list(spread_instants(still, 8, pressures=True)) == [0]
    failed = replace(still, status="failed")
    assert list(spread_instants(failed, 8)) == [0, 400]


def test_pressures_count_where_nothing_moves(made: Made) -> None:
    stiff = made(bending=0.0, inlet=lambda t: 10.0 * t)
    assert len(spread_instants(stiff, 8)) == 1
    assert len(spread_instants(stiff, 8, pressures=True)) == 8


@pytest.mark.parametrize(
    ("times", "labels"),
    [
        ([0.0, 0.44, 8.0], ["t = 0.00 s", "t = 0.44 s", "t = 8.00 s"]),
        ([0.0, 0.401, 0.402, 40.0], ["t = 0.000 s", "t = 0.401 s", "t = 0.402 s", "t = 40.000 s"]),
        ([5.0], ["t = 5 s"]),
        ([0.0, 1e-9], ["t = 0 s", "t = 1e-09 s"]),
    ],
)
def test_times_are_told_apart(times: list[float], labels: list[str]) -> None:
    assert time_labels(np.array(times)) == labels


@pytest.mark.parametrize(
    ("scale", "length"), [(0.0174, 20.0), (0.05, 20.0), (1.7, 0.5), (0.001, 500.0)]
)
def test_the_scale_bar_has_a_round_length(scale: float, length: float) -> None:
    assert scale_length(scale) == pytest.approx(length)
