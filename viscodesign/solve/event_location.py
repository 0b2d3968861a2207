"""When exactly an event happens, between two times of a solution."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.solve.event_failures import EventError
from viscodesign.solve.events import Crossing, EventWatch, start_of
from viscodesign.solve.problem import Pieces, Problem, Schedule
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start
from viscodesign.storage.distinct import distinct

LOCATED_REL_TOL = 1e-8
"""Part of the run's duration to which the time of an event is found."""
MARGIN_STEPS = 3.0
"""Steps behind an event within which a more accurate solution is to meet it, too."""
PARTS = 64
"""Into which the time in question is cut, again and again."""
PARTS_OF_DIP = 32
"""Into which the time is cut in which a solution may have gone beyond a limit and back."""


def located(solver: Solver, crossing: Crossing, work: Work) -> EventError:
    """The event that a solver meets, at its one time.

    Two solutions of one tolerance differ by how their steps fall, and their events with them. So
    the event is that of a far more accurate solution from some steps before, where the solver has
    one and it meets the event as well.
    """
    behind = MARGIN_STEPS * (crossing.end - crossing.begin)
    until = min(crossing.end + behind, float(solver.problem.schedule.edges[-1]))
    if until > crossing.origin_time:
        finer = solver.finest(_between(solver.problem, crossing.origin_time, until))
        met = None if finer is None else _met(finer, crossing.origin, work)
        if met is not None:
            return met
    return _narrowed(solver, crossing, work)


def _met(solver: Solver, origin: Start, work: Work) -> EventError | None:
    """The first event on all of a solver's schedule."""
    count = len(solver.problem.schedule.pieces)
    columns, failure = solver(origin, 0, count, work)
    if isinstance(failure, EventError):
        return failure
    return until_event(solver, origin, 0, columns, work)[1]


def _narrowed(solver: Solver, crossing: Crossing, work: Work) -> EventError:
    """The event at the time at which a solver itself meets it.

    The solver goes over the time in question once more, again and again in the same steps, and is
    read ever more densely where the event is.
    """
    problem = solver.problem
    resolution = LOCATED_REL_TOL * float(problem.schedule.edges[-1])
    watch, error = EventWatch(problem), crossing.error
    begin, end = crossing.begin, crossing.end
    while end - begin > resolution:
        inside = np.linspace(begin, end, PARTS + 1)
        times = distinct(np.concatenate([[crossing.begin], inside, [crossing.end]]))
        found = watch.first(*_solved_at(solver, crossing.before, times, work))
        if found is None:
            break  # met by none but the step that found it
        row, error = found
        if row == 0 or times[row] > end:
            break  # at a jump of an input, or known to all digits
        begin, end = float(times[row - 1]), float(times[row])
    return error


def _solved_at(
    solver: Solver, here: Start, times: np.ndarray, work: Work
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, inputs' coefficients behind them and unknowns (m, nx + nz) at rising times (m,).

    Fewer where a solver does not reach them all.
    """
    problem = _over(solver.problem, times)
    (states, algebraics, _), _ = solver.unwatched(problem)(here, 0, len(times) - 1, work)
    first = np.concatenate([here.states, here.algebraics])
    rows = np.vstack([first, np.concatenate([states, algebraics]).T])
    pieces = problem.schedule.pieces[np.maximum(np.arange(len(rows)) - 1, 0)]
    return times[: len(rows)], pieces, rows


def _between(problem: Problem, begin: float, until: float) -> Problem:
    """The problem from one time to another, with its own edges in between."""
    edges = problem.schedule.edges
    inside = edges[(edges > begin) & (edges < until)]
    return _over(problem, np.concatenate([[begin], inside, [until]]))


def _over(problem: Problem, times: np.ndarray) -> Problem:
    """The problem at rising times (m,), none of whose intervals has a corner of an input inside."""
    schedule, count = problem.schedule, len(times) - 1
    intervals = np.searchsorted(schedule.edges, times[:-1], side="right") - 1
    pieces = Pieces(schedule.pieces[intervals], np.arange(count), count)
    return replace(problem, schedule=Schedule(times, pieces, np.arange(count + 1), pieces[0]))


def until_event(
    solver: Solver, here: Start, first: int, columns: Columns, work: Work
) -> tuple[Columns, EventError | None]:
    """Columns behind edge ``first`` as far as no event happens, and the event that ends them.

    Also of a solver that watches its steps: within a step its solution may meet what its ends do
    not.
    """
    schedule, count = solver.problem.schedule, columns[0].shape[1]
    if not count:
        return columns, None
    edges = np.arange(first, first + count + 1)
    start = np.concatenate([here.states, here.algebraics])
    rows = np.vstack([start, np.concatenate(columns[:2]).T])
    crossing = _crossing(solver, edges, rows, work)
    if crossing is None:
        return columns, None
    event = located(solver, crossing, work)
    end = min(event.time_s, crossing.end)
    valid = int(np.searchsorted(schedule.edges[edges[1:]], end))
    states, algebraics, integrals = (values[:, :valid] for values in columns)
    return (states, algebraics, integrals), event


def _crossing(solver: Solver, edges: np.ndarray, rows: np.ndarray, work: Work) -> Crossing | None:
    """The first event among unknowns (m, nx + nz) at edges (m,), or in a dip between them."""
    schedule, watch = solver.problem.schedule, EventWatch(solver.problem)
    pieces = schedule.pieces[np.maximum(edges - 1, 0)]
    times = schedule.edges[edges]
    crossing, dips = watch.crossing_and_dips(times, pieces, rows)
    for before, after in dips:
        parts = np.linspace(times[before], times[after], PARTS_OF_DIP + 1)
        inside = distinct(np.concatenate([parts, times[before : after + 1]]))
        dip = watch.crossing(
            *_solved_at(solver, start_of(solver.problem, rows[before]), inside, work)
        )
        if dip is not None:
            return dip
    return crossing
