"""Problems without states: all outputs in one call, and one by one."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import pytest

from tests.scenes import leg, problem_of
from tests.validation.rc_network import columns
from viscodesign.solve.equilibria_in_turn import EquilibriaInTurn
from viscodesign.solve.numerics.newton import NewtonError, newton
from viscodesign.solve.problem import Problem, evaluate, evaluate_along
from viscodesign.solve.solvers import quasi_static
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.solvers.quasi_static import QuasiStatic
from viscodesign.solve.statics import Start, consistent, equilibrium

SHORT = "run={duration: 0.4 s, output_interval: 0.02 s}"
SCENES = {
    "unloaded": ("effects={others: off}",),
    "hanging": ("loads.gravity=on", "effects={gravity: on, others: off}"),
}


def made(*overrides: str) -> tuple[Problem, Start]:
    problem = problem_of(leg(SHORT, *overrides))
    schedule = problem.schedule
    start = equilibrium(problem, 0.0, schedule.initial_piece)
    return problem, consistent(problem, start, 0.0, schedule.pieces[0])


@pytest.mark.parametrize("overrides", SCENES.values(), ids=SCENES)
def test_one_call_and_single_solutions_agree(overrides: tuple[str, ...]) -> None:
    problem, here = made(*overrides)
    assert problem.equations.states.count == 0
    schedule, work = problem.schedule, Work()
    count = len(schedule.edges) - 1
    (_, found, _), failure = QuasiStatic(problem, 1e-6)(here, 0, count, work)
    assert failure is None
    assert work.steps == count
    for k in range(count):
        here = consistent(problem, here, schedule.edges[k + 1], schedule.pieces[k])
        np.testing.assert_allclose(found[:, k], here.algebraics, atol=1e-9)


def test_single_solutions_replace_a_failed_call(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    problem, here = made(*SCENES["unloaded"])
    count = len(problem.schedule.edges) - 1
    (_, at_once, _), _ = QuasiStatic(problem, 1e-6)(here, 0, count, Work())
    monkeypatch.setattr(QuasiStatic, "_at_once", lambda *_: None)
    (_, single, _), failure = QuasiStatic(problem, 1e-6)(here, 0, count, Work())
    assert failure is None
    np.testing.assert_allclose(single, at_once, atol=1e-9)


def snapping(interval: float) -> tuple[str, ...]:
    """A compressed column that its bellows bend to one side, then to the other."""
    tables = [
        f"{{kind: table, rows: [[0 s, {side * 22e3}], [4 s, {-side * 22e3}]]}}" for side in (1, -1)
    ]
    return (
        *columns(16, *tables),
        f"run={{duration: 4 s, output_interval: {interval}}}",
        "loads.tip_force.z=-14 N",
        "effects={gravity: on, others: off}",
    )


def fold_of(interval: float) -> float:
    problem, here = made(*snapping(interval))
    count = len(problem.schedule.edges) - 1
    (_, found, _), failure = QuasiStatic(problem, 1e-6)(here, 0, count, Work())
    assert failure is not None
    assert failure.time_s is not None
    assert failure.quantity == "equilibrium"
    edges = problem.schedule.edges
    assert found.shape[1] == np.searchsorted(edges, failure.time_s, side="right") - 1
    return failure.time_s


def test_no_solution_jumps_across_a_fold() -> None:
    """The fold is found at the same place for any output interval."""
    fine = fold_of(0.03)
    for interval in (0.1, 0.5, 2.0):
        # It is found to a thousandth of the interval.
        assert fold_of(interval) == pytest.approx(fine, abs=1.5e-3 * interval + 1e-5)


def test_mapped_outputs_equal_single_evaluations() -> None:
    problem, here = made(*SCENES["hanging"])
    count = 3
    columns = [np.tile(v[:, None], count) for v in (here.states, here.algebraics)]
    found = evaluate_along(problem, columns[0], columns[1])
    schedule, function = problem.schedule, problem.equations.output_function
    pieces = schedule.pieces[[0, 0, 1]]
    for k in range(count):
        tail = problem.tail(float(schedule.edges[k]), pieces[k])
        single = evaluate(function, here.states, here.algebraics, *tail)
        for name, value in zip(function.name_out(), single, strict=True):
            np.testing.assert_array_equal(found[name][k], np.array(value).ravel(), err_msg=name)


@pytest.mark.parametrize("size", [20, 400])
def test_every_factorisation_refuses_a_singular_system(size: int) -> None:
    diagonal = np.ones(size)
    diagonal[size // 2] = 0.0
    matrix = ca.DM(ca.Sparsity.diag(size), diagonal)
    with pytest.raises(NewtonError):
        newton(lambda y: (diagonal * y - 1.0, matrix), np.zeros(size))


def test_equilibria_follow_each_other_without_single_solutions(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Natively; one by one they take several calls each, and are the same."""
    problem, here = made(*SCENES["hanging"], "run={duration: 2 s, output_interval: 0.02 s}")
    count, calls = len(problem.schedule.edges) - 1, []
    solve = quasi_static.consistent

    def counted(*given: Any) -> Start:
        calls.append(given)
        return solve(*given)

    monkeypatch.setattr(quasi_static, "consistent", counted)
    (_, together, _), failure = QuasiStatic(problem, 1e-6)(here, 0, count, Work())
    assert failure is None
    assert len(calls) <= 2
    monkeypatch.setattr(QuasiStatic, "_in_turn", None)
    (_, single, _), _ = QuasiStatic(problem, 1e-6)(here, 0, count, Work())
    np.testing.assert_allclose(together, single, atol=1e-9)
    assert np.ptp(single) > 0.1


def test_nothing_is_taken_from_another_branch() -> None:
    """What is not near the solution before it is left to a single solution."""
    problem, here = made(*SCENES["hanging"])
    piece, edges = problem.schedule.pieces[0], problem.schedule.edges
    in_turn, times = EquilibriaInTurn(problem), edges[1:8]
    assert len(in_turn.after(here.algebraics, float(edges[0]), None, piece, times)) == len(times)
    away = here.algebraics.copy()
    span = problem.equations.algebraics.branch_span
    assert span is not None
    away[span] += 1.0
    assert len(in_turn.after(away, float(edges[0]), None, piece, times)) == 0
