"""Pictures of comparisons and of the paper's figures: what is in them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from tests.trajectories import made_run
from tests.unit.report.charts.conftest import assert_on_page
from viscodesign import compare
from viscodesign.report.charts.compare import draw_comparison
from viscodesign.report.charts.paper_figure import draw_figure
from viscodesign.results.coefficient_band import CoefficientBand, UncertainNumber
from viscodesign.results.findings import Notice
from viscodesign.results.paper_figure import FigurePanel, PaperCheck, PaperFigure
from viscodesign.results.trajectory import Accuracy


def test_paths_distances_and_what_failed(figures: list[Figure], tmp_path: Path) -> None:
    failed = replace(
        made_run(time=np.linspace(0, 3, 151), bending=0.8), name="bent", status="failed",
        failure="no step",
    )  # fmt: skip
    found = compare(
        made_run(period=8.0), failed, replace(made_run(lag=0.02, period=8.0), name="slow")
    )
    draw_comparison(found, tmp_path / "compare.svg")
    paths, times, phases = figures[0].axes
    lines = {line.get_label(): line.get_xydata() for line in paths.lines}
    for motion in found.motions:
        np.testing.assert_allclose(lines[motion.title], 1e3 * motion.tip)
    for line, difference in zip(times.lines, found.differences, strict=False):
        np.testing.assert_allclose(line.get_ydata(), 1e3 * difference.distance)
    assert len(phases.lines) == 1
    assert any("bent (failed at 3 s): no step" in text.get_text() for text in figures[0].texts)
    assert (tmp_path / "compare.svg").stat().st_size > 10_000


def test_bands_of_the_coefficients_are_drawn_about_paths_and_beside_distances(
    figures: list[Figure], tmp_path: Path
) -> None:
    run = made_run(bending=0.8)
    rows = np.tile([4e-6, 1e-6, 0.0], (len(run.time), 1))
    known = UncertainNumber("fluid.viscosity", 1.0, "Pa*s", 0.1, False, 1.0)
    found = compare(made_run(), replace(run, uncertainty=CoefficientBand(rows, run.time, (known,))))
    draw_comparison(found, tmp_path / "compare.png")
    paths, times = figures[0].axes
    (ellipses,) = (own for own in paths.collections if isinstance(own, PolyCollection))
    first = ellipses.get_paths()[0].vertices - 1e3 * run.tip[0, :2]
    assert np.abs(first).max(axis=0) == pytest.approx((1.96 * 2, 1.96 * 1), rel=1e-3)
    own = next(line for line in times.lines if line.get_label() == "95 % by the coefficients")
    np.testing.assert_allclose(own.get_ydata(), 1e3 * found.differences[0].band)


@pytest.mark.parametrize(("stated", "at"), [(1e-3, "bottom"), (1e-1, "top")])
def test_stated_errors_are_a_band_with_its_size(
    figures: list[Figure], tmp_path: Path, stated: float, at: str
) -> None:
    runs = [
        replace(made_run(bending=bending), accuracy=Accuracy(1e-3, stated / 2, "made up"))
        for bending in (1.0, 0.8)
    ]
    draw_comparison(compare(*runs), tmp_path / "compare.png")
    (label,) = figures[0].axes[1].texts
    assert label.get_text() == f"stated errors, {1e3 * stated:.2g} mm"
    assert label.get_va() == at
    assert label.get_position()[1] <= figures[0].axes[1].get_ylim()[1]
    title = figures[0].texts[0].get_text()
    assert title.endswith("within the stated errors") == (at == "top")


def test_one_motion_of_one_instant(tmp_path: Path) -> None:
    one = made_run(time=np.array([0.0, 1.0])).with_arrays(time=np.array([0.0, 1e-3]))
    draw_comparison(compare(one, replace(one, name="same")), tmp_path / "compare.png")
    assert (tmp_path / "compare.png").exists()


@pytest.mark.parametrize("agrees", [True, False, None])
def test_panels_of_a_figure_and_their_statements(
    figures: list[Figure], tmp_path: Path, agrees: bool | None
) -> None:
    still = made_run(bending=0.0, inlet=lambda t: 1e4 + 0 * t)
    panels = (
        FigurePanel("A", "one", "", (made_run(),)),
        FigurePanel("B", "two", "sizes", (made_run(), replace(made_run(lag=0.02), name="slow"))),
        FigurePanel("C", "steady", "", (still,)),
    )
    check = PaperCheck(3, "A", "3.1", "it moves", agrees, "10 mm")
    draw_figure(PaperFigure(3, "Title", panels, (check,), "1"), tmp_path / "figure.png")
    texts = [text.get_text() for text in figures[0].texts]
    assert f"{check.verdict}: it moves: 10 mm" in texts
    assert "Assumed: sizes." in texts
    assert {"A  one", "B  two", "C  steady"} <= set(texts)
    legends = [axes.get_legend() for axes in figures[0].axes if axes.get_legend()]
    assert [t.get_text() for t in legends[0].get_texts()] == ["leg_made_up", "slow"]


def test_panels_of_one_moving_run_each_have_one_scale_and_say_where_the_model_ends(
    figures: list[Figure], tmp_path: Path
) -> None:
    beyond = (Notice("choking", "it chokes", "inlet-R1", 0.5),)
    wide = replace(made_run(bending=1.5), name="wide", violations=beyond)
    panels = (FigurePanel("A", "one", "", (made_run(),)), FigurePanel("B", "two", "", (wide,)))
    check = PaperCheck(3, "B", "3.1", "it moves", True, "10 mm", ("wide",))
    draw_figure(PaperFigure(3, "Title", panels, (check,), "1"), tmp_path / "figure.png")
    square = [axes for axes in figures[0].axes if axes.get_xlabel() == "x [mm]"]
    assert square[0].get_xlim() == square[1].get_xlim()
    assert square[0].get_ylim() == square[1].get_ylim()
    texts = [text.get_text() for text in figures[0].texts]
    assert "Outside of what the model describes: wide (choking)" in texts
    assert "1 of 1 statements agree, 1 of these by runs outside of their model" in texts
    assert_on_page(figures[0])


def test_a_run_outside_of_its_model_is_told_above_the_paths(
    figures: list[Figure], tmp_path: Path
) -> None:
    beyond = (Notice("choking", "it chokes", "inlet-R1", 0.5),)
    found = compare(made_run(), replace(made_run(lag=0.02), name="slow", violations=beyond))
    draw_comparison(found, tmp_path / "compare.png")
    assert "outside of the model: slow (choking)" in [t.get_text() for t in figures[0].texts]
    (difference,) = found.differences
    assert (
        "outside of the model, which no stated error counts: slow (choking)" in difference.sentence
    )
    assert "clocks" not in " ".join(difference.sentences)
    assert difference.shift is not None
