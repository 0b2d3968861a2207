"""The error that a run states of itself, against errors measured with tight references."""

from __future__ import annotations

import os
import signal
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import Trajectory, simulate
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion import Motion, read_motion
from viscodesign.results.trajectory import RunInterruptedError
from viscodesign.scene.scene import Scene
from viscodesign.simulation import error_control as verifying
from viscodesign.simulation import solve_once
from viscodesign.simulation.build_problem import Settings, suggest_settings
from viscodesign.simulation.error_control import ErrorParts, Verifier
from viscodesign.simulation.missed_effects import EffectEscalation
from viscodesign.simulation.solve_once import Run, solve

GRAVITY = "loads.gravity={tilt: 90 deg}"
SHORT = "run={duration: 2 s, output_interval: 0.05 s}"
SCENES = {
    "arcs": (SHORT, "effects={pressure_distribution: on, others: off}"),
    "dynamic": (SHORT, "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}"),
    "loaded": (SHORT, GRAVITY, "effects={pressure_distribution: on, gravity: on, others: off}"),
    "coarse": (SHORT, GRAVITY, "accuracy=3 %", "effects={pressure_distribution: on, gravity: on, others: off}"),
    "undamped": (
        "run={duration: 0.1 s, output_interval: 5 ms, start: rest}", "actuator.damping_time=0", "bellows.count=4",
        "input={kind: constant, value: 0}", "loads.tip_force.x=0.2 N", "effects={inertia: on, others: off}",
    ),
}  # fmt: skip


def reference(scene: Scene) -> Trajectory:
    finer = {"accuracy": scene.accuracy / 20}
    return simulate(scene.model_copy(update=finer), verify=True)


def true_error(found: Trajectory, exact: Trajectory) -> float:
    apart = found.tip[:, :2] - exact.tip[:, :2]
    return float(np.max(np.hypot(apart[:, 0], apart[:, 1])))


@pytest.mark.parametrize("overrides", SCENES.values(), ids=SCENES)
def test_stated_error_covers_the_true_one(overrides: tuple[str, ...]) -> None:
    scene = leg(*overrides)
    found, exact = simulate(scene), reference(scene)
    assert found.status == exact.status == "complete"
    stated = found.accuracy.estimated_tip_error_m
    assert stated is not None
    assert stated <= found.accuracy.requested_m
    slack = exact.accuracy.estimated_tip_error_m or 0.0
    assert true_error(found, exact) <= stated + slack
    assert stated <= 30 * true_error(found, exact) + slack


def test_parts_add_up_and_arcs_have_no_mesh() -> None:
    accuracy = simulate(leg(*SCENES["arcs"])).accuracy
    assert accuracy.space_m == accuracy.omitted_m == 0.0
    assert accuracy.estimated_tip_error_m == accuracy.time_m
    accuracy = simulate(leg(*SCENES["loaded"])).accuracy
    parts = (accuracy.time_m, accuracy.space_m, accuracy.omitted_m)
    assert all(part is not None for part in parts)
    assert accuracy.estimated_tip_error_m == pytest.approx(sum(p or 0.0 for p in parts))
    assert (accuracy.space_m or 0.0) > 0.0


def test_omitted_effects_are_part_of_the_error() -> None:
    """What auto leaves out, told beforehand, is close to what taking it all in changes."""
    scene = leg(SHORT, GRAVITY, "effects=auto")
    found, exact = simulate(scene), simulate(leg(SHORT, GRAVITY, "effects={others: on}"))
    accuracy = found.accuracy
    assert accuracy.omitted_m is not None
    assert accuracy.omitted_m > 0.0
    slack = exact.accuracy.estimated_tip_error_m or 0.0
    assert true_error(found, exact) <= (accuracy.estimated_tip_error_m or 0.0) + slack
    # Forbidden effects are no error of the run.
    assert (
        simulate(leg(SHORT, GRAVITY, "effects={others: off}"), verify=False).accuracy.omitted_m == 0
    )


def test_unverified_says_so_and_costs_nothing() -> None:
    found = simulate(leg(*SCENES["dynamic"]), verify=False)
    assert found.accuracy.method == "not verified"
    assert found.accuracy.estimated_tip_error_m is None
    assert found.accuracy.time_m is None
    assert found.cost.verify_s == 0.0


class Stubborn(Verifier):
    """A verifier whose errors never fall: what a scene without a limit would do."""

    def verify(self, run, coarser=None):  # type: ignore[no-untyped-def]
        run, parts = super().verify(run, coarser)
        assert parts is not None
        return run, replace(parts, space_m=2 * self.requested_m)


def test_an_accuracy_out_of_reach_ends_with_the_error_reached(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("viscodesign.simulation.simulate.Verifier", Stubborn)
    found = simulate(leg(*SCENES["loaded"]))
    assert found.status == "failed"
    assert found.failure is not None
    assert "space 1.09 mm" in found.failure
    assert found.accuracy.estimated_tip_error_m is not None
    assert len(found.time) == 41


def test_a_coarse_first_solution_is_refined_until_it_serves() -> None:
    scene = leg(*SCENES["dynamic"], "accuracy=0.05 %")
    quantities = SceneQuantities(scene)
    selection = select_effects(quantities)
    verifier = Verifier(quantities, selection.effects, selection.neglected_m, None)
    run = verifier.solve(Settings(1, 1e-2))
    finest, parts = verifier.verify(run)
    assert isinstance(parts, ErrorParts)
    assert parts.total_m <= verifier.requested_m
    assert finest.settings.tolerance <= 1e-4
    assert verifier.solutions >= 4


def test_a_wish_to_stop_in_the_last_moment_is_obeyed() -> None:
    scene = leg(*SCENES["arcs"])
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    verifier = Verifier(quantities, effects, 0.0, None)
    run = verifier.solve(suggest_settings(quantities, effects))
    run.solution.asked_to_stop = True
    kept, parts = verifier.verify(run)
    assert kept is run
    assert parts is None
    assert verifier.interrupted
    assert verifier.solutions == 1


def test_a_finer_solution_without_a_start_leaves_the_coarser_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = leg(*SCENES["loaded"])
    solutions: list[Run] = []

    def second_fails(*arguments: Any) -> Run:
        if solutions:
            raise SolveError("no way", quantity="work", where="rod", remedy="Go elsewhere.")
        solutions.append(solve(*arguments))
        return solutions[0]

    monkeypatch.setattr(verifying, "solve", second_fails)
    run = simulate(scene)
    assert run.status == "failed"
    assert run.failure is not None
    assert (
        "could not be estimated: the refined problem has no initial equilibrium: no way"
        in run.failure
    )
    assert np.array_equal(run.tip, solutions[0].motion.tip)


def interrupted_run(scene: Scene) -> Trajectory:
    """What an interrupted simulation came to."""
    with pytest.raises(RunInterruptedError) as stopped:
        simulate(scene)
    assert stopped.value.trajectory is not None
    return stopped.value.trajectory


@pytest.mark.parametrize("solved", [1, 2])
def test_an_interrupt_between_two_solutions_keeps_the_one_before(
    solved: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    solutions: list[Run] = []

    def interrupted(*arguments: Any) -> Run:
        if len(solutions) == solved:
            raise KeyboardInterrupt
        solutions.append(solve(*arguments))
        return solutions[-1]

    monkeypatch.setattr(verifying, "solve", interrupted)
    run = interrupted_run(leg(*SCENES["dynamic"]))
    assert run.status == "interrupted"
    assert np.array_equal(run.tip, solutions[-1].motion.tip)


def test_an_interrupt_while_a_solution_is_read_keeps_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*arguments: Any) -> Motion:
        os.kill(os.getpid(), signal.SIGINT)
        return read_motion(*arguments)

    monkeypatch.setattr(solve_once, "read_motion", interrupted)
    run = interrupted_run(leg(*SCENES["dynamic"]))
    assert run.status == "interrupted"
    assert len(run.time) == 41


def test_an_interrupt_before_more_effects_keeps_the_run_without_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    solutions: list[Run] = []

    def interrupted(*arguments: Any) -> Run:
        if solutions:
            raise KeyboardInterrupt
        solutions.append(solve(*arguments))
        return solutions[-1]

    def more(_: Any, selection: Selection, __: Run) -> EffectEscalation:
        return EffectEscalation(selection, "more", "it moves the tip", 0.0)

    monkeypatch.setattr(verifying, "solve", interrupted)
    monkeypatch.setattr("viscodesign.simulation.simulate.escalation", more)
    run = interrupted_run(leg(*SCENES["dynamic"]))
    assert run.status == "interrupted"
    assert np.array_equal(run.tip, solutions[0].motion.tip)
