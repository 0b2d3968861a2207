"""Motion through time, with whichever solver.

Long runs are cut into chunks, so that progress can be told and an interrupt keeps
what was computed.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from viscodesign.catalog import members
from viscodesign.errors import SolveError
from viscodesign.solve import solvers
from viscodesign.solve.algebraic import Algebraic
from viscodesign.solve.interrupt import gentle_interrupt
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Solver, Work
from viscodesign.solve.statics import Start, consistent

CHUNK_SECONDS = 0.4
"""Wall time that one uninterrupted call of the integrator should take."""
CHUNK_PER_COMPILE = 10.0
"""The same, at least, in times that making an integrator takes."""
FIRST_CHUNK = 0.1
"""Part of a long run that is solved first, to learn how fast it goes."""


@dataclass
class Solution:
    """Scaled unknowns and balance integrals at the edges that were reached."""

    states: np.ndarray
    """(nx, m)"""
    algebraics: np.ndarray
    """(nz, m)"""
    integrals: np.ndarray
    """(nq, m) running integrals of the equations' rates, in SI."""
    reached: int
    """Number of edges solved, counted from the first."""
    work: Work
    failure: SolveError | None = None
    interrupted: bool = False
    """Whether it ended early because the user asked."""
    asked_to_stop: bool = False
    """Whether the user asked at all, be it when all was done: nothing more should follow."""


@dataclass
class _Record:
    """Columns gathered chunk by chunk."""

    states: list[np.ndarray] = field(default_factory=list)
    algebraics: list[np.ndarray] = field(default_factory=list)
    integrals: list[np.ndarray] = field(default_factory=list)


DEFAULT_SOLVER = "idas"
RINGING_SOLVER = "rosenbrock"
"""For vibrations that nothing damps: BDF of high order is not stable there."""


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
) -> Solution:
    """Follow the motion over all edges of the schedule.

    ``start``: states at t = 0; ``tolerance``: relative and absolute, on scaled
    unknowns; ``solver``: its name in the catalogue. Never raises for a failure on the
    way: what was reached is returned, with the failure.
    """
    kind = solver_catalogue()[solver] if problem.equations.states.count else Algebraic
    march = kind(problem, tolerance)
    edges = problem.schedule.edges
    record, work = _Record(), Work()
    here = consistent(problem, start, edges[0], problem.schedule.pieces[0])
    total = np.zeros(len(problem.equations.rates))
    _append(record, here.states[:, None], here.algebraics[:, None], total[:, None])
    done, failure = 0, None
    length = _first_length(problem)
    with gentle_interrupt() as interrupt:
        while done < len(edges) - 1 and failure is None and not interrupt.asked:
            stop = min(done + length, len(edges) - 1)
            began = clock.perf_counter()
            columns, failure = march(here, done, stop, work)
            count = columns[0].shape[1]
            if count:
                _append(record, columns[0], columns[1], total[:, None] + columns[2])
                total = total + columns[2][:, -1]
                here = Start(columns[0][:, -1], columns[1][:, -1])
                done += count
            length = _next_length(count, clock.perf_counter() - began, work)
            if progress is not None:
                progress(edges[done] / edges[-1])
    return Solution(
        np.concatenate(record.states, axis=1),
        np.concatenate(record.algebraics, axis=1),
        np.concatenate(record.integrals, axis=1),
        done + 1,
        work,
        failure,
        interrupt.asked and done < len(edges) - 1,
        interrupt.asked,
    )


def _append(record: _Record, x: np.ndarray, z: np.ndarray, q: np.ndarray) -> None:
    record.states.append(x)
    record.algebraics.append(z)
    record.integrals.append(q)


def _first_length(problem: Problem) -> int:
    """Intervals of the first chunk: all of a run that is surely short, else a part."""
    equations = problem.equations
    intervals = len(problem.schedule.edges) - 1
    unknowns = equations.states.count + equations.algebraics.count
    if intervals * max(unknowns, 20) <= SHORT_RUN:
        return intervals
    return max(1, int(FIRST_CHUNK * intervals))


SHORT_RUN = 200_000
"""Intervals times unknowns up to which a run takes well under a second."""


def _next_length(count: int, seconds: float, work: Work) -> int:
    """Intervals that take a moment; where an integrator is slow to make, a longer one."""
    work.chunks += 1
    making = work.compile_s / work.chunks
    wanted = max(CHUNK_SECONDS, CHUNK_PER_COMPILE * making)
    return max(1, int(count * wanted / max(seconds - making, 1e-6)))
