"""Whether a solver leaps from one equilibrium of a static rod to another, and where a branch ends.

The rod's equations are algebraic, those of its fluid are not: what integrates both sees a
fold only as equations that become hard to solve.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.branch import Moment, constraints, followed, is_stable
from viscodesign.solve.newton import NewtonError, newton
from viscodesign.solve.problem import Problem, Schedule, evaluate
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start, consistent
from viscodesign.solve.ways import way_of

STILL = 20.0
"""Move between two outputs, in tolerances of the solver, below which no leap is looked for."""
APART = 1e-6
"""Distance of two solutions of the same equations, in lengths, from which they are two."""
PARTS = 64
"""Parts of an interval that no solver can pass, to find where the branch ends in it."""


class LeapWatch:
    """Looks over a solver's shoulder at every output: is the rod still on its branch?"""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.slight = STILL * tolerance

    def first_leap(
        self, algebraics: np.ndarray, first: int, states: np.ndarray, found: np.ndarray
    ) -> tuple[int, SolveError | None]:
        """How many of the solved intervals from edge ``first`` are to be kept, and why no more.

        ``algebraics`` (nz,): before the first; ``states`` (nx, m + 1): before it and after
        each; ``found`` (nz, m).
        """
        for k in range(found.shape[1]):
            moments = self._ends(first + k, states[:, k], states[:, k + 1])
            try:
                failure = self._judge(algebraics, found[:, k], *moments)
            except SolveError as ended:
                failure = ended
            if failure is not None:
                return k, failure
            algebraics = found[:, k]
        return found.shape[1], None

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
        unknowns = self.problem.equations.algebraics
        place = unknowns.blocks["position"].span
        moved = np.max(np.abs(found[place] - start[place])) > self.slight
        if not moved and is_stable(unknowns, constraints(self.problem, after, found)[1]):
            return None
        along = followed(self.problem, start, before, after)
        try:
            exact = newton(partial(constraints, self.problem, after), found, way_of(unknowns))
        except NewtonError:
            return leap(after.time)
        return leap(after.time) if np.max(np.abs(exact - along)[place]) > APART else None


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
        parts = Schedule(times, np.tile(piece, (PARTS, 1)), np.arange(PARTS + 1), piece)
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
