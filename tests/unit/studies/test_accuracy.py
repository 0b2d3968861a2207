"""Measured studies of small scenes: errors are true, forms are those allowed, time is kept."""

from __future__ import annotations

import os
import signal
import warnings
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import AccuracyInterruptedError, AccuracyStudy, accuracy
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, solve, tip_difference
from viscodesign.solve.transient import solver_catalogue
from viscodesign.studies import grid as grid_module
from viscodesign.studies import timed_runs as timed_runs_module
from viscodesign.studies.models import allowed_models

SMALL = ("bellows.count=4", "run={duration: 0.5 s, output_interval: 20 ms}",
         "input={kind: table, rows: [[0, 0], [0.1, 4 kPa], [0.2, 4 kPa], [0.3, -2 kPa]]}")  # fmt: skip
PINNED = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
FLOW = "effects={pressure_distribution: on, others: off}"
UNIFORM = "effects={others: off}"
FREE = (
    "effects={pressure_distribution: on, feedback: on, inertia: auto, damping: auto, others: off}"
)


@pytest.fixture(autouse=True)
def _quick_solvers_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """A solver in Python would take most of the time of these tests."""
    kinds = {name: kind for name, kind in solver_catalogue().items() if name != "radau"}
    monkeypatch.setattr(grid_module, "solver_catalogue", lambda: kinds)


@cache
def studied(*overrides: str) -> AccuracyStudy:
    return accuracy(leg(*SMALL, *overrides), limit=60.0)


def selected(*overrides: str) -> tuple[SceneQuantities, Selection]:
    quantities = SceneQuantities(leg(*SMALL, *overrides))
    return quantities, select_effects(quantities)


def test_errors_match_an_independent_solution() -> None:
    study = studied(PINNED)
    assert study.reference is not None
    quantities, selection = selected(PINNED)
    names = selection.everything
    # By another solver than the reference's, and finer than most points.
    fine = solve(quantities, selection.members(names), Settings(16, 1e-8, "idas"))
    for point in study.points[:6]:
        settings = Settings(point.edges, point.tolerance, point.solver)
        run = solve(quantities, selection.members(names), settings)
        assert tip_difference(run.motion, fine.motion) == pytest.approx(
            point.tip_error_m, rel=0.05, abs=3 * study.reference.convergence_m
        )


def test_the_stated_convergence_of_the_reference_holds() -> None:
    study = studied(PINNED)
    found = study.reference
    assert found is not None
    quantities, selection = selected(PINNED)
    effects = selection.members(selection.everything)
    same, finer = (
        solve(quantities, effects, Settings(found.edges * n, found.tolerance / k, found.solver))
        for n, k in ((1, 1), (2, 10))
    )
    assert tip_difference(same.motion, finer.motion) <= found.convergence_m
    assert found.is_converged
    assert found.convergence_rel <= 0.1 * min(study.errors)
    assert found.smallest_error_m == pytest.approx(3 * found.convergence_m)


def test_errors_decrease_with_the_tolerance() -> None:
    study = studied(PINNED)
    assert study.status == "complete"
    for solver in {point.solver for point in study.points}:
        branch = [p for p in study.points if p.solver == solver and p.edges == 2]
        branch.sort(key=lambda point: -point.tolerance)
        assert branch[-1].tip_error_m < 0.2 * branch[0].tip_error_m
        assert branch[-1].steps > branch[0].steps
    assert all(study.cheapest(error) is not None for error in study.errors)


def test_every_quick_solver_is_tried() -> None:
    solvers = {point.solver for point in studied(PINNED).points}
    assert solvers == set(solver_catalogue()) - {"radau", "modes"}
    assert "modes" in {point.solver for point in studied(FLOW).points}


def test_the_first_setting_of_simulate_is_a_point() -> None:
    study = studied(PINNED)
    assert study.start in study.points
    assert study.start is not None
    assert study.start.model == "auto"


def test_arcs_have_one_mesh() -> None:
    study = studied(FLOW)
    assert len({point.edges for point in study.points}) == 1
    assert all(point.is_exact_in_space for point in study.points)
    assert all("arcs" in point.setting for point in study.points)


def test_a_model_without_time_steps_has_one_exact_point() -> None:
    (point,) = studied(UNIFORM).points
    assert point.is_stepless
    assert point.is_bound
    assert point.tip_error_rel < 1e-8
    assert not point.dominated


def test_models_are_those_that_the_spec_allows() -> None:
    pinned, notes = allowed_models(selected(PINNED)[1])
    assert [(model.name, model.also) for model in pinned] == [("auto", ("everything", "II"))]
    assert "IV (uniform, quasi-static)" in notes[0]
    _, selection = selected(FREE)
    free = {
        name: model for model in allowed_models(selection)[0] for name in (model.name, *model.also)
    }
    assert set(free) == {"auto", "everything", "II", "III"}
    assert free["III"].effects == ("pressure_distribution", "feedback")  # and no damping alone
    assert "inertia" in free["II"].effects
    every = {frozenset(model.effects) for model in free.values()}
    assert len(every) == len(allowed_models(selection)[0])


def test_required_effects_stay_in_every_model() -> None:
    _, selection = selected("effects=auto", "run.start=rest", "loads.tip_force.x=0.1 N")
    names = {name for m in allowed_models(selection)[0] for name in (m.name, *m.also)}
    assert "III" not in names
    assert "IV" not in names


def test_quick_settings_are_measured_repeatedly(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    calls: list[Settings] = []

    def counted(*given: object) -> Run:
        calls.append(given[2])  # type: ignore[arg-type]
        return solve(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(timed_runs_module, "solve", counted)
    study = accuracy(leg(*SMALL, FLOW), limit=60.0)
    for point in study.points:
        # A free choice is noted under the solver that took it.
        asked = [
            s
            for s in calls
            if s.tolerance == point.tolerance and (s.is_free or s.solver == point.solver)
        ]
        assert 1 <= len(asked) <= 2 * timed_runs_module.MAX_REPEATS
    assert len(calls) < 12 * len(study.points)


def test_an_interrupt_keeps_the_points(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[Run] = []

    def interrupted(*given: object) -> Run:
        run = solve(*given)  # type: ignore[arg-type]
        calls.append(run)
        return replace(run, solution=replace(run.solution, interrupted=len(calls) == 20))

    monkeypatch.setattr(timed_runs_module, "solve", interrupted)
    with pytest.raises(AccuracyInterruptedError) as caught:
        accuracy(leg(*SMALL, FLOW), limit=60.0)
    study = caught.value.study
    assert study.status == "interrupted"
    assert study.reference is not None
    assert 0 < len(study.points) < len(studied(FLOW).points)
    assert len(calls) == 20


@pytest.mark.skipif(os.name != "posix", reason="POSIX signals")
def test_an_interrupt_during_a_short_solve_ends_the_study(monkeypatch: pytest.MonkeyPatch) -> None:
    """The solve is done before it could obey, but the study is not."""
    calls: list[int] = []
    sent: list[int] = []

    def disturbed(*given: object) -> Run:
        calls.append(0)
        *rest, watch, workspace = given

        def interrupting(fraction: float) -> None:
            if len(calls) == 3 and not sent:
                sent.append(signal.SIGINT)
                os.kill(os.getpid(), signal.SIGINT)
            watch(fraction)  # type: ignore[operator]

        return solve(*rest, interrupting, workspace)  # type: ignore[arg-type]

    monkeypatch.setattr(timed_runs_module, "solve", disturbed)
    before = signal.getsignal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt) as caught:
        accuracy(leg(*SMALL, FLOW), limit=60.0)
    assert isinstance(caught.value, AccuracyInterruptedError)
    study = caught.value.study
    assert study.status == "interrupted"
    assert study.reference is None
    assert study.points == ()
    assert len(calls) == 3
    assert signal.getsignal(signal.SIGINT) is before


def test_skipped_settings_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once no trial may take any of the time left, what was not measured is said."""
    full = studied(PINNED)
    monkeypatch.setattr(grid_module, "RULES", replace(grid_module.RULES, share_of_rest=0.0))
    study = accuracy(leg(*SMALL, PINNED))
    assert len(study.points) < len(full.points)
    assert any("skipped: time limit" in note or "given up" in note for note in study.notes)


def test_a_limit_that_is_too_short_suggests_a_longer_one() -> None:
    with pytest.raises(SolveError, match=r"does not fit into the time limit of 0\.01 s.*--limit"):
        accuracy(leg(*SMALL, PINNED), limit=0.01)


def test_a_scene_that_cannot_be_solved_is_reported() -> None:
    deep = ("bellows.extension_per_pressure=600 mm", "effects={others: off}",
            "input={kind: constant, value: -100 kPa}")  # fmt: skip
    with warnings.catch_warnings(), pytest.raises(SolveError, match="no reference solution"):
        accuracy(leg("bellows.count=4", "run.duration=0.1 s", *deep))


def test_progress_rises_to_its_end() -> None:
    told: list[float] = []
    accuracy(leg(*SMALL, UNIFORM), limit=5.0, progress=told.append)
    assert told == sorted(told)
    assert told[0] >= 0.0
    assert told[-1] <= 1.0


def test_points_have_what_the_table_needs() -> None:
    frame = studied(FLOW).frame()
    assert np.all(frame["solve_s"] > 0)
    assert np.all(frame["build_s"] > 0)
    assert np.allclose(frame["tip_error_m"] / studied(FLOW).length, frame["tip_error_rel"])


def test_no_alarm_interrupts_a_solve(monkeypatch: pytest.MonkeyPatch) -> None:
    """A time limit ends a solve in its progress callback, in any thread and on any system."""
    monkeypatch.setattr(signal, "setitimer", None)
    with pytest.raises(SolveError, match="does not fit into the time limit"):
        accuracy(leg(*SMALL, PINNED, "run.duration=50 s"), limit=0.3)
