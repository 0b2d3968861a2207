"""Polishing algebraic unknowns to round-off, in batches and one by one."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign.solve import algebraic_polish
from viscodesign.solve.algebraic_polish import PolishLimits
from viscodesign.solve.branch_following import OperatingPoint, constraints
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import equilibrium
from viscodesign.solve.transient import integrate

TOLERANCE = 1e-5


@pytest.fixture(scope="module")
def solved() -> tuple[Problem, np.ndarray, np.ndarray]:
    scene = leg(config="branched_tree")
    problem = problem_of(scene)
    assert "junction_pressure" in problem.equations.algebraics.blocks
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    found = integrate(problem, start, TOLERANCE)
    return problem, found.states, found.algebraics


def defects(problem: Problem, states: np.ndarray, algebraics: np.ndarray) -> np.ndarray:
    """Largest residual at each edge (m,)."""
    schedule = problem.schedule
    told = []
    for k in range(states.shape[1]):
        point = OperatingPoint(states[:, k], schedule.edges[k], schedule.pieces[max(k - 1, 0)])
        told.append(np.max(np.abs(constraints(problem, point, algebraics[:, k])[0])))
    return np.array(told)


def test_residuals_are_polished_to_round_off(
    solved: tuple[Problem, np.ndarray, np.ndarray],
) -> None:
    problem, states, algebraics = solved
    given = algebraics + 1e-4 * np.sin(np.arange(algebraics.size)).reshape(algebraics.shape)
    assert np.min(defects(problem, states, given)) > 1e-8
    found = algebraic_polish.polish(problem, states, given)
    assert np.max(defects(problem, states, found)) < 1e-11
    assert np.max(np.abs(found - algebraics)) < 1e-3


def test_single_edges_and_batches_agree(
    solved: tuple[Problem, np.ndarray, np.ndarray], monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, states, algebraics = solved
    together = algebraic_polish.polish(problem, states, algebraics)
    monkeypatch.setattr(
        algebraic_polish, "LIMITS", PolishLimits(max_entries=3 * len(algebraics) ** 2)
    )
    in_blocks = algebraic_polish.polish(problem, states, algebraics)
    monkeypatch.setattr(algebraic_polish, "LIMITS", PolishLimits(max_dense_unknowns=0))
    alone = algebraic_polish.polish(problem, states, algebraics)
    assert together == pytest.approx(alone, abs=1e-10)
    assert in_blocks == pytest.approx(alone, abs=1e-10)


def test_an_edge_that_fails_affects_no_other(
    solved: tuple[Problem, np.ndarray, np.ndarray],
) -> None:
    problem, states, algebraics = solved
    given = algebraics.copy()
    given[:, 2] = np.nan
    found = algebraic_polish.polish(problem, states, given)
    assert np.isnan(found[:, 2]).all()
    others = np.arange(states.shape[1]) != 2
    want = algebraic_polish.polish(problem, states, algebraics)
    assert found[:, others] == pytest.approx(want[:, others], abs=1e-10)
