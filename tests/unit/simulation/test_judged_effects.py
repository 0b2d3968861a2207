"""What neglected effects do, measured by one solution with all of them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import load, simulate
from viscodesign.effects.select import NUMBERS, Selection, select_effects
from viscodesign.errors import SolveError, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.trajectory import RunInterruptedError
from viscodesign.simulation import error_control, judged_effects
from viscodesign.simulation import simulate as simulation_module
from viscodesign.simulation.build_problem import Settings, suggest_settings
from viscodesign.simulation.judged_effects import (
    JUDGING,
    EffectJudge,
    Omission,
    coarser,
    judgeable,
    mesh_share,
)
from viscodesign.simulation.missed_effects import EffectEscalation
from viscodesign.simulation.solve_once import Run, Workspace, solve, tip_difference

SHORT = ("run={duration: 2 s, output_interval: 0.1 s}", "effects=auto", "bellows.count=8")
LENIENT = "accuracy=0.7 %"
"""As much as effects and steps do together, each counted in full."""


def judged(*more: str) -> tuple[SceneQuantities, Selection, Run]:
    quantities = SceneQuantities(leg(*SHORT, *more))
    selection = select_effects(quantities)
    assert selection.neglected
    settings = judgeable(settings_of(quantities))
    return quantities, selection, solve(quantities, selection.effects, settings)


def settings_of(quantities: SceneQuantities) -> Any:
    return suggest_settings(quantities, select_effects(quantities).effects)


def judge_of(quantities: SceneQuantities, selection: Selection) -> EffectJudge:
    return EffectJudge(quantities, selection.active, None, Workspace())


def whole(judge: EffectJudge, selection: Selection, run: Run) -> Run:
    found = judge.everything(selection, run.settings)
    assert found is not None
    return found


def test_the_distance_is_that_to_a_solution_with_everything() -> None:
    quantities, selection, run = judged()
    judge = judge_of(quantities, selection)
    found = judge.omission(run, whole(judge, selection, run))
    everything = solve(quantities, selection.members(selection.everything), coarser(run.settings))
    assert found.tip_m == tip_difference(run.motion, everything.motion) > 0.0
    assert found.time_s in run.motion.time


def test_it_is_the_whole_error_that_a_run_states() -> None:
    """The coarser solution with everything comes first, then the run with fewer effects."""
    quantities, selection, run = judged()
    judge = judge_of(quantities, selection)
    found = judge.omission(run, whole(judge, selection, run))
    accuracy = simulate(leg(*SHORT)).accuracy
    least_m = JUDGING.stated_per_estimated * selection.estimated_m
    measured_m = JUDGING.stated_per_measured * found.tip_m
    stated = selection.stated(max(measured_m + selection.estimated_m, least_m))
    assert accuracy.estimated_tip_error_m == accuracy.omitted_m == stated
    assert accuracy.time_m is accuracy.space_m is None
    assert "1.25 times the distance to a solution with all effects" in accuracy.method


def test_settings_of_the_coarser_solution_halve_the_mesh() -> None:
    for edges, run, other in ((1, 2, 1), (2, 2, 1), (3, 3, 2), (8, 8, 4)):
        fine = judgeable(Settings(edges, 1e-4))
        assert fine.edges_per_section == run
        assert coarser(fine) == coarser(Settings(edges, 1e-4))
        assert coarser(fine) == Settings(other, 1e-3, for_balances=False)


@pytest.mark.parametrize(
    ("residual", "reduced"), [(None, 1.0), (1e-5, 1.0), (2e-3, 6.0), (1.0, 100.0)]
)
def test_a_run_has_the_tolerance_at_which_its_energy_balance_closes(
    residual: float | None, reduced: float
) -> None:
    """Foreseen by the coarser solution with everything: it took a run for each tenth of it."""
    quantities, selection, run = judged()
    found = whole(judge_of(quantities, selection), selection, run)
    energy = replace(found.motion.invariants, energy_imbalance_rel=residual)
    told = replace(found, motion=replace(found.motion, balances=lambda: energy))
    settings = settings_of(quantities)
    assert judgeable(settings, told).tolerance == pytest.approx(settings.tolerance / reduced)


def test_the_coarser_solution_is_not_sampled_between_the_outputs() -> None:
    """Of balances nobody asks; its tip is that of the same solution with all its samples."""
    quantities, selection, run = judged()
    found = whole(judge_of(quantities, selection), selection, run)
    effects = selection.members(selection.everything)
    sampled = solve(quantities, effects, replace(coarser(run.settings), for_balances=True))
    few, many = (len(r.problem.schedule.edges) for r in (found, sampled))
    assert 3 * few <= many
    apart = tip_difference(found.motion, sampled.motion)
    assert apart <= found.settings.tolerance * quantities.body.length


def test_a_solution_as_coarse_tells_effects_from_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the one distance is above the accuracy, but what is neglected is not."""
    scene = leg(*SHORT, "accuracy=0.02 %")
    chosen = select_effects(SceneQuantities(scene)).active
    monkeypatch.setattr(
        judged_effects, "coarser", lambda settings: Settings(1, 1000 * settings.tolerance)
    )
    sets: list[set[str]] = []

    def counted(quantities: Any, effects: Any, *more: Any) -> Run:
        sets.append({effect.name for effect in effects})
        return solve(quantities, effects, *more)

    for module in (judged_effects, error_control):
        monkeypatch.setattr(module, "solve", counted)
    found = simulate(scene)
    assert found.status == "complete"
    assert not found.ladder
    assert sets[0] > chosen
    assert sets[1] == sets[2] == chosen
    assert "between two solutions, with and without them" in found.accuracy.method


def test_everything_is_solved_once_whatever_is_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    quantities, selection, run = judged()
    solved = []

    def counted(*arguments: Any) -> Run:
        solved.append(arguments)
        return solve(*arguments)

    monkeypatch.setattr(judged_effects, "solve", counted)
    judge = judge_of(quantities, selection)
    grown = selection.grown(selection.everything, "to see")
    assert grown is not None
    assert judge.everything(grown, run.settings) is None
    assert solved == []
    assert whole(judge, selection, run) is whole(judge, selection, run)
    assert len(solved) == 1


def test_estimates_that_a_run_has_corrected_spare_no_solution() -> None:
    """They had not seen what mattered; what they say of the rest was stated, three times too low."""
    slow = "input={kind: sine, frequency: 0.001 Hz, amplitude: 5 kPa}"
    long = "run={duration: 1000 s, output_interval: 50 s}"
    quantities = SceneQuantities(leg(*SHORT, "bellows.count=4", "accuracy=5 %", slow, long))
    selection = select_effects(quantities)
    corrected = selection.grown(["gas_compressibility"], "a run called for it")
    assert corrected is not None
    assert corrected.neglected
    judge, settings = judge_of(quantities, selection), settings_of(quantities)
    assert judge.everything(selection, settings) is None
    assert not judge.has_solved
    assert judge.everything(corrected, settings) is not None


def test_effects_are_told_from_steps_once_estimates_were_corrected(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Nothing else tells then whether what is left out and the coarser mesh hide each other.

    No more is included where their sum is below the accuracy.
    """
    for answer in ("are_corrected", "is_too_much"):
        monkeypatch.setattr(EffectJudge, answer, lambda *_: True)
    found = simulate(leg(*SHORT, LENIENT))
    assert not found.ladder
    quantities, selection, run = judged(LENIENT)
    everything = whole(judge_of(quantities, selection), selection, run)
    alike = solve(quantities, selection.effects, everything.settings)
    effects_m = selection.stated(
        JUDGING.stated_per_told_apart * tip_difference(alike.motion, everything.motion)
    )
    steps_m = mesh_share(run.settings, alike.settings) * tip_difference(alike.motion, run.motion)
    assert found.accuracy.estimated_tip_error_m == pytest.approx(effects_m + steps_m)
    assert "between two solutions, with and without" in found.accuracy.method


def test_a_judged_run_costs_two_solutions(monkeypatch: pytest.MonkeyPatch) -> None:
    solved: list[Settings] = []

    def counted(quantities: Any, effects: Any, settings: Any, *more: Any) -> Run:
        solved.append(settings)
        return solve(quantities, effects, settings, *more)

    for module in (judged_effects, error_control):
        monkeypatch.setattr(module, "solve", counted)
    assert not simulate(leg(*SHORT)).ladder
    whole, run = solved
    assert whole == coarser(run)


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


def test_an_interrupt_before_its_first_step_raises(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any) -> Run:
        raise KeyboardInterrupt

    monkeypatch.setattr(judged_effects, "solve", interrupted)
    with pytest.raises(KeyboardInterrupt):
        simulate(leg(*SHORT))


def test_an_interrupt_on_the_way_keeps_what_was_solved_with_everything(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def stopped(*arguments: Any) -> Run:
        found = solve(*arguments)
        return replace(found, solution=replace(found.solution, asked_to_stop=True))

    monkeypatch.setattr(judged_effects, "solve", stopped)
    scene = leg(*SHORT)
    with pytest.raises(RunInterruptedError) as caught:
        simulate(scene)
    found = caught.value.trajectory
    assert found is not None
    assert found.status == "interrupted"
    assert "interrupted while verifying" in str(found.failure)
    selection = select_effects(SceneQuantities(scene))
    assert {v.name for v in found.effects if v.taken} == selection.everything


def test_without_verification_nothing_is_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judged_effects, "solve", None)
    assert simulate(leg(*SHORT), verify=False).status == "complete"


def test_what_does_too_much_is_added_one_by_one_and_then_all() -> None:
    quantities, selection, _ = judged()
    judge = judge_of(quantities, selection)
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
    assert judge.is_too_much(far)
    assert not judge.is_too_much(judged_effects.Omission(1e-9, 0.5))


def test_a_run_that_ends_early_for_want_of_effects_is_solved_with_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A spec of which everything completes, and the chosen set is made to fail."""
    chosen = select_effects(SceneQuantities(leg(*SHORT))).active
    failure = SolveError("ends", quantity="volume", where="R", time_s=1.0, remedy="None.")

    def fails(quantities: SceneQuantities, effects: Any, *more: Any) -> Run:
        run = solve(quantities, effects, *more)
        if {effect.name for effect in effects} != chosen:
            return run
        return replace(run, motion=replace(run.motion, failure=failure))

    monkeypatch.setattr(error_control, "solve", fails)
    found = simulate(leg(*SHORT))
    assert found.status == "complete"
    assert {v.name for v in found.effects if v.taken} > chosen
    assert "ends early without effects" in found.ladder[0].reason


def test_a_recording_that_rests_first_is_estimated_and_judged_as_a_few_rows_are(
    tmp_path: Path,
) -> None:
    """Estimates used to end in the rest, and what was left out was not measured then."""
    time = np.arange(0.0, 4.0, 0.02)
    rows = [f"{t:.2f},{15e3 * min(max(t - 2.0, 0.0), 1.0):.1f}" for t in time]
    (tmp_path / "trace.csv").write_text("\n".join(["time_s,pressure_pa", *rows]))
    inputs = (f"file: {tmp_path / 'trace.csv'}", "rows: [[0, 0], [2, 0], [3, 15e3], [3.98, 15e3]]")
    many, few = (
        simulate(
            leg(f"input={{kind: table, {own}}}", "run.duration=3.98 s", config="leg_4_air_auto")
        )
        for own in inputs
    )
    assert [v.taken for v in many.effects] == [v.taken for v in few.effects]
    stated = [run.accuracy.estimated_tip_error_m for run in (many, few)]
    assert None not in stated
    apart = np.hypot(*(many.tip[:, :2] - few.tip[:, :2]).T).max()
    assert apart <= sum(own for own in stated if own is not None)


def test_errors_that_hide_each_other_are_stated_by_the_estimates(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What is left out and the coarser mesh may move the tip alike: then they are not far apart."""
    _, selection, _ = judged()
    least_m = selection.stated(JUDGING.stated_per_estimated * selection.estimated_m)
    for share in (0.5, 0.7, 1.0):
        measured_m = share * selection.estimated_m
        monkeypatch.setattr(EffectJudge, "omission", lambda *_, m=measured_m: Omission(m, 0.0))
        stated = simulate(leg(*SHORT)).accuracy.estimated_tip_error_m
        both_m = JUDGING.stated_per_measured * measured_m + selection.estimated_m
        assert stated == max(least_m, both_m)
        assert (stated == least_m) == (share < 0.8)
    assert selection.estimated_m > 0.0


def test_a_distance_far_below_the_estimates_is_judged_by_a_third_solution(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its parts hide each other, or the estimates are far too large."""
    measured = EffectJudge.omission

    def hidden(judge: EffectJudge, run: Run, everything: Run) -> Omission:
        is_alike = run.settings == everything.settings
        return measured(judge, run, everything) if is_alike else Omission(0.0, 0.0)

    monkeypatch.setattr(EffectJudge, "omission", hidden)
    accuracy = simulate(leg(*SHORT, LENIENT)).accuracy
    quantities, selection, run = judged(LENIENT)
    everything = whole(judge_of(quantities, selection), selection, run)
    alike = solve(quantities, selection.effects, everything.settings)
    effects_m = JUDGING.stated_per_told_apart * tip_difference(alike.motion, everything.motion)
    assert accuracy.estimated_tip_error_m is not None
    assert accuracy.estimated_tip_error_m > effects_m > NUMBERS.least_stated * accuracy.requested_m
    assert "between two solutions, with and without" in accuracy.method


SOFT_LEG_IN_WATER: dict[str, Any] = {
    "name": "soft_leg_in_water",
    "actuator": {
        "length": "80 mm",
        "height": "20 mm",
        "width": "15 mm",
        "youngs_modulus": "0.8 MPa",
        "density": "1000 kg/m^3",
        "solid_fraction": 0.6,
        "extension_factor": 0.6,
        "bending_factor": 0.55,
        "damping_time": "2.33 ms",
    },
    "bellows": {
        "count": 8,
        "height": "7 mm",
        "width": "12 mm",
        "length": "12 mm",
        "area_per_pressure": "1.12e-9 m^2/Pa",
        "angle_per_pressure": "4 rad",
        "extension_per_pressure": "5.33 mm",
        "area_per_force": "5e-7 m^2/N",
        "area_per_moment": "3.75e-4 m^2/(N*m)",
    },
    "network": {
        "layout": "straight",
        "tube_radius": "0.8 mm",
        "tube_length": "50 mm",
        "tube_wall": {"youngs_modulus": "2 MPa", "thickness": "0.4 mm"},
    },
    "fluid": "water",
    "input": {"kind": "square", "high": "200 Pa", "low": "0 Pa", "frequency": "4.56 Hz"},
    "loads": {"gravity": "off", "payload": "0 g"},
    "accuracy": "0.01 %",
    "run": {"duration": "0.3 s", "output_interval": "3 ms"},
}
"""The rod presses back on bellows, and damping follows their strain: its mesh is of order one."""


@pytest.mark.parametrize("effects", ["auto", {"others": "on"}], ids=["auto", "all"])
def test_a_mesh_of_order_one_has_no_more_error_than_is_stated(effects: Any) -> None:
    run = simulate(load(SOFT_LEG_IN_WATER | {"effects": effects}))
    quantities = SceneQuantities(load(SOFT_LEG_IN_WATER | {"effects": {"others": "on"}}))
    everything = select_effects(quantities).effects
    fine = replace(settings_of(quantities), edges_per_section=30, tolerance=1e-7)
    reference = solve(quantities, everything, fine).motion
    true_m = np.max(np.hypot(*(run.tip - reference.tip)[:, :2].T))
    assert run.accuracy.estimated_tip_error_m is not None
    assert 0.2 < true_m / run.accuracy.estimated_tip_error_m < 1.0


def test_the_part_of_a_meshs_error_follows_from_both_numbers_of_edges() -> None:
    settings = settings_of(SceneQuantities(leg(*SHORT)))
    meshes = {n: replace(settings, edges_per_section=n) for n in (1, 2, 3, 4, 5)}
    assert mesh_share(meshes[2], meshes[1]) == mesh_share(meshes[4], meshes[2]) == 1.0
    assert mesh_share(meshes[3], meshes[2]) == 2.0
    assert mesh_share(meshes[5], meshes[3]) == 1.5
    assert mesh_share(meshes[4], meshes[4]) == 0.0


def refused_when_grown(quantities: SceneQuantities, active: frozenset[str]) -> None:
    if "feedback" in active:
        raise SpecError.plain("bellows.area_per_moment: negative compliance")


def test_a_scene_that_is_refused_with_everything_is_not_solved_with_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    quantities, selection, run = judged()
    assert "feedback" in selection.everything - selection.active
    monkeypatch.setattr(judged_effects, "refuse_unsolvable", refused_when_grown)
    monkeypatch.setattr(judged_effects, "solve", lambda *_: pytest.fail("was solved"))
    assert judge_of(quantities, selection).everything(selection, run.settings) is None


def test_a_run_that_calls_for_what_is_refused_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its error counts as too large: what it calls for cannot be computed."""

    def calls_for_feedback(_: Any, selection: Selection, run: Run) -> EffectEscalation | None:
        return EffectEscalation.of(selection, ["feedback"], "it matters", 0.5)

    monkeypatch.setattr(simulation_module, "escalation", calls_for_feedback)
    for module in (judged_effects, simulation_module):
        monkeypatch.setattr(module, "refuse_unsolvable", refused_when_grown)
    found = simulate(leg(*SHORT))
    assert found.status == "failed"
    assert "the scene is refused with them: bellows.area_per_moment" in str(found.failure)
    assert not found.ladder[0].solved
    assert found.time[-1] == 2.0
