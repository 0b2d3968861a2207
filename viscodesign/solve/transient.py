"""Time integration with any solver of the catalogue.

Long runs are cut into chunks, so that progress can be reported and an interrupt keeps
what was computed.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.interrupt import gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.plugins import members
from viscodesign.results.findings import RetryAttempt
from viscodesign.solve import solvers
from viscodesign.solve.contact_steps import ContactSteps
from viscodesign.solve.event_failures import EventError
from viscodesign.solve.fallbacks import Fallbacks
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.solvers.quasi_static import QuasiStatic
from viscodesign.solve.statics import Start
from viscodesign.solve.time_only_integrals import timed_integrals
from viscodesign.storage.disk_arrays import ArrayStore, NoRoomError


@dataclass(frozen=True)
class ChunkSizes:
    """How much of a run is solved in one uninterrupted call."""

    seconds: float = 0.4
    """Wall time of one call, where each output is solved separately."""
    work: int = 400_000
    """Steps times unknowns of one call of an integrator: some tenths of a second. Not in wall
    time, since where an integrator restarts would then depend on how busy the machine is."""
    min_steps: int = 1_000
    """Steps of one call at least: an integrator of another length has to be built first, which
    takes as long as some of them."""
    first_share: float = 0.1
    """Part of a long run that is solved first, to measure the work that it takes."""
    short_run: int = 200_000
    """Intervals times unknowns up to which a run takes well under a second."""
    max_numbers: int = 1_000_000
    """Numbers that one call of the integrator may return."""
    max_share_of_steps: float = 0.02
    """Intervals of one call, at most, relative to the steps that a run may take."""
    min_intervals: int = 500
    """Intervals that one call may have whatever steps are allowed."""


CHUNK = ChunkSizes()
DEFAULT_SOLVER = "rosenbrock"
SPARE_SOLVER = "idas"
"""For equations that the default does not take."""


@dataclass
class Solution:
    """Scaled unknowns and integrals of the balances at the edges that were reached."""

    states: np.ndarray
    """(nx, m)"""
    algebraics: np.ndarray
    """(nz, m)"""
    integrals: np.ndarray
    """(nq, m) integrals of the equations' rates from the first edge, over `energy_size`."""
    reached: int
    """Number of edges solved, counted from the first."""
    work: Work
    failure: SolveError | None = None
    interrupted: bool = False
    """Whether it ended early because the user interrupted it."""
    asked_to_stop: bool = False
    """Whether the user interrupted at all, even after the last step: nothing more should follow."""
    attempts: tuple[RetryAttempt, ...] = ()
    """What was tried where the solver failed."""
    solver: str = DEFAULT_SOLVER
    """Name of the one that started."""

    @property
    def beginning(self) -> Start:
        """Unknowns at the first edge."""
        return Start(self.states[:, 0], self.algebraics[:, 0])

    def without_columns(self) -> Solution:
        """The same with unknowns and integrals at the first edge only."""
        first = (v[:, :1].copy() for v in (self.states, self.algebraics, self.integrals))
        states, algebraics, integrals = first
        return replace(self, states=states, algebraics=algebraics, integrals=integrals)


class _Record:
    """Columns gathered chunk by chunk, and the unknowns at the last of them."""

    def __init__(self, here: Start, rates: int, store: ArrayStore) -> None:
        self.here = here
        self.done = 0
        """Intervals solved."""
        self._total = np.zeros(rates)
        self._tables = [
            store.growing_array(n) for n in (len(here.states), len(here.algebraics), rates)
        ]
        self._add(here.states[:, None], here.algebraics[:, None], self._total[:, None])

    def keep(self, columns: Columns, problem: Problem) -> SolveError | None:
        """Append a solver's columns, with the integrals that depend on time alone.

        Returns the failure if the disk is full.
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


def every_solver() -> dict[str, type[Solver]]:
    """The catalogue, and the solver of problems with contact, beside which there is no choice."""
    return {**solver_catalogue(), ContactSteps.name: ContactSteps}


def suitable_solver(problem: Problem, wanted: str, is_free: bool = False) -> str:
    """The first that takes these equations, and a problem of their size: one without error in
    time, if the choice is free; the wanted one; the spare one.
    """
    catalogue = solver_catalogue()
    if problem.equations.contacts:
        return ContactSteps.name
    for name, kind in catalogue.items():
        if is_free and kind.is_exact and kind.fits(problem) and kind.takes(problem):
            return name
    given = catalogue[wanted]
    return wanted if given.fits(problem) and given.takes(problem) else SPARE_SOLVER


def integrate(
    problem: Problem,
    start: Start,
    tolerance: float,
    progress: Callable[[float], None] | None = None,
    solver: str = DEFAULT_SOLVER,
    store: ArrayStore | None = None,
) -> Solution:
    """Integrate over all edges of the schedule.

    ``start``: states at t = 0; ``tolerance``: relative and absolute, of scaled
    unknowns; ``solver``: its name in the catalogue; ``store``: for the columns. Never
    raises for a failure on the way: what was reached is returned, with the failure.
    """
    moves = problem.equations.states.count > 0
    solver = suitable_solver(problem, solver)
    chosen = (every_solver()[solver] if moves else QuasiStatic)(problem, tolerance)
    others = moves and not problem.equations.contacts
    fallbacks = Fallbacks(chosen, list(solver_catalogue().values()) if others else [])
    edges = problem.schedule.edges
    work = Work(progress=progress and (lambda time: progress(time / edges[-1])))
    start = chosen.consistent(start, float(edges[0]), problem.schedule.pieces[0])
    record = _Record(start, len(problem.equations.rates), store or ArrayStore())
    failure: SolveError | None = None
    length = _first_length(problem)
    with gentle_interrupt() as interrupt:
        work.is_stopped = lambda: interrupt.asked
        while record.done < len(edges) - 1 and failure is None and not interrupt.asked:
            first, began, before = record.done, clock.perf_counter(), work.steps
            stop = min(first + length, len(edges) - 1)
            columns, failure = fallbacks.advance(record.here, first, stop, work)
            full = record.keep(columns, problem)
            if _is_recoverable(failure) and not interrupt.asked:
                assert failure is not None
                columns, failure = fallbacks.recover(record.here, record.done, work, failure)
                full = full or record.keep(columns, problem)
            failure = full or failure
            if failure is None and work.steps > problem.max_steps:
                failure = chosen.step_limit_reached(edges[record.done])
            spent, steps = clock.perf_counter() - began, work.steps - before
            length = _next_length(record.done - first, spent, steps, problem)
            length = min(length, _longest(problem))
            if progress is not None:
                progress(edges[record.done] / edges[-1])
    early = record.done < len(edges) - 1
    return Solution(
        *record.joined(),
        record.done + 1,
        replace(work, progress=None, is_stopped=Work().is_stopped),
        failure if early and not interrupt.asked else None,
        interrupt.asked and early,
        interrupt.asked,
        tuple(fallbacks.attempts),
        solver,
    )


def _is_recoverable(failure: SolveError | None) -> bool:
    """Whether another solver may go on where one failed."""
    is_final = failure is None or failure.quantity == "work" or isinstance(failure, EventError)
    return not is_final


def _first_length(problem: Problem) -> int:
    """Intervals of the first chunk: all of a short run, else a part."""
    intervals = len(problem.schedule.edges) - 1
    if intervals * max(problem.unknowns, 20) <= CHUNK.short_run:
        return min(intervals, _longest(problem))
    return max(1, min(int(CHUNK.first_share * intervals), _longest(problem)))


def _longest(problem: Problem) -> int:
    """Intervals of one call, so that its unknowns fit into memory.

    At most a part of the steps allowed, which are only counted afterwards; but an
    integrator for just a few intervals would take longer to build than to run.
    """
    held = CHUNK.max_numbers // (problem.unknowns + len(problem.equations.rates) + 1)
    counted = max(CHUNK.min_intervals, int(CHUNK.max_share_of_steps * problem.max_steps))
    return max(1, min(held, counted))


def _next_length(count: int, seconds: float, steps: int, problem: Problem) -> int:
    """Intervals of the next chunk, after ``count`` that took ``steps`` and ``seconds``."""
    if not problem.equations.states.count:
        return max(1, int(count * CHUNK.seconds / max(seconds, 1e-6)))
    wanted = max(CHUNK.work / problem.unknowns, CHUNK.min_steps)
    return max(1, int(count * wanted / max(steps, 1)))
