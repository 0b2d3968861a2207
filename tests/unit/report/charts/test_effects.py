"""The chart of the effects: both bars, the decision, the requested error, all on the page."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from tests.trajectories import VERDICTS, ablated_run, verdict
from tests.unit.report.charts.conftest import Save, assert_on_page, words
from viscodesign.report.charts.effects import SMALLEST_BAR, draw_effects, effect_rows
from viscodesign.report.layout.look import PLAIN
from viscodesign.results.findings import EffectAblation
from viscodesign.results.trajectory import Accuracy, Trajectory

Drawn = Callable[[Trajectory], Figure]

MANY = tuple(verdict(f"a_very_long_name_of_an_effect_{k}", k % 2 == 0, 10.0**-k) for k in range(18))
CASES = {
    "usual": ablated_run,
    "one_without_a_move": lambda: ablated_run(
        effects=VERDICTS[:1], proof=(EffectAblation("tip_load", False, 0.0, 0.0, 1.0),)
    ),
    "none_measured": lambda: ablated_run(
        proof=tuple(EffectAblation(v.name, v.taken, math.inf, None, 0.0, "why") for v in VERDICTS)
    ),
    "many": lambda: ablated_run(
        effects=MANY,
        proof=tuple(EffectAblation(v.name, v.taken, v.contribution_m, 1e-3, 1.0) for v in MANY),
    ),
    "narrow": lambda: ablated_run(
        effects=VERDICTS[-1:], proof=(EffectAblation("feedback", False, 5e-4, 5.1e-4, 1.0),)
    ),
    "strict": lambda: ablated_run(accuracy=Accuracy(1e-12, None, "not verified")),
    "failed": lambda: ablated_run(
        time=np.linspace(0, 1.23, 62), status="failed", failure="it broke", name="x" * 200
    ),
}


@pytest.fixture
def drawn(save: Save) -> Drawn:
    """Draws a run."""
    return partial(save, draw_effects)


def bars(figure: Figure) -> dict[tuple[int, bool], Rectangle]:
    """Every bar by its row, and by whether it is the measured one (the upper)."""
    found = {}
    for bar in figure.axes[0].patches:
        assert isinstance(bar, Rectangle)
        middle = bar.get_y() + bar.get_height() / 2
        found[round(middle), middle < round(middle)] = bar
    return found


def names(figure: Figure) -> list[str]:
    return [label.get_text() for label in figure.axes[0].get_yticklabels()]


@pytest.mark.parametrize("case", CASES)
def test_everything_drawn_lies_on_the_page(drawn: Drawn, case: str) -> None:
    assert_on_page(drawn(CASES[case]()))


def test_one_row_per_effect_largest_first_not_applicable_last() -> None:
    rows = [row.name for row in effect_rows(ablated_run())]
    assert rows == [
        "pressure_distribution", "flow_regime", "gas_compressibility", "gravity", "inertia",
        "feedback", "damping", "fluid_mass", "fluid_inertance", "tip_load", "material_curve",
    ]  # fmt: skip


def test_bars_end_at_the_displacements_in_mm(drawn: Drawn) -> None:
    found = bars(drawn(ablated_run()))
    ends = {key: bar.get_x() + bar.get_width() for key, bar in found.items()}
    assert ends[0, True] == pytest.approx(98.7)
    assert ends[0, False] == pytest.approx(114)
    assert ends[3, True] == pytest.approx(2.3)
    assert ends[3, False] == pytest.approx(0.2)


def test_measured_and_estimated_differ_in_colour_the_decision_in_hatching(drawn: Drawn) -> None:
    found = bars(drawn(ablated_run()))
    taken, left_out = (0, 3)
    for measured in (True, False):
        assert not found[taken, measured].get_hatch()
        assert found[left_out, measured].get_hatch()
        assert to_hex(found[left_out, measured].get_facecolor()) == "#ffffff"
    assert to_hex(found[taken, True].get_facecolor()) == to_hex(PLAIN.main)
    assert to_hex(found[taken, False].get_facecolor()) != to_hex(PLAIN.main)


def test_the_requested_error_is_a_labelled_line(drawn: Drawn) -> None:
    figure = drawn(ablated_run())
    (line,) = figure.axes[0].lines
    assert list(line.get_xdata()) == pytest.approx([0.545, 0.545])
    assert "requested error: 0.545 mm" in words(figure)
    assert {"measured", "estimated", "included: filled", "neglected: hatched"} <= set(words(figure))
    assert any(text.endswith("[mm]") for text in words(figure))


def test_no_number_lies_on_the_line_of_the_requested_error(drawn: Drawn) -> None:
    near = {"gravity": (4.9e-4, 4.85e-4), "inertia": (2.7e-4, 4e-4), "collapse": (0.0, 9.4e-14)}
    run = ablated_run(
        effects=tuple(verdict(name, True, own[0]) for name, own in near.items()),
        proof=tuple(EffectAblation(name, True, *own, 1.0) for name, own in near.items()),
    )
    figure = drawn(run)
    (axes,) = figure.axes
    line = axes.transData.transform((1e3 * run.accuracy.requested_m, 0))[0]
    boxes = [text.get_window_extent() for text in axes.texts]
    assert len(boxes) > 4
    assert not any(box.x0 < line < box.x1 for box in boxes)
    assert "< 1e-06" in words(figure)


def test_a_neglected_but_significant_effect_stands_out(drawn: Drawn) -> None:
    figure = drawn(ablated_run())
    wrong = [
        label for label in figure.axes[0].get_yticklabels() if label.get_color() == PLAIN.warning
    ]
    assert [label.get_text() for label in wrong] == ["gravity\nNEGLECTED BUT SIGNIFICANT"]
    assert "inertia\nincluded" in names(figure)
    assert "feedback\nneglected" in names(figure)


def test_effects_without_a_bar_are_described(drawn: Drawn) -> None:
    figure = drawn(ablated_run())
    place = {text.get_text(): text for text in figure.axes[0].texts}
    told = [(text.get_text(), text.xy[1]) for text in figure.axes[0].texts]  # type: ignore[attr-defined]
    assert ("none", 9) in told
    assert ("none", 10) in told
    assert round(place["no solution without it"].xy[1]) == 2  # type: ignore[attr-defined]
    assert round(place["unbounded"].xy[1]) == 1  # type: ignore[attr-defined]
    assert round(place["< 1e-06"].xy[1]) == 8  # type: ignore[attr-defined]
    assert {row for row, _ in bars(figure)} == set(range(8))


def test_rounding_does_not_stretch_the_axis(drawn: Drawn) -> None:
    proof = (
        EffectAblation("inertia", True, 1e-3, 1e-3, 1.0),
        EffectAblation("feedback", False, 1e-20, 2e-20, 1.0),
    )
    figure = drawn(ablated_run(proof=proof, effects=(VERDICTS[8], VERDICTS[10])))
    low, _ = figure.axes[0].get_xlim()
    assert low > 0.1 * SMALLEST_BAR * 0.545
