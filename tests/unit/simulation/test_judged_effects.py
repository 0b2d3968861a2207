"""What neglected effects do, measured by one solution with all of them."""

from __future__ import annotations

from typing import Any

import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation import judged_effects
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.judged_effects import JUDGING, EffectJudge
from viscodesign.simulation.solve_once import Run, Workspace, solve, tip_difference

SHORT = ("run={duration: 2 s, output_interval: 0.1 s}", "effects=auto", "bellows.count=8")


def judged() -> tuple[SceneQuantities, Any, Run]:
    quantities = SceneQuantities(leg(*SHORT))
    selection = select_effects(quantities)
    assert selection.neglected
    return quantities, selection, solve(quantities, selection.effects, settings_of(quantities))


def settings_of(quantities: SceneQuantities) -> Any:
    return suggest_settings(quantities, select_effects(quantities).effects)


def test_the_distance_is_that_to_a_solution_with_everything() -> None:
    quantities, selection, run = judged()
    found = EffectJudge(quantities, None, Workspace()).omission(selection, run)
    assert found is not None
    everything = solve(quantities, selection.members(selection.everything), run.settings)
    assert found.tip_m == tip_difference(run.motion, everything.motion) > 0.0
    assert found.time_s in run.motion.time


def test_it_is_what_a_run_states() -> None:
    quantities, selection, run = judged()
    found = EffectJudge(quantities, None, Workspace()).omission(selection, run)
    assert found is not None
    accuracy = simulate(leg(*SHORT)).accuracy
    assert accuracy.omitted_m == selection.stated(JUDGING.stated_per_measured * found.tip_m)
    assert "between two solutions, with and without them" in accuracy.method


def test_everything_is_solved_once_whatever_is_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    quantities, selection, run = judged()
    solved = []

    def counted(*arguments: Any) -> Run:
        solved.append(arguments)
        return solve(*arguments)

    monkeypatch.setattr(judged_effects, "solve", counted)
    judge = EffectJudge(quantities, None, Workspace())
    whole = selection.grown(selection.everything, "to see")
    assert whole is not None
    assert judge.omission(whole, run) is None
    assert solved == []
    assert judge.omission(selection, run) == judge.omission(selection, run) is not None
    assert len(solved) == 1


def test_a_scene_that_cannot_be_solved_with_everything_is_estimated(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fails(*_: Any) -> Run:
        raise SolveError("none", quantity="equilibrium", where="rod", time_s=0.0, remedy="None.")

    monkeypatch.setattr(judged_effects, "solve", fails)
    found = simulate(leg(*SHORT))
    selection = select_effects(SceneQuantities(leg(*SHORT)))
    assert found.status == "complete"
    assert found.accuracy.omitted_m == selection.neglected_m
    assert "between two estimates, with and without them" in found.accuracy.method


def test_an_interrupt_meanwhile_keeps_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any) -> Run:
        raise KeyboardInterrupt

    monkeypatch.setattr(judged_effects, "solve", interrupted)
    found = simulate(leg(*SHORT))
    assert found.status == "interrupted"
    assert found.time[-1] == 2.0


def test_without_verification_nothing_is_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judged_effects, "solve", None)
    assert simulate(leg(*SHORT), verify=False).status == "complete"


def test_what_does_too_much_is_added_one_by_one_and_then_all() -> None:
    quantities, selection, _ = judged()
    judge = EffectJudge(quantities, None, Workspace())
    far = judged_effects.Omission(1.0, 0.5)
    first = judge.escalation(selection, far)
    assert first is not None
    does = {v.name: v.contribution_m for v in selection.verdicts}
    most = max((e.name for e in selection.neglected), key=lambda name: does[name])
    assert most in first.selection.active
    assert first.selection.active < selection.everything
    assert "move the tip by 1e+03 mm" in first.reason
    assert judge.escalation(selection, far) is not None
    last = judge.escalation(selection, far)
    assert last is not None
    assert last.selection.active == selection.everything
    assert judge.escalation(selection, judged_effects.Omission(1e-9, 0.5)) is None
