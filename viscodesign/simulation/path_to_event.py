"""The motion up to an event that ends a run before many of its outputs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.postprocess.motion import read_motion
from viscodesign.simulation.solve_once import Run
from viscodesign.solve.event_failures import EventError
from viscodesign.solve.problem import Schedule
from viscodesign.solve.transient import integrate
from viscodesign.storage.disk_arrays import ArrayStore
from viscodesign.storage.distinct import distinct

MIN_ROWS_TO_EVENT = 20
"""Outputs before an event from which they show the way there."""
ROWS_TO_EVENT = 50
"""Outputs that a run with fewer gets, up to the event."""
SAME_TIME_REL = 1e-5
"""Share of the run within which two solutions meet the same event."""


def with_path_to_event(run: Run, store: ArrayStore) -> Run:
    """A run with rows up to the event that ended it, where its own outputs are too few.

    It is solved again up to there, which takes no longer than the first time.
    """
    failure = run.motion.failure
    if not isinstance(failure, EventError) or len(run.motion.time) >= MIN_ROWS_TO_EVENT:
        return run
    begin, settings = run.solution.beginning, run.settings
    problem = replace(run.problem, schedule=_denser(run.problem.schedule, failure.time_s))
    solution = integrate(problem, begin, settings.tolerance, None, run.solution.solver, store)
    motion, again = read_motion(problem, solution, store), solution.failure
    duration = float(problem.schedule.edges[-1])
    if not isinstance(again, EventError):
        return run
    if abs(again.time_s - failure.time_s) > SAME_TIME_REL * duration:
        return run
    return replace(run, motion=replace(motion, failure=failure))


def _denser(schedule: Schedule, until: float) -> Schedule:
    """The schedule with outputs before a time [s]."""
    times = np.linspace(0.0, until, ROWS_TO_EVENT, endpoint=False)
    outputs = distinct(np.concatenate([schedule.edges[schedule.outputs], times]))
    edges = distinct(np.concatenate([schedule.edges, times]))
    pieces = schedule.pieces.among(schedule.edges, edges)
    return replace(schedule, edges=edges, pieces=pieces, outputs=np.searchsorted(edges, outputs))
