"""The picture of a study: every point, the front, what was asked for, all on the page."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from tests.studies import MODELS, POINTS, REFERENCE, STEPLESS, made_study, point
from tests.unit.report.charts.conftest import Save, assert_on_page, words
from viscodesign.report.charts.accuracy import draw_accuracy
from viscodesign.report.charts.accuracy_axes import percent_words, time_words
from viscodesign.report.charts.accuracy_labels import MAX_LABELS
from viscodesign.report.layout.look import PLAIN
from viscodesign.results.accuracy_points import Model
from viscodesign.results.accuracy_study import AccuracyStudy

Drawn = Callable[[AccuracyStudy], Figure]

CROWD = [
    point(1e-3 * 1.2**k, 0.05 / 1.4**k, edges=1 + k % 3, tolerance=10.0 ** -(2 + k % 6))
    for k in range(30)
]
CASES: dict[str, Callable[[], AccuracyStudy]] = {
    "usual": made_study,
    "one_point": lambda: made_study(points=[STEPLESS], start=None),
    "crowded": lambda: made_study(points=CROWD, start=None),
    "interrupted": lambda: made_study(status="interrupted", name="x" * 200),
    "many_models": lambda: made_study(
        models=tuple(Model(f"model_{k}", ()) for k in range(8)),
        points=[point(0.01 * 2**k, 0.02, model=f"model_{k}") for k in range(8)],
        start=None,
    ),
    "all_below": lambda: made_study(
        points=[point(0.01, 2e-5, is_bound=True)], start=None,
        reference=replace(REFERENCE, smallest_error_m=2e-6),
    ),
}  # fmt: skip


@pytest.fixture
def drawn(save: Save) -> Drawn:
    """Draws a study."""
    return partial(save, draw_accuracy)


def marks(figure: Figure) -> list[Line2D]:
    """Marks of single points, without the ring."""
    lines = [line for line in figure.axes[0].lines if line.get_linestyle() == "None"]
    return [line for line in lines if line.get_markersize() < 14]


def ring(figure: Figure) -> list[Line2D]:
    return [line for line in figure.axes[0].lines if line.get_markersize() == 14]


@pytest.mark.parametrize("case", CASES)
def test_everything_drawn_lies_on_the_page(drawn: Drawn, case: str) -> None:
    assert_on_page(drawn(CASES[case]()))


def test_every_point_has_its_mark_full_on_the_front(drawn: Drawn) -> None:
    study = made_study()
    found = {
        (float(line.get_xdata()[0]), float(line.get_ydata()[0])): line  # type: ignore[index, arg-type]
        for line in marks(drawn(study))
    }
    assert len(found) == len(POINTS)
    for one in study.points:
        line = found[one.solve_s, one.tip_error_rel]
        colour = PLAIN.models[[m.name for m in MODELS].index(one.model)]
        assert to_hex(line.get_markeredgecolor()) == colour  # type: ignore[arg-type]
        full = to_hex(line.get_markerfacecolor()) == colour  # type: ignore[arg-type]
        assert full != one.dominated


def test_solvers_differ_by_mark_and_meshes_by_size(drawn: Drawn) -> None:
    study = made_study()
    found = marks(drawn(study))
    by_solver = {
        one.solver: line.get_marker() for one, line in zip(study.points[1:], found[1:], strict=True)
    }
    assert by_solver["idas"] != by_solver["radau"]
    assert found[0].get_marker() not in by_solver.values()  # without steps
    assert found[4].get_markersize() > found[3].get_markersize()


def test_the_recommended_setting_has_a_ring_and_a_label(drawn: Drawn) -> None:
    figure = drawn(made_study())
    (circle,) = ring(figure)
    assert float(circle.get_xdata()[0]) == 0.012  # type: ignore[index, arg-type]
    assert to_hex(circle.get_markeredgecolor()) == PLAIN.accent  # type: ignore[arg-type]
    assert "recommended for 0.5 %:\nauto, idas, 1 edge, tol 3e-3, 12 ms" in words(figure)
    assert ring(drawn(made_study(requested_rel=1e-7))) == []


def test_the_requested_error_is_a_labelled_line(drawn: Drawn) -> None:
    figure = drawn(made_study())
    assert "requested: 0.5 %" in words(figure)
    dashed = [line for line in figure.axes[0].lines if line.get_linestyle() == "--"]
    assert [float(y) for line in dashed for y in line.get_ydata()] == [0.005, 0.005]  # type: ignore[union-attr, arg-type]


def test_the_front_is_a_staircase_through_its_points(drawn: Drawn) -> None:
    study = made_study()
    stairs = max(drawn(study).axes[0].lines, key=lambda line: line.get_linewidth())
    corners = set(zip(stairs.get_xdata(), stairs.get_ydata(), strict=True))  # type: ignore[arg-type]
    assert {(one.solve_s, one.tip_error_rel) for one in study.front} <= corners


def test_the_front_has_a_limited_number_of_labels(drawn: Drawn) -> None:
    told = words(drawn(made_study()))
    assert {"no time steps", "1 edge, tol 1e-2", "1 edge, tol 1e-4", "2 edges, tol 1e-6"} <= set(
        told
    )
    crowd = [text for text in words(drawn(CASES["crowded"]())) if ", tol " in text]
    assert len(crowd) <= MAX_LABELS + 1


def test_errors_below_that_of_the_reference_are_marked(drawn: Drawn) -> None:
    assert any("upper bounds" in text for text in words(drawn(made_study())))
    known = replace(REFERENCE, smallest_error_m=1e-12)
    assert not any("upper bounds" in text for text in words(drawn(made_study(reference=known))))


def test_an_interrupted_study_says_so(drawn: Drawn) -> None:
    assert any("interrupted: incomplete" in t for t in words(drawn(CASES["interrupted"]())))


def test_the_key_names_models_solvers_and_meshes(drawn: Drawn) -> None:
    told = set(words(drawn(made_study())))
    assert {"auto, II:\ndistributed, inertial", "radau", "none: no time steps", "1", "2"} <= told


@pytest.mark.parametrize(
    ("time", "said"),
    [(5e-4, "500 µs"), (1e-3, "1 ms"), (0.3, "300 ms"), (1.0, "1 s"), (100.0, "100 s")],
)
def test_times_on_the_axis(time: float, said: str) -> None:
    assert time_words(time) == said


@pytest.mark.parametrize(("part", "said"), [(1.0, "100 %"), (5e-3, "0.5 %"), (1e-7, "0.00001 %")])
def test_errors_on_the_axis(part: float, said: str) -> None:
    assert percent_words(part) == said
