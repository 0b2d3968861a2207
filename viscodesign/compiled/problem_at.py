"""A problem with other numbers, and what its columns are read from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.solve.problem import Pieces, Problem, Schedule

ROUND_OFF = 1e-12
"""Of the duration, within which times count as equal."""


def problem_at(problem: Problem, times: np.ndarray, numbers: ProblemNumbers) -> Problem:
    """The problem with other numbers, solved at the output times (T,) and at the stops."""
    near, stops = ROUND_OFF * numbers.stops[-1], numbers.stops
    own = times[np.min(np.abs(times[:, None] - stops), axis=1) > near]
    edges = np.sort(np.concatenate([stops, own]))
    schedule = Schedule(
        edges=edges,
        pieces=Pieces(numbers.pieces, np.searchsorted(edges, stops[:-1]), len(edges) - 1),
        outputs=np.searchsorted(edges, times - near),
        initial_piece=numbers.initial_piece,
    )
    equations = problem.equations.shared.with_numbers(numbers.parameters)
    floor = problem.floor_volume
    if floor is not None:
        floor *= equations.rest_amounts[0] / problem.equations.rest_amounts[0]
    return replace(problem, equations=equations, schedule=schedule, floor_volume=floor)


def stretch_of(times: np.ndarray, numbers: ProblemNumbers) -> np.ndarray:
    """(T,) Number of the stretch that each time belongs to: the earlier one at a corner."""
    late = times - ROUND_OFF * numbers.stops[-1]
    return np.asarray(np.maximum(np.searchsorted(numbers.stops, late) - 1, 0))


def reading_rows(
    problem: Problem, times: np.ndarray, numbers: ProblemNumbers, unknowns: np.ndarray
) -> list[np.ndarray]:
    """Arguments of a `Reading` for unknowns (T, nx + nz) at the output times (T,)."""
    states = problem.equations.states.count
    x, z = unknowns[:, :states], unknowns[:, states:]
    return [x, z, times, numbers.pieces[stretch_of(times, numbers)], numbers.parameters]
