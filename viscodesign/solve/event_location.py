"""When exactly an event happens, between two times of a solution."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.event_failures import EventError
from viscodesign.solve.events import Crossing, EventWatch
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


@dataclass(frozen=True)
class Located:
    """An event, and up to when a solution may be read."""

    error: EventError
    valid_until: float
    """Neither this solution nor a more accurate one has met the event before [s]."""


def located(
    solver: Solver, crossing: Crossing, piece: np.ndarray, work: Work, latest: float
) -> Located:
    """The event that a solver meets in one smooth stretch of the inputs, which ends at ``latest``.

    Two solutions of one tolerance differ by how their steps fall, and their events with them. So
    the event is that of a far more accurate solution from some steps before, where the solver has
    one and it meets the event as well.
    """
    error = _narrowed(solver, crossing, piece, work)
    until = min(crossing.end + MARGIN_STEPS * (crossing.end - crossing.begin), latest)
    if until <= crossing.origin_time:
        return Located(error, error.time_s)
    times = np.array([crossing.origin_time, until])
    finer = solver.finest(_over(solver.problem, times, piece))
    finest = finer(crossing.origin, 0, 1, work)[1] if finer is not None else None
    if not isinstance(finest, EventError):
        return Located(error, error.time_s)
    return Located(finest, min(error.time_s, finest.time_s))


def _narrowed(solver: Solver, crossing: Crossing, piece: np.ndarray, work: Work) -> EventError:
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
        rows = _rows_at(solver, crossing.before, times, piece, work)
        found = watch.first(times[: len(rows)], piece, rows)
        if found is None or found[0] == 0:
            break  # met by none but the step that found it
        row, error = found
        if times[row] > end:
            break
        begin, end = float(times[row - 1]), float(times[row])
    return error


def _rows_at(
    solver: Solver, here: Start, times: np.ndarray, piece: np.ndarray, work: Work
) -> np.ndarray:
    """Unknowns (m, nx + nz) at rising times (m,) in one stretch, or as many as a solver reaches."""
    narrow = solver.unwatched(_over(solver.problem, times, piece))
    (states, algebraics, _), _ = narrow(here, 0, len(times) - 1, work)
    first = np.concatenate([here.states, here.algebraics])
    return np.vstack([first, np.concatenate([states, algebraics]).T])


def _over(problem: Problem, times: np.ndarray, piece: np.ndarray) -> Problem:
    """The problem at rising times (m,) of one stretch."""
    count = len(times) - 1
    same = Pieces(piece[None], np.array([0]), count)
    return replace(problem, schedule=Schedule(times, same, np.arange(count + 1), piece))


def until_event(
    solver: Solver, here: Start, first: int, columns: Columns, work: Work
) -> tuple[Columns, EventError | None]:
    """Columns behind edge ``first`` as far as no event happens, and the event that ends them."""
    problem, schedule = solver.problem, solver.problem.schedule
    count = columns[0].shape[1]
    if solver.watches_steps or not count:
        return columns, None
    start = np.concatenate([here.states, here.algebraics])
    rows = np.vstack([start, np.concatenate(columns[:2]).T])
    edges = np.arange(first, first + count + 1)
    pieces = schedule.pieces[np.maximum(edges - 1, 0)]
    crossing = EventWatch(problem).crossing(schedule.edges[edges], pieces, rows)
    if crossing is None:
        return columns, None
    interval = int(np.searchsorted(schedule.edges, crossing.end)) - 1
    piece = schedule.pieces[max(interval, 0)]
    event = located(solver, crossing, piece, work, latest=crossing.end)
    valid = int(np.searchsorted(schedule.edges[first + 1 : first + count + 1], event.valid_until))
    states, algebraics, integrals = (values[:, :valid] for values in columns)
    return (states, algebraics, integrals), event.error
