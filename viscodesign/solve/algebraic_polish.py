"""Algebraic unknowns brought to round-off where an integrator holds to its tolerance only."""

from __future__ import annotations

from contextlib import suppress
from functools import partial

import numpy as np

from viscodesign.solve.branch_following import Moment, constraints
from viscodesign.solve.numerics.newton import CONVERGED, ROUND_OFF, NewtonError, newton
from viscodesign.solve.numerics.step_geometry import way_of
from viscodesign.solve.problem import Problem, mapped, rows_along

MOST_DENSE = 80
"""Algebraic unknowns up to which many edges are solved at once, without regard to zeros: larger
matrices wake threads that cost more than they bring."""
AT_ONCE = 4_000_000
"""Entries of all their matrices together."""
MOST_ROUNDS = 6


def refined(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int = 0
) -> np.ndarray:
    """Algebraic unknowns (nz, m) at m edges from ``first`` on, to round-off where that can be."""
    schedule, found = problem.schedule, algebraics.copy()
    way = way_of(problem.equations.algebraics)
    for k in np.flatnonzero(~_together(problem, states, found, first)).tolist():
        edge = first + k
        # A state just before a corner belongs to the interval that ends there.
        time, piece = float(schedule.edges[edge]), schedule.pieces[max(edge - 1, 0)]
        defects = partial(constraints, problem, Moment(states[:, k], time, piece))
        with suppress(NewtonError):
            found[:, k] = newton(defects, algebraics[:, k], way)
    return found


def _together(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int
) -> np.ndarray:
    """Refine in place what whole steps of Newton's iteration bring there; which these are (m,)."""
    unknowns, count = algebraics.shape
    done = np.zeros(count, dtype=bool)
    if unknowns > MOST_DENSE:
        return done
    block = max(AT_ONCE // unknowns**2, 1)
    for begin in range(0, count, block):
        some = slice(begin, begin + block)
        done[some] = _block(problem, states[:, some], algebraics[:, some], first + begin)
    return done


def _block(problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int) -> np.ndarray:
    """The same of a block."""
    function = problem.equations.algebraic_function
    told = function.sparsity_out(0).row()
    rows, columns = function.sparsity_out(1).get_triplet()
    unknowns, count = algebraics.shape
    trial = algebraics.copy()
    matrix, right = np.zeros((count, unknowns, unknowns)), np.zeros((count, unknowns, 1))
    size = np.full(count, np.inf)
    done, lost = np.zeros((2, count), dtype=bool)
    for _ in range(MOST_ROUNDS):
        defect, slopes = mapped(problem, function, rows_along(problem, states, trial, first))
        matrix[:, rows, columns], right[:, told, 0] = slopes, defect
        try:
            step = np.linalg.solve(matrix, right)[:, :, 0].T
        except np.linalg.LinAlgError:  # one that is singular spoils all
            return np.zeros(count, dtype=bool)
        before, size = size, np.max(np.abs(step), axis=0, initial=0.0)
        # A standstill at round-off is as far as a stiff problem goes.
        still = (size <= ROUND_OFF) & (size > before / 2)
        lost |= ~(size < before) & ~still
        arrived = ~done & ~lost
        trial[:, arrived & ~still] -= step[:, arrived & ~still]
        done |= arrived & (still | (size <= CONVERGED))
        if np.all(done | lost):
            break
    algebraics[:, done] = trial[:, done]
    return done
