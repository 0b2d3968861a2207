"""Polish algebraic unknowns to round-off where an integrator only meets its tolerance."""

from __future__ import annotations

from contextlib import suppress
from functools import partial

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.branch_following import OperatingPoint, constraints
from viscodesign.solve.numerics.newton import CONTROL, NewtonError, newton
from viscodesign.solve.problem import Problem, rows_along


@dataclass(frozen=True)
class PolishLimits:
    """How many edges are polished at once."""

    max_dense_unknowns: int = 300
    """Algebraic unknowns up to which many edges are solved at once, with full matrices: one by one
    in Python costs three times as much at 150."""
    max_entries: int = 4_000_000
    """Entries of all these matrices together."""
    max_iterations: int = 6


LIMITS = PolishLimits()


def polish(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int = 0
) -> np.ndarray:
    """Algebraic unknowns (nz, m) at m edges from ``first`` on, to round-off where possible."""
    schedule, found = problem.schedule, algebraics.copy()
    geometry = problem.step_geometry(problem.equations.algebraics)
    for k in np.flatnonzero(~_polish_all(problem, states, found, first)).tolist():
        edge = first + k
        # A state just before a corner belongs to the interval that ends there.
        time, piece = float(schedule.edges[edge]), schedule.pieces[max(edge - 1, 0)]
        residual = partial(constraints, problem, OperatingPoint(states[:, k], time, piece))
        with suppress(NewtonError):
            found[:, k] = newton(residual, algebraics[:, k], geometry)
    return found


def _polish_all(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int
) -> np.ndarray:
    """Polish in place those that undamped Newton steps bring to round-off; which these are (m,)."""
    unknowns, count = int(np.count_nonzero(_is_coupled(problem))), algebraics.shape[1]
    done = np.zeros(count, dtype=bool)
    if unknowns > LIMITS.max_dense_unknowns:
        return done
    size = max(LIMITS.max_entries // max(unknowns, 1) ** 2, 1)
    for begin in range(0, count, size):
        some = slice(begin, begin + size)
        done[some] = _polish_some(problem, states[:, some], algebraics[:, some], first + begin)
    return done


def _is_coupled(problem: Problem) -> np.ndarray:
    """Which algebraic unknowns have equations together (nz,); the others follow from states."""
    group = problem.equations.algebraics
    found = np.ones(group.count, dtype=bool)
    for block in group.blocks.values():
        found[block.span] = not block.traits.follows_from_states
    return found


def _polish_some(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int
) -> np.ndarray:
    """The same for as many edges as are solved at once."""
    function = problem.equations.constraints_by_tape
    known = np.array(function.sparsities[0].row())
    rows, columns = map(np.array, function.sparsities[1].get_triplet())
    # The equations of a block stand in its place.
    coupled = _is_coupled(problem)
    place, own, other = np.cumsum(coupled) - 1, np.flatnonzero(coupled), np.flatnonzero(~coupled)
    entries, alone = coupled[rows] & coupled[columns], ~coupled[rows] & (rows == columns)
    rows, columns = place[rows[entries]], place[columns[entries]]
    unknowns, count = len(own), algebraics.shape[1]
    trial, step = algebraics.copy(), np.zeros_like(algebraics)
    defects = np.zeros_like(algebraics)
    matrix = np.zeros((count, unknowns, unknowns))
    size = np.full(count, np.inf)
    done, lost = np.zeros((2, count), dtype=bool)
    for _ in range(LIMITS.max_iterations):
        residual, slopes = function.rows(rows_along(problem, states, trial, first), count)
        matrix[:, rows, columns], defects[known] = slopes[:, entries], residual.T
        step[other] = defects[other] / slopes[:, alone].T
        try:
            step[own] = np.linalg.solve(matrix, defects[own].T[:, :, None])[:, :, 0].T
        except np.linalg.LinAlgError:  # a single singular matrix fails them all
            return np.zeros(count, dtype=bool)
        before, size = size, np.max(np.abs(step), axis=0, initial=0.0)
        # Stagnation at round-off is as far as a stiff problem goes.
        stagnant = (size <= CONTROL.round_off_tol) & (size > before / 2)
        lost |= ~(size < before) & ~stagnant
        arrived = ~done & ~lost
        trial[:, arrived & ~stagnant] -= step[:, arrived & ~stagnant]
        done |= arrived & (stagnant | (size <= CONTROL.correction_tol))
        if np.all(done | lost):
            break
    algebraics[:, done] = trial[:, done]
    return done
