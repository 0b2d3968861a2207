"""The page of several actuators as a reader sees it, in headless Chromium."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tests.trajectories import made_run
from viscodesign.report.page.several_page import several_data, write_several_page
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.results.trajectory import Trajectory

from .conftest import Open
from .test_page_in_browser import drawn


def delivering(run: Trajectory) -> Trajectory:
    """With what its inlet has delivered."""
    return replace(run, arrays={**run.arrays, "inflow": 1e-6 * run.time[:, None]})


def made() -> SeveralRuns:
    """Two equal actuators and one that ended early."""
    run = delivering(made_run())
    early = delivering(made_run(time=run.time[:200], status="failed", failure="it broke"))
    return SeveralRuns(
        name="three",
        runs={"one": run, "two": run, "three": early},
        equal_to={"two": "one"},
        sources={"one": {"inlet": "A"}, "two": {"inlet": "A"}, "three": {"inlet": "B"}},
        failures={},
        interrupted=(),
        spec_text="name: three",
        spec_sha256="0" * 64,
        version="1",
    )


def test_all_are_drawn_at_one_time(open_page: Open) -> None:
    found = made()
    page = open_page(found, write=write_several_page)
    (curves, pixel), _, (sources, _) = drawn(page, ".chart")
    assert set(sources) == {"A", "B"}
    for name, run in found.runs.items():
        np.testing.assert_allclose(curves[name].T[1], 1e3 * run.tip[:, 0], atol=0.01 * pixel[1])
    page.evaluate("seek(player, 100)")
    assert page.text_content("#clock") == "t = 2.00 s"
    tips = page.eval_on_selector_all(
        "#actuators .tip", "all => all.map(e => [e.cx.baseVal.value, e.cy.baseVal.value])"
    )
    np.testing.assert_allclose(tips, [1e3 * r.tip[100, :2] for r in found.runs.values()], atol=4e-3)
    page.evaluate("seek(player, 300)")
    ended = page.eval_on_selector_all(
        "#actuators figure", "all => all.map(e => e.classList.contains('ended'))"
    )
    assert ended == [False, False, True]
    assert "it broke" in page.text_content("#banners")
    assert page.title() == "FAILED: three"


def test_equal_motions_are_stored_once() -> None:
    one, two, _ = several_data(made())["actuators"]
    assert "tip" in one["run"]
    assert two["run"] == {}


def test_sources_behind_tubes_are_named_and_drawn(open_page: Open) -> None:
    found = made()
    time = found.runs["one"].time
    pressure = 4e4 + 1e3 * np.sin(time)
    shared = CoupledMotion(
        ("one", "two", "three"),
        time,
        {"A": 1e-6 * time},
        {"A": pressure},
        {"tee": pressure - 50},
        {},
    )
    behind = replace(found, sources={name: {} for name in found.runs}, coupled=(shared,))
    assert [own["sources"] for own in several_data(behind)["actuators"]] == [["A"]] * 3
    page = open_page(behind, write=write_several_page)
    curves, pixel = drawn(page, ".chart")[2]
    assert set(curves) == {"A", "tee"}
    np.testing.assert_allclose(curves["A"].T[1], 1e-3 * pressure, atol=0.01 * pixel[1])
    assert "fed by A" in page.text_content("#actuators")
    page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    assert page.is_visible("#spec")
