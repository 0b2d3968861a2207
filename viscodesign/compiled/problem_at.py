"""A problem with other numbers, and to which of its stretches times belong."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.symbols import parameter_names
from viscodesign.simulation.build_problem import one_period
from viscodesign.solve.problem import SAME_TIME, DrawingLimits, Problem, Schedule


def problem_at(problem: Problem, times: np.ndarray, numbers: ProblemNumbers) -> Problem:
    """The problem with other numbers, solved at the output times (T,) and at the stops."""
    schedule = Schedule.of(times, numbers.stops, numbers.pieces, numbers.initial_piece)
    equations = problem.equations.shared.with_numbers(numbers.parameters)
    names = parameter_names(equations)
    ambient, baseline = (
        float(numbers.parameters[names.index(name)])
        for name in ("ambient_pressure", "gauge_pressure")
    )
    limits = _limits(problem, equations.rest_amounts, ambient)
    return replace(problem, equations=equations, schedule=schedule, baseline=baseline, **limits)


def strictest(problem: Problem, rest_amounts: np.ndarray, parameters: np.ndarray) -> Problem:
    """The problem with the strictest limits of m rows of parameters (m, p).

    ``rest_amounts`` (m, k): `Equations.rest_amounts` by them.
    """
    ambient = parameters[:, parameter_names(problem.equations).index("ambient_pressure")]
    return replace(problem, **_limits(problem, rest_amounts.max(axis=0), float(ambient.min())))


def _limits(problem: Problem, rest_amounts: np.ndarray, ambient: float) -> dict[str, Any]:
    """Volumes, and what ends a run, by contents at zero gauge [m3] and the ambient [Pa]."""
    amounts = rest_amounts / problem.equations.rest_amounts
    grown, own = float(amounts[0]), amounts[problem.places]
    rest, floor, drawing = problem.rest_volume, problem.floor_volume, problem.drawing
    if drawing is not None:
        least = drawing.least_volume
        drawing = DrawingLimits(-ambient, None if least is None else grown * least)
    return {
        "rest_volume": (own if isinstance(rest, np.ndarray) else grown) * rest,
        "floor_volume": own * floor if isinstance(floor, np.ndarray) else floor and grown * floor,
        "drawing": drawing,
    }


def cycle_at(problem: Problem, numbers: ProblemNumbers) -> Problem:
    """The same problem over one period of the inputs, whose end is the only output."""
    own = numbers.cycle_stops, numbers.cycle_pieces, numbers.initial_piece
    return replace(problem, schedule=one_period(*own))


def stretch_of(times: np.ndarray, numbers: ProblemNumbers) -> np.ndarray:
    """(T,) Number of the stretch that each time belongs to: the earlier one at a corner."""
    late = times - SAME_TIME * numbers.stops[-1]
    return np.asarray(np.maximum(np.searchsorted(numbers.stops, late) - 1, 0))
