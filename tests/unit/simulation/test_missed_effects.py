"""What a run calls for that the estimates had neglected."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.hard.found_cases import LEFT_ITS_FLOOR
from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation import simulate as simulating
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.judged_effects import EffectJudge
from viscodesign.simulation.missed_effects import escalation
from viscodesign.simulation.solve_once import Run, solve

STIFF = "effects={gas_compressibility: off, others: auto}"
"""The gas goes so fast that it would be called for, too; here it may not."""

Solved = tuple[SceneQuantities, Selection, Run]


def without_losses(quantities: SceneQuantities) -> Selection:
    """What estimates choose that are blind to the losses of fast flow."""
    selection = select_effects(quantities)
    active = selection.switched({"flow_regime": False})
    assert active is not None
    verdicts = tuple(replace(v, taken=v.taken and v.name in active) for v in selection.verdicts)
    return replace(selection, active=active, verdicts=verdicts)


def solved(
    *overrides: str, choose: Callable[[SceneQuantities], Selection] = without_losses
) -> Solved:
    quantities = SceneQuantities(leg(*overrides))
    selection = choose(quantities)
    run = solve(quantities, selection.effects, suggest_settings(quantities, selection.effects))
    return quantities, selection, run


def seen_with(run: Run, **arrays: np.ndarray) -> Run:
    """A run with some quantities replaced at all times that were solved for."""
    motion = run.motion.at_solved_times().with_arrays(**arrays)
    return replace(run, motion=replace(motion, between={}))


@pytest.fixture(scope="module")
def fast() -> Solved:
    return solved(*LEFT_ITS_FLOOR, STIFF)


def test_fast_flow_calls_for_its_losses_once(fast: Solved) -> None:
    quantities, selection, run = fast
    assert "flow_regime" not in selection.active
    found = escalation(quantities, selection, run)
    assert found is not None
    assert found.selection.active == selection.active | {"flow_regime"}
    (verdict,) = (v for v in found.selection.verdicts if v.name == "flow_regime")
    assert verdict.taken
    assert "at the computed flows it would cost" in verdict.reason
    again = solve(quantities, found.selection.effects, run.settings)
    assert escalation(quantities, found.selection, again) is None


def test_a_gas_too_fast_for_its_model_calls_for_what_describes_it_however_little_it_moves() -> None:
    quantities, selection, run = solved(*LEFT_ITS_FLOOR, "accuracy=20 %")
    assert "gas_compressibility" not in selection.active
    found = escalation(quantities, selection, run)
    while found is not None and "gas_compressibility" not in found.selection.active:
        selection = found.selection
        run = solve(quantities, selection.effects, run.settings)
        found = escalation(quantities, selection, run)
    assert found is not None
    (verdict,) = (v for v in found.selection.verdicts if v.name == "gas_compressibility")
    assert "reaches Mach" in verdict.reason


def test_what_the_spec_forbids_is_not_called_for(fast: Solved) -> None:
    scene = leg(
        *LEFT_ITS_FLOOR, "effects={others: auto, gas_compressibility: off, flow_regime: off}"
    )
    quantities = SceneQuantities(scene)
    selection = select_effects(quantities)
    assert escalation(quantities, selection, fast[2]) is None


def test_a_rod_that_does_not_move_calls_for_nothing(fast: Solved) -> None:
    quantities, selection, run = fast
    times = len(run.motion.at_solved_times().time)
    still = np.tile([0.0, quantities.body.length, 0.0], (times, 1))
    assert escalation(quantities, selection, seen_with(run, tip=still)) is None


def test_the_first_instant_does_not_count(fast: Solved) -> None:
    quantities, selection, run = fast
    found = run.motion.at_solved_times().flow
    flow = np.zeros_like(found)
    flow[0] = found.max()
    assert escalation(quantities, selection, seen_with(run, flow=flow)) is None


def test_it_does_not_hang_on_the_output_times(fast: Solved) -> None:
    """As if every output fell on a moment at which nothing flows."""
    quantities, selection, run = fast
    unseen = run.motion.with_arrays(flow=np.zeros_like(run.motion.flow))
    found = escalation(quantities, selection, replace(run, motion=unseen))
    assert found is not None
    assert found.selection.active == selection.active | {"flow_regime"}


def test_slow_flow_calls_for_nothing() -> None:
    assert escalation(*solved("effects=auto", choose=select_effects)) is None


def test_needed_and_free_effects_are_included_with_it() -> None:
    quantities = SceneQuantities(
        leg("effects=auto", "accuracy=20 %", "input={kind: constant, value: 1 kPa}")
    )
    selection = select_effects(quantities)
    assert not selection.active & {"pressure_distribution", "flow_regime", "fluid_inertance"}
    grown = selection.grown(["flow_regime"], "it is asked for")
    assert grown is not None
    assert grown.active - selection.active == {
        "pressure_distribution",
        "flow_regime",
        "fluid_inertance",
    }
    assert grown.grown(["flow_regime"], "it is asked for") is None


def test_a_repeated_run_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulating, "select_effects", without_losses)
    run = simulate(leg(*LEFT_ITS_FLOOR, STIFF), verify=False)
    (rung,) = run.ladder
    assert (rung.tried, rung.solved) == ("flow_regime included, from the start", True)
    assert "times the largest pressure" in rung.reason
    assert "turbulent_flow" not in {notice.code for notice in run.warnings}


def test_what_the_solution_with_everything_calls_for_repeats_no_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The run has it from the start."""
    monkeypatch.setattr(simulating, "select_effects", without_losses)
    run = simulate(leg(*LEFT_ITS_FLOOR, STIFF))
    (found,) = (v for v in run.effects if v.name == "flow_regime")
    assert found.taken
    assert "times the largest pressure" in found.reason
    assert not any("flow_regime" in rung.tried for rung in run.ladder)


def test_without_a_start_the_first_run_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    solve_scene = simulating._solve

    def first_only(*args: Any) -> Any:
        if "flow_regime" in args[1].active:
            raise SolveError("no pressures", quantity="pressure", where="network")
        return solve_scene(*args)

    monkeypatch.setattr(simulating, "select_effects", without_losses)
    monkeypatch.setattr(simulating, "_solve", first_only)
    # Or that solution would call for it before there is a run.
    monkeypatch.setattr(EffectJudge, "everything", lambda *_: None)
    scene = leg(*LEFT_ITS_FLOOR)
    run = simulate(scene)
    assert (run.status, len(run.time)) == ("failed", len(scene.run.output_times_array()))
    assert run.failure is not None
    assert "flow_regime included, from the start" in run.failure
    assert "no pressures" in run.failure
    assert [rung.solved for rung in run.ladder] == [False]
    # The missing effect is still warned of.
    assert "turbulent_flow" in {notice.code for notice in run.warnings}
