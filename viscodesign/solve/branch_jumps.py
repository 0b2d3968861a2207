"""Detects where a solver jumps from one equilibrium of a static rod to another, or a branch ends.

The rod's equations are algebraic, those of its fluid are not: to an integrator of both, a
fold only shows as equations that become hard to solve.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulas import Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.branch_following import OperatingPoint, constraints, follow_branch
from viscodesign.solve.numerics.newton import NewtonError, newton
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Pieces, Problem, Schedule, evaluate
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start, consistent

SX = ca.SX


@dataclass(frozen=True)
class JumpCriteria:
    """What counts as a jump."""

    min_move: float = 20.0
    """Move between two outputs, in tolerances of the solver, below which none is looked for."""
    unexplained_rel_tol: float = 0.1
    """Part of a move that its rates at both ends may leave unexplained."""
    distinct_distance: float = 1e-6
    """Distance, in sizes of the unknowns, from which two solutions of the same equations are two
    equilibria."""
    looks_per_range: int = 64
    """Looks at the rod's stability while an unknown changes by as much as in the whole solution:
    where next to nothing changes, the equilibrium stays what it is."""
    least_turn: float = 1e-3
    """Changes before and after a turn, in parts of that, from which it is one."""
    parts_of_failed_interval: int = 64
    """Into which an interval that no solver passes is cut, to find where the branch ends."""


JUMP = JumpCriteria()


class BranchJumpDetector:
    """Checks a solver's solution: is the rod still on its branch?

    Where the solution continues smoothly, its rates at both ends of an interval show that;
    elsewhere the rod's branch is followed from one end to the other.
    """

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.min_move = JUMP.min_move * tolerance
        span, stability = problem.equations.algebraics.branch_span, problem.stability
        assert span is not None, "only a static rod has branches"
        assert stability is not None
        self.span, self.stability = span, stability

    def first_jump(
        self, algebraics: np.ndarray, first: int, states: np.ndarray, found: np.ndarray
    ) -> tuple[int, SolveError | None]:
        """How many of the solved intervals from edge ``first`` are valid, and why no more.

        ``algebraics`` (nz,): before the first; ``states`` (nx, m + 1): before it and after
        each; ``found`` (nz, m).
        """
        every = np.column_stack((algebraics, found))
        moved = np.diff(every[self.span], axis=1)
        is_far = np.max(np.abs(moved), axis=0) > self.min_move
        rates = AlgebraicRates(self.problem, first, states, every)
        is_stable = self._stable_ends(rates, self._looks(states, every, is_far))
        for k in np.flatnonzero(~is_stable[1:] | is_far).tolist():
            if is_stable[k + 1] and self._is_smooth(rates, k, moved[:, k]):
                continue
            points = self._ends(first + k, states[:, k], states[:, k + 1])
            try:
                failure = self._compare_with_branch(every[:, k], every[:, k + 1], *points)
            except SolveError as ended:
                failure = ended
            if failure is not None:
                return k, failure
        return found.shape[1], None

    def _looks(self, states: np.ndarray, every: np.ndarray, is_far: np.ndarray) -> np.ndarray:
        """Ends of intervals (n,) between which little changes: also where a state turns back, as a
        load is largest there, the last one, and those of far moves.
        """
        unknowns = np.concatenate([states, every])
        tolerance = self.min_move / JUMP.min_move
        part = np.maximum(np.ptp(unknowns, axis=1) / JUMP.looks_per_range, tolerance)
        changes = np.diff(unknowns, axis=1) / part[:, None]
        passed = np.floor(np.cumsum(np.max(np.abs(changes), axis=0)))
        own = changes[: len(states)]
        turns = np.any(own[:, :-1] * own[:, 1:] < -(JUMP.least_turn**2), axis=0)
        chosen = np.zeros(every.shape[1], dtype=bool)
        chosen[1:] = np.diff(passed, prepend=0.0) > 0.0
        chosen[1:-1] |= turns
        chosen[1:] |= is_far
        chosen[:-1] |= is_far
        chosen[-1] = True
        return np.flatnonzero(chosen)

    def _stable_ends(self, rates: AlgebraicRates, looks: np.ndarray) -> np.ndarray:
        """Whether the rod is stable at every end (m + 1,).

        Between two looks it is where it is at both; else all ends between them are looked at.
        """
        is_stable = np.ones(rates.count, dtype=bool)
        is_stable[looks] = self.stability.are_stable(rates.jacobians(looks))
        between = np.diff(np.concatenate([[-1], looks]))
        doubtful = np.repeat(~is_stable[looks], between)
        before = np.repeat(np.append(True, is_stable[looks[:-1]]), between)
        more = np.flatnonzero((doubtful | ~before) & ~np.isin(np.arange(rates.count), looks))
        if len(more):
            is_stable[more] = self.stability.are_stable(rates.jacobians(more))
        return is_stable

    def _is_smooth(self, rates: AlgebraicRates, k: int, moved: np.ndarray) -> bool:
        """Whether the rod has moved in an interval as its rates predict."""
        mean = (rates.at(k)[self.span] + rates.at(k + 1)[self.span]) / 2
        unexplained = np.max(np.abs(moved - rates.steps[k] * mean))
        return bool(unexplained <= JUMP.unexplained_rel_tol * np.max(np.abs(moved)))

    def _ends(
        self, edge: int, before: np.ndarray, after: np.ndarray
    ) -> tuple[OperatingPoint, OperatingPoint]:
        """Where an interval begins, with the inputs just before it, and where it ends."""
        edges, pieces = self.problem.schedule.edges, self.problem.schedule.pieces
        return (
            OperatingPoint(before, float(edges[edge]), pieces[max(edge - 1, 0)]),
            OperatingPoint(after, float(edges[edge + 1]), pieces[edge]),
        )

    def _compare_with_branch(
        self, start: np.ndarray, found: np.ndarray, before: OperatingPoint, after: OperatingPoint
    ) -> SolveError | None:
        """The failure of a solution at the end of an interval, if it is not on the branch."""
        geometry = self.problem.step_geometry(self.problem.equations.algebraics)
        along = follow_branch(self.problem, start, before, after)
        try:
            exact = newton(partial(constraints, self.problem, after), found, geometry)
        except NewtonError:
            return branch_jump(self.problem, after.time)
        distance = np.max(np.abs(exact - along)[self.span])
        return branch_jump(self.problem, after.time) if distance > JUMP.distinct_distance else None


class AlgebraicRates:
    """How fast algebraic unknowns change, at the ends of intervals from an edge on.

    Evaluated at the ends that are asked for.
    """

    def __init__(
        self, problem: Problem, first: int, states: np.ndarray, algebraics: np.ndarray
    ) -> None:
        self.count = algebraics.shape[1]
        """Number of ends (m + 1)."""
        edges = problem.schedule.edges[first : first + self.count]
        self.steps = np.diff(edges)
        self._problem, self._first = problem, first
        self._states, self._algebraics, self._times = states, algebraics, edges
        self._function = problem.equations.taped(_following)
        pattern = self._function.sparsities[1]
        rows, starts = (np.array(k, dtype=np.int32) for k in (pattern.row(), pattern.colind()))
        self._pattern = rows, starts
        self._found: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        """Drift and nonzeros of the Jacobian, by end."""
        self._known: dict[int, np.ndarray] = {}

    def jacobians(self, ends: np.ndarray) -> np.ndarray:
        """Nonzeros of the algebraic equations' Jacobian (n, nnz) at ends, column by column."""
        self._evaluate([k for k in ends.tolist() if k not in self._found])
        return np.array([self._found[k][1] for k in ends.tolist()])

    def _evaluate(self, ends: list[int]) -> None:
        if not ends:
            return
        problem, own = self._problem, np.array(ends)
        pieces = problem.schedule.pieces
        piece = pieces[np.minimum(self._first + own, len(pieces) - 1)]
        unknowns = self._states[:, own].T, self._algebraics[:, own].T
        given = [*unknowns, self._times[own, None], piece, problem.numbers()]
        found = self._function.rows(given, len(own))
        self._found.update(zip(ends, zip(*found, strict=True), strict=True))

    def at(self, k: int) -> np.ndarray:
        """Rates (nz,) at the k-th end; infinite where the equations are singular."""
        if k not in self._known:
            from scipy.sparse import csc_matrix
            from scipy.sparse.linalg import splu

            self._evaluate([k] if k not in self._found else [])
            drift, entries = self._found[k]
            size = len(self._algebraics)
            matrix = csc_matrix((entries, *self._pattern), shape=(size, size))
            try:
                self._known[k] = -splu(matrix).solve(drift)
            except RuntimeError:  # raised for a singular matrix
                self._known[k] = np.full(size, np.inf)
        return self._known[k]


def _following(e: Formulas) -> ca.Function:
    """(x, z, t, pieces, parameters) -> drift of the constraints at fixed z, d alg/d z."""
    x, z = e.states.vector, e.algebraics.vector
    drift = ca.jtimes(e.alg, x, e.ode) + ca.jtimes(e.alg, e.time, SX(1))
    slopes = jacobian(e.alg, z)
    given = [x, z, e.time, e.pieces, e.parameters]
    return ca.Function("following", given, [ca.densify(drift), slopes])


def end_of_branch(solver: Solver, here: Start, edge: int, work: Work) -> SolveError | None:
    """Why a solver cannot pass the interval from an edge, if the rod's branch ends in it.

    The interval is solved in small parts as far as possible; from there the fluid is
    extrapolated linearly, and the rod's branch followed with it.
    """
    problem, schedule = solver.problem, solver.problem.schedule
    piece, count = schedule.pieces[edge], JUMP.parts_of_failed_interval
    try:
        here = consistent(problem, here, schedule.edges[edge], piece, solver.before(edge))
        begin, end = schedule.edges[edge], schedule.edges[edge + 1]
        times = np.linspace(begin, end, count + 1)
        same = Pieces(piece[None], np.array([0]), count)
        parts = Schedule(times, same, np.arange(count + 1), piece)
        finer = replace(problem, schedule=parts)
        part_solver = type(solver)(finer, solver.tolerance)
        columns, failure = solve_on_branch(part_solver, here, 0, count, work)
        if failure is None or failure.quantity == "equilibrium":
            return failure
        done = columns[0].shape[1]
        if done:
            here = Start(columns[0][:, -1], columns[1][:, -1])
        _extrapolate_fluid(problem, here, (float(times[done]), float(times[done + 1])), piece)
    except SolveError as error:
        return error if error.quantity == "equilibrium" else None
    return None


def _extrapolate_fluid(
    problem: Problem, here: Start, times: tuple[float, float], piece: np.ndarray
) -> None:
    """Follow the rod while its fluid keeps its rates; raises `SolveError` at the branch's end."""
    before = OperatingPoint(here.states, times[0], piece)
    rates, _ = evaluate(
        problem.equations.function, here.states, here.algebraics, *problem.tail(times[0], piece)
    )
    after = here.states + (times[1] - times[0]) * np.array(rates).ravel()
    follow_branch(problem, here.algebraics, before, OperatingPoint(after, times[1], piece))


def solve_on_branch(
    solver: Solver, here: Start, first: int, stop: int, work: Work
) -> tuple[Columns, SolveError | None]:
    """A solver's solution, as far as a rod without inertia stays on its branch in it."""
    columns, failure = solver(here, first, stop, work)
    if not has_branches(solver.problem):
        return columns, failure
    detector = BranchJumpDetector(solver.problem, solver.tolerance)
    states = np.column_stack((here.states, columns[0]))
    valid, jump = detector.first_jump(here.algebraics, first, states, columns[1])
    if jump is None:
        return columns, failure
    return (columns[0][:, :valid], columns[1][:, :valid], columns[2][:, :valid]), jump


def has_branches(problem: Problem) -> bool:
    """Whether a static rod is solved together with a fluid that is integrated."""
    static = problem.equations.rod_form is RodForm.STATIC
    # A rod that touches something is led along its branch step by step.
    return static and problem.equations.states.count > 0 and not problem.equations.contacts


def branch_jump(problem: Problem, time: float) -> SolveError:
    """The failure of a solver that leaves a branch which continues."""
    return SolveError(
        f"the solution jumped to another equilibrium branch of the rod before t = {time:.6g} s",
        quantity="motion",
        where="rod",
        time_s=float(time),
        remedy=advice(
            problem.remedies,
            Obstacle.LIMIT_POINT,
            "Use a smaller run.output_interval",
            "ask for more accuracy",
        ),
    )
