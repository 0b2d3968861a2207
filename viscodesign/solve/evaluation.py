"""Evaluation of the equations' functions with numbers: at one instant, or along many edges."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.model.equations import Formulas
from viscodesign.solve.problem import Problem


class BufferedCall:
    """A call of a function that reads and writes the same arrays each time, without conversion.

    The arrays are contiguous, of `float`, with as many entries as the function has nonzeros.
    """

    def __init__(
        self, function: ca.Function, arguments: Sequence[np.ndarray], results: Sequence[np.ndarray]
    ) -> None:
        # The buffer holds addresses only: the arrays must be kept alive.
        self._kept = (*arguments, *results)
        self._buffer, self._run = function.buffer()
        places = (self._buffer.set_arg, arguments), (self._buffer.set_res, results)
        for place, arrays in places:
            for k, array in enumerate(arrays):
                if array.size:
                    place(k, memoryview(array.reshape(-1)))  # type: ignore[call-arg, arg-type]

    def __call__(self) -> None:
        """Read the arguments, write the results."""
        self._run()


def evaluate_along(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int = 0
) -> dict[str, np.ndarray]:
    """All named outputs (m, n) at m edges from ``first`` on, from unknowns (nx, m) and (nz, m)."""
    output = problem.equations.output_function
    found = evaluate_rows(problem, output, rows_along(problem, states, algebraics, first))
    return dict(zip(output.name_out(), found, strict=True))


def rows_along(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int
) -> list[np.ndarray]:
    """Arguments of the equations' functions at m edges from ``first`` on, each (m, n)."""
    equations, schedule = problem.equations, problem.schedule
    count = states.shape[1]
    edges = np.arange(first, first + count)
    # A state just before a corner belongs to the interval that ends there.
    pieces = schedule.pieces[np.maximum(edges - 1, 0)]
    tail = (equations.sealed_volumes, equations.parameter_values)
    return [
        states.T,
        algebraics.T,
        schedule.edges[edges],
        pieces,
        np.ones(count),
        *(np.broadcast_to(values, (count, len(values))) for values in tail),
    ]


def evaluate_rows(
    problem: Problem, function: ca.Function, rows: Sequence[np.ndarray]
) -> list[np.ndarray]:
    """Nonzeros of a function's results (m, n), column by column, for rows of arguments (m, n)."""
    count = len(rows[0])
    found = [np.zeros((count, function.nnz_out(k))) for k in range(function.n_out())]
    call = BufferedCall(
        problem.equations.compiled(_mapped, function, count),
        [np.ascontiguousarray(row, dtype=float) for row in rows],
        found,
    )
    call()
    return found


def _mapped(_: Formulas, function: ca.Function, count: int) -> ca.Function:
    return function.map(count)


def evaluate_at(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, time: float, piece: np.ndarray
) -> dict[str, np.ndarray]:
    """All named outputs (1, n) at one instant."""
    output = problem.equations.output_function
    found = evaluate(output, states, algebraics, *problem.tail(time, piece))
    return {n: np.array(v).reshape(1, -1) for n, v in zip(output.name_out(), found, strict=True)}


def evaluate(function: ca.Function, *arguments: float | np.ndarray) -> list[ca.DM]:
    """Call a CasADi function with numbers."""
    return list(function.call([ca.DM(argument) for argument in arguments]))
