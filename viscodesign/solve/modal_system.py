"""Linear equations with constant coefficients, in their modes.

States that nothing depends on, such as the volume delivered, follow from the others and from
integrals of inputs.
"""

from __future__ import annotations

import numpy as np

from viscodesign.model.equations import Equations
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.linear_formulas import input_parts, linear_parts, live_and_idle
from viscodesign.solve.numerics.by_numpy import NumpyFunction
from viscodesign.solve.numerics.decoupling import decoupled
from viscodesign.solve.numerics.dense_or_sparse import (
    Matrix,
    Solve,
    dense,
    diagonal_matrix,
    numeric,
    solver_of,
)
from viscodesign.solve.quadratic_rates import SUM_ROUND_OFF, QuadraticRate

MAX_SPREAD = 1e8
"""Fastest rate over that of the run up to which modes are taken: the energy balance loses digits
with flows through wide tubes, which are differences of nearly equal pressures."""


class ModalSystem:
    """The equations of one scene in their modes.

    Rows: the equations of the live states, on which others depend, then the algebraic ones, then
    those of the idle states. All values are departures from an origin, the unknowns at some
    instant: in equilibrium the rows are exactly zero there, and stay so. Inputs are the values of
    the D rows that depend on time, at the origin.

    Raises `numpy.linalg.LinAlgError` where the modes are not found.
    """

    def __init__(self, equations: Equations, numbers: np.ndarray, duration: float) -> None:
        parts = equations.compiled(linear_parts)
        matrix, slopes, *hessians = parts.call([numbers])
        self.numbers = numbers
        self.live, self.idle = live_and_idle(parts.sparsity_out(0), equations.states.count)
        self.algebraics = equations.algebraics.count
        own = np.concatenate([self.live, equations.states.count + np.arange(self.algebraics)])
        self.order = order = np.concatenate([own, self.idle]).astype(int)
        """Order of the rows, and of their unknowns: place among states and algebraic unknowns."""
        inputs = equations.compiled(input_parts)
        self._inputs = NumpyFunction(inputs)
        self.input_rows = np.argsort(order)[np.array(inputs.sparsity_out(0).row(), dtype=int)]
        """(D,): row of every input."""
        self._split(numeric(matrix)[order][:, own])
        own_rates = dense(self._ode_x) - self._ode_z @ self.eliminate(dense(self._by_states))
        self._modes = decoupled(own_rates, self._solver_of_shift, 1 / duration)
        if np.max(np.abs(self._modes.rates), initial=0.0) * duration > MAX_SPREAD:
            raise np.linalg.LinAlgError("flows through the widest tubes would lose energy")
        self.rates, self.shapes = self._modes.rates, self._modes.shapes
        """Rates of decay (n,) [1/s], and live states (live, n) of the modes."""
        self.idle_by = self._idle_sums()
        """(idle, live + nz): idle rows as combinations of the others."""
        unknowns = np.vstack([self.shapes, self.algebraics_of(self.shapes, 0.0)])
        moving, columns = (np.array(k, dtype=int) for k in inputs.sparsity_out(2).get_triplet())
        place = np.argsort(order)[columns]
        fixed = numeric(slopes)[:, own]
        self.quadratics = [
            QuadraticRate.of(
                unknowns,
                numeric(h)[own][:, own],
                dense(fixed[[k]])[0],
                place[moving == k],
                np.flatnonzero(moving == k),
            )
            for k, h in enumerate(hessians)
        ]

    def _split(self, matrix: Matrix) -> None:
        """``matrix``: derivatives of all rows by live states and algebraic unknowns."""
        count, size = len(self.live), len(self.live) + self.algebraics
        self._joined, self._idle_rows = matrix[:size], dense(matrix[size:])
        self._ode_x, self._ode_z = matrix[:count, :count], matrix[:count, count:]
        self._by_states = matrix[count:size, :count]
        self.eliminate = solver_of(matrix[count:size, count:])
        """(nz, m) -> algebraic unknowns of which the algebraic equations have that value."""

    def inputs_at(self, origin: np.ndarray, times: np.ndarray, pieces: np.ndarray) -> np.ndarray:
        """What depends on time alone (D + nq + k, N), at times (N,) in pieces (N, coefficients).

        The inputs, the quadratic rates at the origin (nx + nz,), and their derivatives there.
        """
        given = [[times], list(pieces.T), self.numbers.tolist(), origin.tolist()]
        return self._inputs(given, len(times))

    def input_terms(self, origin: np.ndarray) -> np.ndarray:
        """Sums (D,) of the sizes of the terms that the origin has in the inputs' rows."""
        size = len(self.live) + self.algebraics
        own = np.abs(origin[self.order[:size]])
        both = np.concatenate([abs(self._joined) @ own, abs(self._idle_rows) @ own])
        return np.asarray(both[self.input_rows])

    def algebraics_of(self, live: np.ndarray, values: np.ndarray | float) -> np.ndarray:
        """Algebraic unknowns (nz, m) at live states (live, m) and values of their rows (nz, m)."""
        return -self.eliminate(self._by_states @ live + values)

    def _solver_of_shift(self, shift: float) -> Solve:
        """Solves (shift - A) x = b for values of the live and algebraic rows.

        Without A itself, in which round-off of the fastest exchange hides the slowest.
        """
        count, size = len(self.live), len(self.live) + self.algebraics
        mass = np.where(np.arange(size) < count, shift, 0.0)
        solve = solver_of(diagonal_matrix(mass, like=self._joined) - self._joined)

        def solved(rows: np.ndarray) -> np.ndarray:
            padded = np.zeros((size, rows.shape[1]))
            padded[: len(rows)] = rows
            return solve(padded)[:count]

        self._shifted = solved
        return solved

    def drive(self, values: np.ndarray) -> np.ndarray:
        """How values of the live and algebraic rows (live + nz, m) drive the modes (n, m)."""
        if self._modes.shift:
            return self._modes.drive(self._shifted(values))
        count = len(self.live)
        return self._modes.drive(values[:count] - self._ode_z @ self.eliminate(values[count:]))

    def offsets(self, values: np.ndarray) -> np.ndarray:
        """Live states (zero) and algebraic unknowns (nw, m) that values of all rows add."""
        live, count = len(self.live), len(self.live) + self.algebraics
        return np.vstack([np.zeros((live, values.shape[1])), -self.eliminate(values[live:count])])

    def _idle_sums(self) -> np.ndarray:
        """Combinations of the live and algebraic rows that give the idle ones, apart from inputs.

        Integrals of the modes would give the same states, with less accuracy where tubes are wide.
        """
        found = np.zeros(self._idle_rows.shape)
        own = np.arange(len(self.live) + self.algebraics)
        if not np.all(self.rates):  # a part that is sealed keeps what it has: no row tells how much
            own = self._acting_on_idle()
        if len(own) and len(found):
            matrix, rows = self._joined[own][:, own].T, self._idle_rows[:, own].T
            solve = solver_of(matrix)
            sums = solve(rows)
            found[:, own] = (sums + solve(rows - matrix @ sums)).T
        if not np.isfinite(found).all():
            raise np.linalg.LinAlgError("idle states are not linear combinations of the others")
        return found

    def _acting_on_idle(self) -> np.ndarray:
        """Live and algebraic unknowns that act on idle states, at any remove."""
        rows, columns = self._joined.nonzero()
        reached = np.any(self._idle_rows != 0.0, axis=0)
        before = -1
        while (count := int(reached.sum())) > before:
            before = count
            reached[columns[reached[rows]]] = True
            reached[rows[reached[columns]]] = True
        return np.flatnonzero(reached)

    def idle_drive(self, values: np.ndarray) -> np.ndarray:
        """What values of all rows (rows, m) add to the idle states' rates beyond the combination
        of the others' (idle, m).
        """
        count = self.idle_by.shape[1]
        sums = values[count:] - self.idle_by @ values[:count]
        terms = np.abs(values[count:]) + np.abs(self.idle_by) @ np.abs(values[:count])
        return np.where(np.abs(sums) <= SUM_ROUND_OFF * terms, 0.0, sums)


def modal_system(equations: Equations, numbers: np.ndarray, duration: float) -> ModalSystem | None:
    """The modes of equations that are linear with constant coefficients, else None."""
    if equations.rod_form is not RodForm.ARCS or not equations.states.count:
        return None
    if not equations.compiled(linear_parts).n_out():
        return None
    try:
        return ModalSystem(equations, numbers, duration)
    except (np.linalg.LinAlgError, NotImplementedError):
        return None
