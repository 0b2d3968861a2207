"""Every effect switched and solved again: what an estimate is worth."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation import measured_effects
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, Workspace
from viscodesign.simulation.solve_once import solve as really_solve

SMALL = ("bellows.count=4", "run={duration: 0.5 s, output_interval: 20 ms}",
         "input={kind: table, rows: [[0, 0], [0.1, 4 kPa], [0.2, 4 kPa], [0.3, -2 kPa]]}")  # fmt: skip
SCENES = {
    "as it calls for": ("effects=auto", "loads.gravity.tilt=60 deg"),
    "flow alone": ("effects={pressure_distribution: on, others: off}",),
}
# Walls that meet keep the leg from being pressed to nothing.
DEEP = ("bellows.count=4", "bellows.extension_per_pressure=600 mm",
        "effects={collapse: on, others: off}")  # fmt: skip
FACTOR = 3.0


@cache
def ablated(scene: str) -> Trajectory:
    return simulate(leg(*SMALL, *SCENES[scene]), verify=False, prove=True)


@pytest.mark.parametrize("scene", SCENES)
def test_estimates_are_near_measurements_where_they_count(scene: str) -> None:
    found = ablated(scene)
    floor = 0.1 * found.accuracy.requested_m
    large = 0
    for ablation in found.proof:
        assert ablation.measured_m is not None
        if max(ablation.measured_m, ablation.estimated_m) > floor:
            large += 1
            assert (
                ablation.measured_m / FACTOR <= ablation.estimated_m <= ablation.measured_m * FACTOR
            )
    assert large >= 3


@pytest.mark.parametrize("scene", SCENES)
def test_everything_that_the_scene_has_is_switched_once(scene: str) -> None:
    found = ablated(scene)
    overrides = (*SMALL, *SCENES[scene])
    selection = select_effects(SceneQuantities(leg(*overrides)))
    switchable = selection.measurable
    told = {v.name: v for v in found.effects}
    assert [p.name for p in found.proof] == switchable
    for ablation in found.proof:
        assert ablation.taken == told[ablation.name].taken
        assert ablation.estimated_m == selection.switched_m(ablation.name) >= 0.0
        assert ablation.solve_s > 0.0
        assert ablation.note == ""


def test_neglected_effects_move_the_tip_by_less_than_the_accuracy() -> None:
    found = ablated("as it calls for")
    left = [p.measured_m for p in found.proof if not p.taken]
    assert left
    assert all(m is not None and m < found.accuracy.requested_m for m in left)


def test_nothing_else_of_the_trajectory_changes() -> None:
    with_ablations = ablated("flow alone")
    without = simulate(leg(*SMALL, *SCENES["flow alone"]), verify=False)
    assert without.proof == ()
    for name in ("time", "tip", "pressure", "volume", "flow", "arc", "shape"):
        assert np.array_equal(getattr(without, name), getattr(with_ablations, name)), name
    for name in (
        "status",
        "effects",
        "warnings",
        "invariants",
        "accuracy",
        "settings",
        "spec_text",
    ):
        assert getattr(without, name) == getattr(with_ablations, name), name
    assert without.cost.steps == with_ablations.cost.steps


def test_a_switch_that_cannot_be_solved_says_so() -> None:
    deep = ("input={kind: constant, value: -100 kPa}", "run={duration: 0.1 s}")
    found = simulate(leg(*DEEP, *deep), verify=False, prove=True)
    assert found.status == "complete"
    ablations = {p.name: p for p in found.proof}
    collapse = ablations.pop("collapse")
    assert collapse.taken
    assert collapse.measured_m is None
    assert collapse.solve_s == 0.0
    assert "section" in collapse.note
    assert "\n" not in collapse.note
    assert all(p.measured_m is not None and not p.note for p in ablations.values())


def test_a_switched_run_that_ends_early_is_compared_up_to_its_end() -> None:
    ramp = ("input={kind: table, rows: [[0, 0], [1, -100 kPa]]}",
            "run={duration: 1 s, output_interval: 0.125 s}")  # fmt: skip
    quantities = SceneQuantities(leg(*DEEP, *ramp))
    found = select_effects(quantities)
    verdict = next(v for v in found.verdicts if v.name == "collapse")
    settings = Settings(2, 1e-4)
    base = really_solve(quantities, found.effects, settings)
    ablation, run = measured_effects._switched(
        quantities, found, settings, base, verdict, Workspace()
    )
    assert run is not None
    assert not run.is_complete
    assert ablation.note == f"compared up to t = {run.motion.time[-1]:.4g} s, where that run ended"
    both = len(run.motion.tip)
    assert 1 < both < len(base.motion.tip)
    apart = base.motion.tip[:both, :2] - run.motion.tip[:, :2]
    assert ablation.measured_m == pytest.approx(np.max(np.hypot(*apart.T)))


def test_an_interrupt_ends_the_list(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[Run] = []

    def interrupted(*given: object, **more: object) -> Run:
        run = really_solve(*given, **more)  # type: ignore[arg-type]
        calls.append(run)
        stopped = replace(run.solution, interrupted=len(calls) == 4)
        return replace(run, solution=stopped)

    monkeypatch.setattr(measured_effects, "solve", interrupted)
    told: list[float] = []
    found = simulate(
        leg(*SMALL, *SCENES["flow alone"]), verify=False, prove=True, progress=told.append
    )
    assert found.status == "complete"
    assert len(calls) == 4  # the scene, and three switches, the last of which does not count
    assert len(found.proof) == 2
    assert told[-2:] == [pytest.approx(1 / 9), pytest.approx(2 / 9)]


@pytest.mark.parametrize(("call", "measured"), [(1, 0), (4, 2)])
def test_an_interrupt_before_a_first_step_ends_the_list(
    call: int, measured: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[Run] = []

    def interrupted(*given: object, **more: object) -> Run:
        if len(calls) + 1 == call:
            raise KeyboardInterrupt
        calls.append(really_solve(*given, **more))  # type: ignore[arg-type]
        return calls[-1]

    monkeypatch.setattr(measured_effects, "solve", interrupted)
    found = simulate(leg(*SMALL, *SCENES["flow alone"]), verify=False, prove=True)
    assert len(found.proof) == measured
    assert len(found.time) > 1


@pytest.mark.parametrize(("call", "measured"), [(1, 0), (4, 3)])
def test_a_wish_to_stop_after_a_last_step_ends_the_list(
    call: int, measured: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[Run] = []

    def interrupted(*given: object, **more: object) -> Run:
        calls.append(really_solve(*given, **more))  # type: ignore[arg-type]
        calls[-1].solution.asked_to_stop = len(calls) == call
        return calls[-1]

    monkeypatch.setattr(measured_effects, "solve", interrupted)
    found = simulate(leg(*SMALL, *SCENES["flow alone"]), verify=False, prove=True)
    assert len(calls) == call
    assert len(found.proof) == measured


def test_a_failed_run_is_not_switched(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*given: object) -> Run:
        raise AssertionError("a run that failed was switched")

    monkeypatch.setattr(measured_effects, "solve", never)
    found = simulate(
        leg(
            "bellows.count=4",
            "bellows.extension_per_pressure=600 mm",
            "effects={others: off}",
            "input={kind: table, rows: [[0, 0], [1, -100 kPa]]}",
            "run={duration: 1 s, output_interval: 0.1 s}",
        ),
        verify=False,
        prove=True,
    )
    assert found.status == "failed"
    assert found.proof == ()


def test_small_changes_stand_out_from_the_steps_noise(monkeypatch: pytest.MonkeyPatch) -> None:
    """The scene itself is solved again, finer; its first solution is what is handed out."""
    settings: list[Settings] = []

    def noted(
        quantities: SceneQuantities, effects: object, chosen: Settings, workspace: Workspace
    ) -> Run:
        settings.append(chosen)
        return really_solve(quantities, [], chosen)

    monkeypatch.setattr(measured_effects, "solve", noted)
    found = simulate(leg(*SMALL, "effects=off"), verify=False, prove=True)
    tolerance = found.settings["tolerance"] / measured_effects.TOLERANCE_REDUCTION
    assert [s.tolerance for s in settings] == pytest.approx([tolerance] * len(settings))
    assert {s.edges_per_section for s in settings} == {found.settings["edges_per_section"]}
    assert len(settings) == len(found.proof) + 1
    assert measured_effects.TOLERANCE_REDUCTION >= 10
