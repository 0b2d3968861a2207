"""The step limit covers all attempts together, and is named as the reason for the end."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.scenes import CONFIGS, leg
from viscodesign import load, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.report.run_folder import write_run
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.simulation.solve_once import solve
from viscodesign.solve.solvers.rodas_stretch import CONTROL

PERIODS = "input={kind: sine, amplitude: 20 kPa, frequency: 0.3 Hz}"


def test_steps_of_failed_attempts_count() -> None:
    run = simulate(
        leg(PERIODS, "run={duration: 26000 s, output_interval: 1000 s, max_steps: 1000}")
    )
    assert run.status == "failed"
    assert "the limit of 1000 steps was reached" in (run.failure or "")
    assert 1000 <= run.cost.steps < 2000
    assert not run.ladder


def test_a_run_without_outputs_writes_complete_files(tmp_path: Path) -> None:
    run = simulate(leg("run={duration: 8 s, output_times: [8], max_steps: 100}"))
    assert run.status == "failed"
    assert "the limit of 100 steps was reached" in (run.failure or "")
    assert run.tip.shape == (0, 3)
    write_run(run, tmp_path, plots=False)
    assert len((tmp_path / "trajectory.csv").read_text().splitlines()) == 1
    assert json.loads((tmp_path / "summary.json").read_text())["status"] == "failed"


@pytest.mark.parametrize("name", ["idas", "radau", "rosenbrock"])
def test_every_solver_respects_the_step_limit(name: str) -> None:
    quantities = SceneQuantities(
        leg(PERIODS, "run={duration: 50 s, output_times: [50], max_steps: 120}")
    )
    effects = select_effects(quantities).effects
    run = solve(quantities, effects, Settings(1, 1e-4, name))
    assert run.motion.failure is not None
    assert run.motion.failure.quantity == "work"
    assert 100 <= run.solution.work.steps < 250
    assert run.solution.work.residual_calls < 50 * 120


def test_a_finer_mesh_of_a_damped_rod_takes_no_more_steps() -> None:
    """How the force of damping turns with the nodes is as stiff as the mesh is fine."""
    scene = leg(
        "effects={pressure_distribution: on, inertia: on, damping: on, gravity: on, others: off}"
    )
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    coarse, fine = (
        solve(quantities, effects, Settings(edges, 1e-3)).solution.work.steps for edges in (2, 16)
    )
    assert fine < 1.2 * coarse


def steps_of(*overrides: str) -> int:
    scene = leg("run={duration: 40 s, output_times: [40]}", "effects.inertia=on", *overrides)
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    return solve(quantities, effects, Settings(1, 1e-2, "rosenbrock")).solution.work.steps


def test_straight_inputs_take_as_few_steps_as_the_tolerance_allows() -> None:
    """Between its corners nothing of a straight input can be missed; of a smooth one it can."""
    stretches = 4
    square = steps_of("input={kind: square, high: 2 kPa, low: 0, frequency: 0.05 Hz}")
    assert CONTROL.min_steps_per_line * stretches <= square < 40 * stretches
    smooth = steps_of(
        "input={kind: double_sigmoid, start: 2 kPa, drop: 2 kPa, fall_time: 5 s, "
        "rise_time: 6 s, transition: 0.1 s}"
    )
    assert smooth >= CONTROL.min_steps_per_stretch


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [("square", "square", True), ("square", "sine", False), ("sine", "sine", False)],
)
def test_inputs_are_straight_where_all_of_them_are(left: str, right: str, expected: bool) -> None:
    kinds = {
        "square": {"kind": "square", "high": "2 kPa", "low": 0, "frequency": "1 Hz"},
        "sine": {"kind": "sine", "amplitude": "2 kPa", "frequency": "1 Hz"},
    }
    spec = CONFIGS / "antagonistic_two_inlets.yaml"
    names = tuple(load(spec).inputs)
    scene = load(spec, {"inputs": dict(zip(names, (kinds[left], kinds[right]), strict=True))})
    quantities = SceneQuantities(scene)
    problem = build(quantities, select_effects(quantities).effects, Settings(1, 1e-3))
    assert problem.has_straight_inputs is expected
