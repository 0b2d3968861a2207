"""Whether a solver leaps from one equilibrium of a static rod to another, and where a branch ends.

The rod's equations are algebraic, those of its fluid are not: what integrates both sees a
fold only as equations that become hard to solve.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import casadi as ca
import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from viscodesign.errors import SolveError
from viscodesign.model.formulation import Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.branch_following import Moment, constraints, followed
from viscodesign.solve.numerics.newton import NewtonError, newton
from viscodesign.solve.numerics.step_geometry import way_of
from viscodesign.solve.problem import Pieces, Problem, Schedule, evaluate, mapped
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start, consistent

SX = ca.SX

STILL = 20.0
"""Move between two outputs, in tolerances of the solver, below which no leap is looked for."""
SMOOTH = 0.1
"""Part of a move that its rates at both ends may leave unexplained."""
APART = 1e-6
"""Distance of two solutions of the same equations, in lengths, from which they are two."""
PARTS = 64
"""Parts of an interval that no solver can pass, to find where the branch ends in it."""


class LeapWatch:
    """Looks over a solver's shoulder at every output: is the rod still on its branch?

    Where it goes on smoothly that is seen from its rates at both ends of an interval; where
    that does not tell, the rod is followed from one end to the other.
    """

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.slight = STILL * tolerance
        self.place = problem.equations.algebraics.blocks["position"].span

    def first_leap(
        self, algebraics: np.ndarray, first: int, states: np.ndarray, found: np.ndarray
    ) -> tuple[int, SolveError | None]:
        """How many of the solved intervals from edge ``first`` are to be kept, and why no more.

        ``algebraics`` (nz,): before the first; ``states`` (nx, m + 1): before it and after
        each; ``found`` (nz, m).
        """
        every = np.column_stack((algebraics, found))
        rates = Rates(self.problem, first, states, every)
        for k in range(found.shape[1]):
            if self._goes_on(rates, k):
                continue
            moments = self._ends(first + k, states[:, k], states[:, k + 1])
            try:
                failure = self._judge(every[:, k], every[:, k + 1], *moments)
            except SolveError as ended:
                failure = ended
            if failure is not None:
                return k, failure
        return found.shape[1], None

    def _goes_on(self, rates: Rates, k: int) -> bool:
        """Whether the rod is stable after an interval, and has moved as its rates say."""
        stiffness = self.problem.stiffness
        if stiffness is None or not stiffness.is_stable(rates.jacobians[k + 1]):
            return False
        moved = rates.algebraics[self.place, k + 1] - rates.algebraics[self.place, k]
        far = np.max(np.abs(moved))
        if far <= self.slight:
            return True
        mean = (rates.at(k)[self.place] + rates.at(k + 1)[self.place]) / 2
        return bool(np.max(np.abs(moved - rates.steps[k] * mean)) <= SMOOTH * far)

    def _ends(self, edge: int, before: np.ndarray, after: np.ndarray) -> tuple[Moment, Moment]:
        """Where an interval begins, by what held just before, and where it ends."""
        edges, pieces = self.problem.schedule.edges, self.problem.schedule.pieces
        return (
            Moment(before, float(edges[edge]), pieces[max(edge - 1, 0)]),
            Moment(after, float(edges[edge + 1]), pieces[edge]),
        )

    def _judge(
        self, start: np.ndarray, found: np.ndarray, before: Moment, after: Moment
    ) -> SolveError | None:
        """What is wrong with a solution at the end of an interval that began at another."""
        way = way_of(self.problem.equations.algebraics)
        along = followed(self.problem, start, before, after)
        try:
            exact = newton(partial(constraints, self.problem, after), found, way)
        except NewtonError:
            return leap(after.time)
        apart = np.max(np.abs(exact - along)[self.place])
        return leap(after.time) if apart > APART else None


class Rates:
    """How fast algebraic unknowns follow, at the ends of intervals from an edge on."""

    def __init__(
        self, problem: Problem, first: int, states: np.ndarray, algebraics: np.ndarray
    ) -> None:
        schedule, count = problem.schedule, algebraics.shape[1]
        times = schedule.edges[first : first + count]
        pieces = schedule.pieces[np.minimum(first + np.arange(count), len(schedule.pieces) - 1)]
        self.algebraics = algebraics
        self.steps = np.diff(times)
        function = problem.equations.compiled(_following)
        numbers = np.tile(problem.numbers(), (count, 1))
        given = [states.T, algebraics.T, times, pieces, numbers]
        self._push, self.jacobians = mapped(problem, function, given)
        """Nonzeros of the algebraic equations' Jacobian (m + 1, nnz), column by column."""
        rows, starts = (np.array(k, dtype=np.int32) for k in _columns(function.sparsity_out(1)))
        self._pattern = rows, starts
        self._known: dict[int, np.ndarray] = {}

    def at(self, k: int) -> np.ndarray:
        """Rates (nz,) at the k-th end; infinite where the equations are singular."""
        if k not in self._known:
            size = len(self.algebraics)
            matrix = csc_matrix((self.jacobians[k], *self._pattern), shape=(size, size))
            try:
                self._known[k] = -splu(matrix).solve(self._push[k])
            except RuntimeError:  # its word for a singular matrix
                self._known[k] = np.full(size, np.inf)
        return self._known[k]


def _columns(pattern: ca.Sparsity) -> tuple[list[int], list[int]]:
    """Row of every nonzero, and where each column begins."""
    return list(pattern.row()), list(pattern.colind())


def _following(e: Formulas) -> ca.Function:
    """(x, z, t, pieces, parameters) -> rate at which the constraints are left, d alg/d z."""
    x, z = e.states.vector, e.algebraics.vector
    push = ca.jtimes(e.alg, x, e.ode) + ca.jtimes(e.alg, e.time, SX(1))
    slopes = jacobian(e.alg, z)
    given = [x, z, e.time, e.pieces, e.parameters]
    return ca.Function("following", given, [ca.densify(push), slopes])


def end_of_branch(solver: Solver, here: Start, edge: int, work: Work) -> SolveError | None:
    """Why a solver cannot pass the interval from an edge, if the rod's branch ends in it.

    As far as it can be solved the interval is solved in small parts; from there the fluid
    goes straight on, and the rod is followed with it.
    """
    problem, schedule = solver.problem, solver.problem.schedule
    piece = schedule.pieces[edge]
    try:
        here = consistent(problem, here, schedule.edges[edge], piece, solver.before(edge))
        begin, end = schedule.edges[edge], schedule.edges[edge + 1]
        times = np.linspace(begin, end, PARTS + 1)
        same = Pieces(piece[None], np.array([0]), PARTS)
        parts = Schedule(times, same, np.arange(PARTS + 1), piece)
        finer = replace(problem, schedule=parts)
        columns, failure = watched(type(solver)(finer, solver.tolerance), here, 0, PARTS, work)
        if failure is None or failure.quantity == "equilibrium":
            return failure
        done = columns[0].shape[1]
        if done:
            here = Start(columns[0][:, -1], columns[1][:, -1])
        _go_straight_on(problem, here, (float(times[done]), float(times[done + 1])), piece)
    except SolveError as error:
        return error if error.quantity == "equilibrium" else None
    return None


def _go_straight_on(
    problem: Problem, here: Start, times: tuple[float, float], piece: np.ndarray
) -> None:
    """Follow the rod while its fluid keeps its rates; raises `SolveError` at the branch's end."""
    before = Moment(here.states, times[0], piece)
    rates, _ = evaluate(
        problem.equations.function, here.states, here.algebraics, *problem.tail(times[0], piece)
    )
    after = here.states + (times[1] - times[0]) * np.array(rates).ravel()
    followed(problem, here.algebraics, before, Moment(after, times[1], piece))


def watched(
    solver: Solver, here: Start, first: int, stop: int, work: Work
) -> tuple[Columns, SolveError | None]:
    """What a solver finds, as far as a rod without inertia keeps to its branch in it."""
    columns, failure = solver(here, first, stop, work)
    if not has_branches(solver.problem):
        return columns, failure
    watch = LeapWatch(solver.problem, solver.tolerance)
    states = np.column_stack((here.states, columns[0]))
    kept, left = watch.first_leap(here.algebraics, first, states, columns[1])
    if left is None:
        return columns, failure
    return (columns[0][:, :kept], columns[1][:, :kept], columns[2][:, :kept]), left


def has_branches(problem: Problem) -> bool:
    """Whether a rod is static beside a fluid that is integrated."""
    static = problem.equations.rod_form is RodForm.STATIC
    return static and problem.equations.states.count > 0


def leap(time: float) -> SolveError:
    """The failure of a solver that leaves a branch which goes on."""
    return SolveError(
        f"the solver leaps to another equilibrium of the rod before t = {time:.6g} s",
        quantity="motion",
        where="rod",
        time_s=float(time),
        remedy="Write down more outputs, ask for more accuracy, or let effects.inertia and "
        "effects.damping be auto or on.",
    )
