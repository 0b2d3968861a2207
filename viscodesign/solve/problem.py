"""What every solver is given: equations with their numbers, and the run's times."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.model.formulation import Equations
from viscodesign.model.rod import Body


@dataclass(frozen=True)
class Schedule:
    """Times of a run and the inlets' piecewise coefficients.

    ``edges`` (n + 1,) holds 0, every output time, every corner of an input and
    the end, ascending; ``pieces`` (n, coefficients) are valid inside each
    interval; ``outputs`` are indices into ``edges``.
    """

    edges: np.ndarray
    pieces: np.ndarray
    outputs: np.ndarray
    initial_piece: np.ndarray
    """Coefficients just before t = 0, from which equilibrium is found."""


@dataclass(frozen=True)
class Problem:
    """Equations and the numbers that go into them."""

    equations: Equations
    body: Body
    bellows: tuple[str, ...]
    bellows_along_tubes: tuple[str, ...]
    """The same in the order of the unknowns."""
    baseline: float
    """Gauge pressure about which the inputs cycle [Pa]."""
    schedule: Schedule
    flow_shares: np.ndarray
    """(Q, B): tube flows per rate of every bellow's volume, where pressure is uniform."""

    @property
    def places(self) -> np.ndarray:
        """Where each of the bellows stands among the unknowns (B,)."""
        place = {name: k for k, name in enumerate(self.bellows_along_tubes)}
        return np.array([place[name] for name in self.bellows])

    def numbers(self, load_factor: float = 1.0) -> np.ndarray:
        """The parameter vector of the integrator: load factor, sealed volumes, parameters."""
        return np.concatenate(
            [[load_factor], self.equations.sealed_volumes, self.equations.parameter_values]
        )

    def tail(
        self, time: float, piece: np.ndarray, load_factor: float = 1.0
    ) -> tuple[float | np.ndarray, ...]:
        """Arguments that follow the unknowns in every function of the equations."""
        return (
            time,
            piece,
            load_factor,
            self.equations.sealed_volumes,
            self.equations.parameter_values,
        )


def evaluate_along(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, count: int
) -> dict[str, np.ndarray]:
    """All named outputs (count, n) at the first edges, from unknowns (n, count), in one call."""
    equations, schedule = problem.equations, problem.schedule
    function = equations.compiled.get(
        ("outputs", count), lambda: equations.output_function.map(count)
    )
    # A state just before a corner belongs to the interval that ends there.
    pieces = schedule.pieces[np.maximum(np.arange(count) - 1, 0)]
    tail = (equations.sealed_volumes, equations.parameter_values)
    rows = [
        states.T,
        algebraics.T,
        schedule.edges[:count],
        pieces,
        np.ones(count),
        *(np.broadcast_to(values, (count, len(values))) for values in tail),
    ]
    # By buffers: conversions to and from matrices would take longer than the call.
    buffer, run = function.buffer()
    held = [np.ascontiguousarray(row, dtype=float) for row in rows]
    names = equations.output_function.name_out()
    found = {
        name: np.zeros((count, equations.output_function.size1_out(k)))
        for k, name in enumerate(names)
    }
    for k, row in enumerate(held):
        if row.size:
            buffer.set_arg(k, memoryview(row.reshape(-1)))  # type: ignore[call-arg, arg-type]
    for k, values in enumerate(found.values()):
        if values.size:
            buffer.set_res(k, memoryview(values.reshape(-1)))  # type: ignore[call-arg, arg-type]
    run()
    return found


def evaluate(function: ca.Function, *arguments: float | np.ndarray) -> list[ca.DM]:
    """Call a CasADi function with numbers."""
    return list(function.call([ca.DM(argument) for argument in arguments]))
