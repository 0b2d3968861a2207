"""Equilibria between two that are known, all of them at once."""

from __future__ import annotations

import numpy as np

from viscodesign.solve.branch_following import SAME_BRANCH_DISTANCE, OperatingPoint
from viscodesign.solve.numerics.newton import CONTROL
from viscodesign.solve.problem import Problem

MAX_UNKNOWNS = 150
"""Unknowns up to which many full matrices are solved faster than single sparse ones."""
MAX_ITERATIONS = 6
"""Iterations from an interpolated guess after which the equilibria are sought one by one."""


def equilibria_between(
    problem: Problem,
    ends: tuple[np.ndarray, np.ndarray],
    before: OperatingPoint,
    after: OperatingPoint,
    times: np.ndarray,
) -> np.ndarray | None:
    """Algebraic unknowns (m, nz) at ``times`` (m,) on the branch that joins two equilibria.

    ``ends``: unknowns (nz,) at both operating points, on one smooth piece of the inputs. Plain
    Newton from what lies between them along the rod's own steps. None where that fails anywhere,
    or finds what is not near its guess or not stable: the branch may end in between.
    """
    unknowns = problem.equations.algebraics
    if not len(times) or unknowns.count > MAX_UNKNOWNS:
        return None
    shares = (times - before.time) / (after.time - before.time)
    geometry = problem.step_geometry(unknowns)
    guess = np.array([geometry.extrapolate(*ends, share - 1) for share in shares])
    with np.errstate(over="ignore", invalid="ignore"):
        found = _solved(problem, guess, after, times)
    if found is None or not _is_on_branch(problem, guess, *found):
        return None
    return found[0]


def _solved(
    problem: Problem, guess: np.ndarray, point: OperatingPoint, times: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """Unknowns (m, nz), and the nonzeros of their Jacobians (m, nnz)."""
    function, y = problem.equations.constraints_by_tape, guess
    rows, columns = (np.array(k, dtype=int) for k in function.sparsities[1].get_triplet())
    _, *rest = problem.tail(0.0, point.piece)
    shared = [np.atleast_1d(np.asarray(values, dtype=float)) for values in rest]
    matrix = np.zeros((*y.shape, y.shape[1]))
    for _ in range(MAX_ITERATIONS):
        given = [point.states, y, times[:, None], *shared]
        residual, entries = function.rows(given, len(times))
        if not (np.isfinite(residual).all() and np.isfinite(entries).all()):
            return None
        matrix[:, rows, columns] = entries
        try:
            step = np.linalg.solve(matrix, residual[..., None])[..., 0]
        except np.linalg.LinAlgError:  # raised for all of them if one is singular
            return None
        y = y - step
        if np.max(np.abs(step), initial=0.0) <= CONTROL.correction_tol:
            return y, entries
    return None


def _is_on_branch(
    problem: Problem, guess: np.ndarray, found: np.ndarray, entries: np.ndarray
) -> bool:
    span, stability = problem.equations.algebraics.branch_span, problem.stability
    if span is None or stability is None:
        return True
    size = np.maximum(1.0, np.max(np.abs(found[:, span]), axis=1))
    apart = np.max(np.abs(found[:, span] - guess[:, span]), axis=1)
    if np.any(apart > SAME_BRANCH_DISTANCE * size):
        return False
    return bool(np.all(stability.are_stable(entries)))
