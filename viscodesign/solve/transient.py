"""Motion through time, with whichever solver.

Long runs are cut into chunks, so that progress can be told and an interrupt keeps
what was computed.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.interrupt import gentle_interrupt
from viscodesign.plugins import members
from viscodesign.results.findings import RetryAttempt
from viscodesign.solve import solvers
from viscodesign.solve.fallbacks import Ladder
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.solvers.quasi_static import Algebraic
from viscodesign.solve.statics import Start, consistent
from viscodesign.solve.time_only_integrals import timed_integrals
from viscodesign.storage.disk_arrays import ArrayStore, NoRoomError

CHUNK_SECONDS = 0.4
"""Wall time that one uninterrupted call should take, where each output is solved by itself."""
CHUNK_WORK = 400_000
"""Steps times unknowns of one call of an integrator: some tenths of a second. No clock decides
where one begins afresh, or a run would come out otherwise on a busy machine."""
CHUNK_STEPS = 1_000
"""The same in steps, at least: an integrator of another length has to be made first, which takes
as long as some of them."""
FIRST_CHUNK = 0.1
"""Part of a long run that is solved first, to learn how fast it goes."""
DEFAULT_SOLVER = "idas"
RINGING_SOLVER = "rosenbrock"
"""For vibrations that nothing damps: BDF of high order is not stable there."""


@dataclass
class Solution:
    """Scaled unknowns and balance integrals at the edges that were reached."""

    states: np.ndarray
    """(nx, m)"""
    algebraics: np.ndarray
    """(nz, m)"""
    integrals: np.ndarray
    """(nq, m) running integrals of the equations' rates, over `energy_size`."""
    reached: int
    """Number of edges solved, counted from the first."""
    work: Work
    failure: SolveError | None = None
    interrupted: bool = False
    """Whether it ended early because the user asked."""
    asked_to_stop: bool = False
    """Whether the user asked at all, be it when all was done: nothing more should follow."""
    rungs: tuple[RetryAttempt, ...] = ()
    """What was tried where the solver came to a stop."""
    solver: str = DEFAULT_SOLVER
    """Name of the one that began."""

    @property
    def beginning(self) -> Start:
        """Unknowns at the first edge."""
        return Start(self.states[:, 0], self.algebraics[:, 0])

    def without_columns(self) -> Solution:
        """The same with unknowns and integrals at the first edge alone."""
        first = (v[:, :1].copy() for v in (self.states, self.algebraics, self.integrals))
        states, algebraics, integrals = first
        return replace(self, states=states, algebraics=algebraics, integrals=integrals)


class _Record:
    """Columns gathered chunk by chunk, and the place that they lead to."""

    def __init__(self, here: Start, rates: int, store: ArrayStore) -> None:
        self.here = here
        self.done = 0
        """Edges passed."""
        self._total = np.zeros(rates)
        self._tables = [
            store.growing_array(n) for n in (len(here.states), len(here.algebraics), rates)
        ]
        self._add(here.states[:, None], here.algebraics[:, None], self._total[:, None])

    def keep(self, columns: Columns, problem: Problem) -> SolveError | None:
        """Add what a solver found from here on, and the integrals that it left out.

        Returns the failure where there is no room for it.
        """
        states, algebraics, integrals = columns
        count = states.shape[1]
        if not count:
            return None
        timed = timed_integrals(problem, self.done, count)
        integrals = np.concatenate([integrals, timed])
        try:
            self._add(states, algebraics, self._total[:, None] + integrals)
        except NoRoomError as error:
            return SolveError(str(error), quantity="room", where="disk")
        self._total = self._total + integrals[:, -1]
        self.here = Start(states[:, -1], algebraics[:, -1])
        self.done += states.shape[1]
        return None

    def _add(self, *columns: np.ndarray) -> None:
        try:
            for table, values in zip(self._tables, columns, strict=True):
                table.append(values.T)
        except NoRoomError:
            for table in self._tables:
                table.cut(self.done + 1)
            raise

    def joined(self) -> Columns:
        """States, algebraic unknowns and integrals at all edges from the first."""
        states, algebraics, integrals = (table.array().T for table in self._tables)
        return states, algebraics, integrals


@cache
def solver_catalogue() -> dict[str, type[Solver]]:
    """Every solver by name, the default first."""
    return members(solvers.__name__, Solver)  # type: ignore[type-abstract]


def integrate(
    problem: Problem,
    start: Start,
    tolerance: float,
    progress: Callable[[float], None] | None = None,
    solver: str = DEFAULT_SOLVER,
    store: ArrayStore | None = None,
) -> Solution:
    """Follow the motion over all edges of the schedule.

    ``start``: states at t = 0; ``tolerance``: relative and absolute, on scaled
    unknowns; ``solver``: its name in the catalogue; ``store``: for what is found. Never
    raises for a failure on the way: what was reached is returned, with the failure.
    """
    moves = problem.equations.states.count > 0
    if not solver_catalogue()[solver].takes(problem):
        solver = DEFAULT_SOLVER
    march = (solver_catalogue()[solver] if moves else Algebraic)(problem, tolerance)
    ladder = Ladder(march, list(solver_catalogue().values()) if moves else [])
    edges = problem.schedule.edges
    work = Work()
    start = consistent(problem, start, edges[0], problem.schedule.pieces[0])
    record = _Record(start, len(problem.equations.rates), store or ArrayStore())
    failure: SolveError | None = None
    length = _first_length(problem)
    with gentle_interrupt() as interrupt:
        while record.done < len(edges) - 1 and failure is None and not interrupt.asked:
            first, began, before = record.done, clock.perf_counter(), work.steps
            stop = min(first + length, len(edges) - 1)
            columns, failure = ladder.go(record.here, first, stop, work)
            full = record.keep(columns, problem)
            if failure is not None and failure.quantity != "work" and not interrupt.asked:
                columns, failure = ladder.climb(record.here, record.done, work, failure)
                full = full or record.keep(columns, problem)
            failure = full or failure
            if failure is None and work.steps > problem.most_steps:
                failure = march.overworked(edges[record.done])
            spent, steps = clock.perf_counter() - began, work.steps - before
            length = _next_length(record.done - first, spent, steps, problem)
            length = min(length, _longest(problem))
            if progress is not None:
                progress(edges[record.done] / edges[-1])
    early = record.done < len(edges) - 1
    return Solution(
        *record.joined(),
        record.done + 1,
        work,
        failure if early else None,
        interrupt.asked and early,
        interrupt.asked,
        tuple(ladder.rungs),
        solver,
    )


def _first_length(problem: Problem) -> int:
    """Intervals of the first chunk: all of a run that is surely short, else a part."""
    intervals = len(problem.schedule.edges) - 1
    if intervals * max(problem.unknowns, 20) <= SHORT_RUN:
        return min(intervals, _longest(problem))
    return max(1, min(int(FIRST_CHUNK * intervals), _longest(problem)))


def _longest(problem: Problem) -> int:
    """Intervals whose unknowns one call of an integrator may hold in memory.

    Nor more than a part of the steps allowed: they are counted when it is done. But an
    integrator of its own for a few intervals would take longer to make than to run.
    """
    held = LARGEST_CHUNK // (problem.unknowns + len(problem.equations.rates) + 1)
    counted = max(FEWEST_INTERVALS, int(LARGEST_SHARE * problem.most_steps))
    return max(1, min(held, counted))


FEWEST_INTERVALS = 500
"""Intervals that one call may have whatever steps are allowed."""
LARGEST_SHARE = 0.02
"""Intervals of one call, at most, in parts of the steps that a run may take."""
LARGEST_CHUNK = 1_000_000
"""Numbers that one uninterrupted call of the integrator may give."""
SHORT_RUN = 200_000
"""Intervals times unknowns up to which a run takes well under a second."""


def _next_length(count: int, seconds: float, steps: int, problem: Problem) -> int:
    """Intervals that take a moment, after ``count`` that took ``steps`` and ``seconds``."""
    if not problem.equations.states.count:
        return max(1, int(count * CHUNK_SECONDS / max(seconds, 1e-6)))
    wanted = max(CHUNK_WORK / problem.unknowns, CHUNK_STEPS)
    return max(1, int(count * wanted / max(steps, 1)))
