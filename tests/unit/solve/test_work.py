"""The step limit covers all attempts together, and is named as the reason for the end."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.report.run_folder import write_run
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import solve

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
