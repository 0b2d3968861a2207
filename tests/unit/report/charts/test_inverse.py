"""Pictures of designs and of reach, from made-up numbers: z down from the clamp, equal scales."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.axes import Axes

from tests.unit.report.charts.conftest import Save, assert_on_page, words
from viscodesign.report.charts.design import draw_design
from viscodesign.report.charts.reach import draw_reach
from viscodesign.results.path_design import HistoryRow, without_design
from viscodesign.results.reach_study import ReachStudy


def box(low: float, high: float, half: float) -> np.ndarray:
    """Corners of a set [m] from z = low to high."""
    return np.array([[-half, low], [half, low], [half, high], [-half, high]])


def assert_hangs(axes: Axes) -> None:
    """z points down, and a millimetre is as long either way."""
    low, high = axes.get_ylim()
    assert low > high
    assert axes.get_ylabel() == "z [mm], down from the clamp"
    size = axes.get_window_extent()
    left, right = axes.get_xlim()
    assert (right - left) / size.width == pytest.approx((low - high) / size.height, rel=1e-6)


@pytest.mark.parametrize(("low", "near"), [(0.01, True), (0.1, False)])
@pytest.mark.parametrize("half", [0.03, 0.004])
def test_reach_draws_the_clamp_where_it_is_near(
    low: float, near: bool, half: float, save: Save
) -> None:
    edge = box(low, low + 0.06, half)
    study = ReachStudy("leg", (-1e3, 2e3), None, edge, edge * [1.1, 1.0], None, None, 0.0)
    picture = save(draw_reach, study)
    assert_on_page(picture)
    assert_hangs(picture.axes[0])
    assert ("clamp" in words(picture)) == near
    assert (min(picture.axes[0].get_ylim()) < 0.0) == near


def test_a_design_hangs_and_says_how_near_it_came(save: Save) -> None:
    way = box(0.1, 0.11, 0.02)
    found = without_design(
        "leg", "not_met", "", tolerance_m=1e-4, wanted=way, closed=True, evaluations=9
    )
    history = (HistoryRow(1, 0.1, 1e-3, ""), HistoryRow(4, 0.3, 3e-4, ""))
    picture = save(
        draw_design, replace(found, found=1.01 * way, confirmed_rms_m=3e-4, history=history)
    )
    assert_on_page(picture)
    assert_hangs(picture.axes[0])
    assert "leg: not met, 0.3 mm rms of 0.1 mm allowed" in words(picture)
    assert {"0.2", "0.5", "1"} <= set(words(picture))
