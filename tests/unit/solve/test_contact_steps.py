"""Scenes with a ground: what they say, what refuses them, and what becomes of their columns."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign import accuracy, compile, simulate, sweep
from viscodesign.errors import SolveError, SpecError
from viscodesign.report.read_run import read_run
from viscodesign.scene.scene import Scene
from viscodesign.solve.statics import rest
from viscodesign.solve.transient import integrate

FLOOR = "loads={gravity: {tilt: 90 deg}, ground: {kind: line, point: {x: 0.5 mm}, normal: -90 deg, friction: 0.2}}"
SMALL = (
    "bellows.count=4",
    "input={kind: constant, value: 0}",
    "effects={gravity: on, others: off}",
)
SHORT = "run={duration: 20 ms, output_interval: 5 ms, start: rest}"


def falling(*overrides: str) -> Scene:
    return leg(*SMALL, FLOOR, SHORT, *overrides)


@pytest.mark.parametrize(
    ("ground", "message"),
    [
        ("{kind: line, normal: 0 deg, friction: 0.1}", "a line needs point"),
        ("{kind: line, point: {x: 1 mm}, friction: 0.1}", "a line needs normal"),
        ("{kind: circle, centre: {x: 1 cm}, friction: 0.1}", "a circle needs radius"),
        ("{kind: circle, centre: {x: 1 cm}, radius: 0, friction: 0}", "radius"),
        ("{kind: circle, centre: {x: 1 cm}, radius: 1 mm, normal: 0, friction: 0}", "has no normal"),
        ("{kind: line, point: {x: 1 cm}, normal: -90 deg, friction: -0.1}", "friction"),
        ("{kind: line, point: {x: 1 cm}, normal: -90 deg, friction: 0, foot_radius: -1 mm}", "foot_radius"),
        ("{kind: cube, friction: 0.1}", "'line' or 'circle'|line, circle"),
        ("{kind: line, point: {x: 1 cm}, normal: -90 deg}", "friction"),
    ],
)  # fmt: skip
def test_a_ground_that_is_none_is_refused_with_its_key(ground: str, message: str) -> None:
    with pytest.raises(SpecError, match=message) as refusal:
        leg(f"loads.ground={ground}")
    assert "loads.ground" in str(refusal.value)


@pytest.mark.parametrize(
    ("override", "message"),
    [
        ("loads.ground.normal=90 deg", "the straight actuator is 0.5 mm inside the ground"),
        ("loads.ground.foot_radius=2 mm", "1.5 mm inside the ground"),
    ],
)
def test_an_actuator_inside_the_ground_is_refused(override: str, message: str) -> None:
    with pytest.raises(SpecError, match=message):
        simulate(falling(override))


def test_a_start_that_loads_press_into_the_ground_is_refused() -> None:
    # The free end of the whole leg sinks by 1 mm.
    scene = leg("input={kind: constant, value: 0}", FLOOR, "effects={gravity: on, others: off}")
    with pytest.raises(SolveError, match=r"tip would be .* inside the ground") as refusal:
        simulate(scene)
    assert "run.start: rest" in str(refusal.value)


def test_a_periodic_start_is_refused() -> None:
    swinging = "input={kind: sine, amplitude: 1 kPa, frequency: 1 Hz}"
    with pytest.raises(SpecError, match="no periodic start"):
        simulate(falling(swinging, "run.start=periodic"))


def test_what_cannot_follow_a_contact_says_so() -> None:
    for call in (
        lambda: compile(falling(), "actuator.density", "tip_x_m"),
        lambda: accuracy(falling()),
    ):
        with pytest.raises(SpecError, match=r"cannot follow an actuator that touches.*ground: off"):
            call()
    assert compile(falling("effects.ground=off"), "actuator.density", "tip_x_m")()


def test_designs_with_a_ground_are_simulated() -> None:
    found = sweep(falling(), ["loads.ground.friction=0.1,0.3"])
    assert [found.results[k].status for k in (0, 1)] == ["complete", "complete"]


def test_columns_survive_the_folder_of_a_run(tmp_path: Path) -> None:
    run = simulate(falling("loads.ground.touches=sections"))
    assert run.contacts == ("section_1", "tip")
    run.save(tmp_path / "run", plots=False, report=False)
    again = read_run(tmp_path / "run")
    assert again.contacts == run.contacts
    for name in ("contact_normal", "contact_tangential", "contact_gap"):
        np.testing.assert_array_equal(again[name], run[name])
    assert "contact_gap_section_1_m" in run.frame().columns


def test_a_run_without_a_ground_has_no_such_columns(tmp_path: Path) -> None:
    run = simulate(falling("effects.ground=off"))
    assert run.contacts == ()
    assert not [name for name in run.frame().columns if "contact" in name]
    run.save(tmp_path / "run", plots=False, report=False)
    assert read_run(tmp_path / "run").contacts == ()


def test_a_massless_rod_lies_on_the_ground_from_the_start() -> None:
    run = simulate(falling())
    assert run["contact_gap"][0, 0] == pytest.approx(0.0, abs=1e-9)
    assert run["contact_normal"][:, 0] == pytest.approx(run["contact_normal"][-1, 0], rel=1e-6)
    assert run["contact_normal"][-1, 0] > 0.0


def test_steps_grow_where_nothing_changes() -> None:
    """An hour at rest on the ground takes no more steps than a second."""
    counts = []
    for duration in ("1 s", "1 h"):
        scene = falling(f"run={{duration: {duration}, output_times: [{duration}], start: rest}}")
        problem = problem_of(scene)
        start = rest(problem, problem.schedule.initial_piece)
        found = integrate(problem, start, 1e-5)
        assert found.failure is None
        counts.append(found.work.steps)
    assert counts[1] <= 2 * counts[0] + 10
