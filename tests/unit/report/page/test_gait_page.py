"""The page of a gait as a reader sees it, in headless Chromium."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.robots import hexapod
from viscodesign import WalkStudy, walk
from viscodesign.report.page.gait_page import write_gait_page
from viscodesign.report.walk_folder import write_walk

from .conftest import Open
from .test_page_in_browser import ROUNDING, columns, drawn


@pytest.fixture(scope="module")
def study() -> WalkStudy:
    """Two cycles with long steps."""
    rough = ("robot.damping_time=200 ms", "run.duration=5 s", "accuracy=20 %")
    return walk(hexapod(*rough), steps_per_cycle=30)


def test_what_is_drawn_is_the_table(open_page: Open, study: WalkStudy, tmp_path: Path) -> None:
    write_walk(study, tmp_path, plots=False)
    page, written = open_page(study, write=write_gait_page), columns(tmp_path / "walk.csv")
    assert (tmp_path / "report.html").read_bytes() == (tmp_path / "page0.html").read_bytes()
    body, height, _, lift, normal, friction, pressure, barrel = drawn(page, ".chart")
    for (found, pixel), name, column, factor in (
        (body, "x", "body_x_m", 1e3),
        (height, "height", "body_height_m", 1e3),
        (lift, "LM", "LM.foot_gap_m", 1e3),
        (normal, "RR", "RR.normal_force_n", 1.0),
        (friction, "LF", "LF.friction_force_n", 1.0),
        (pressure, "B", "B.gauge_pressure_pa", 1e-3),
        (barrel, "A", "A.barrel_m3", 1e6),
    ):
        expected = written["time_s"], factor * written[column]
        for curve, values, size in zip(found[name].T, expected, pixel, strict=True):
            np.testing.assert_allclose(curve, values, rtol=0, atol=ROUNDING * size)


def test_a_foot_bears_where_the_table_says(open_page: Open, study: WalkStudy) -> None:
    page, motion = open_page(study, write=write_gait_page), study.motion
    for shown in (0, 7, len(motion.rows) - 1):
        page.evaluate("row => seek(player, row)", shown)
        row = motion.rows[shown]
        told = float(str(page.text_content("#clock")).removeprefix("t = ").removesuffix(" s"))
        assert told == pytest.approx(motion.time[row], abs=0.005)
        feet = page.eval_on_selector_all(
            ".foot", "all => all.map(e => [e.cx.baseVal.value, e.cy.baseVal.value])"
        )
        expected = 1e3 * motion.axes[shown, :, -1] * [1, -1]
        np.testing.assert_allclose(feet, expected, atol=0.02)
        fills = page.eval_on_selector_all(".foot", "all => all.map(e => e.getAttribute('fill'))")
        arrows = page.eval_on_selector_all(".force", "all => all.map(e => e.getAttribute('d'))")
        bears = (motion.normal[row] > 0).tolist()
        assert [fill != "none" for fill in fills] == bears
        assert [bool(arrow) for arrow in arrows] == bears


@pytest.mark.parametrize(
    ("end", "told"),
    [("", "No speed is stated: it wanders."), ("failed", "This run failed: it ended at t = 5 s.")],
)
def test_a_gait_without_speed_says_so(
    open_page: Open, study: WalkStudy, end: str, told: str
) -> None:
    page = open_page(replace(study, end=end, refusal="it wanders"), write=write_gait_page)
    assert told in page.text_content("#banners")
    assert page.title().startswith("FAILED" if end else "REFUSED")
    assert "not stated" in page.text_content("#gait")
