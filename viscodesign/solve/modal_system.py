"""Linear equations with constant coefficients, in their modes.

Whether equations are of this kind is read from their formulas, whatever effects these are made
of: all derivatives by the unknowns are free of unknowns, time and inputs. States that nothing
depends on, such as the volume delivered, follow from the others and from integrals of inputs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.model.equations import Equations, Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.numerics.by_numpy import NumpyFunction
from viscodesign.solve.numerics.decoupling import decoupled

MAX_SPREAD = 1e8
"""Fastest rate over that of the run up to which modes are taken: the energy balance loses digits
with flows through wide tubes, which are differences of nearly equal pressures."""

SX = ca.SX
Matrix = Any
"""A dense array, or a sparse matrix of SciPy."""
Solve = Callable[[np.ndarray], np.ndarray]
MAX_DENSE = 200
"""Unknowns up to which matrices are factored densely."""
ROUND_OFF = 1e-13
"""Part of the terms of a sum below which the sum is round-off."""


class ModalSystem:
    """The equations of one scene in their modes.

    Rows: the equations of the live states, on which others depend, then the algebraic ones, then
    those of the idle states. Everything is told as a departure from an origin, the unknowns at some
    instant: in equilibrium the rows are exactly zero there, and stay so. Inputs are the values of
    the D rows that depend on time, at the origin.

    Raises `numpy.linalg.LinAlgError` where the modes are not found.
    """

    def __init__(self, equations: Equations, numbers: np.ndarray, duration: float) -> None:
        parts = equations.compiled(_linear_parts)
        matrix, slopes, *hessians = parts.call([numbers])
        self.numbers = numbers
        self.live, self.idle = _live_and_idle(parts.sparsity_out(0), equations.states.count)
        self.algebraics = equations.algebraics.count
        own = np.concatenate([self.live, equations.states.count + np.arange(self.algebraics)])
        self.order = order = np.concatenate([own, self.idle]).astype(int)
        """Of the rows, and of their unknowns: place among states and algebraic unknowns."""
        inputs = equations.compiled(_inputs)
        self._inputs = NumpyFunction(inputs)
        self.input_rows = np.argsort(order)[np.array(inputs.sparsity_out(0).row(), dtype=int)]
        """(D,): row of every input."""
        self._split(_numeric(matrix)[order][:, own])
        own_rates = _dense(self._ode_x) - self._ode_z @ self.eliminate(_dense(self._by_states))
        self._modes = decoupled(own_rates, self._solver_of_shift, 1 / duration)
        if np.max(np.abs(self._modes.rates), initial=0.0) * duration > MAX_SPREAD:
            raise np.linalg.LinAlgError("flows through the widest tubes would lose energy")
        self.rates, self.shapes = self._modes.rates, self._modes.shapes
        """Of decay (n,) [1/s]; live states (live, n) of the modes."""
        self.idle_by = self._idle_sums()
        """(idle, live + nz): idle rows as combinations of the others."""
        unknowns = np.vstack([self.shapes, self.algebraics_of(self.shapes, 0.0)])
        moving, columns = (np.array(k, dtype=int) for k in inputs.sparsity_out(2).get_triplet())
        place = np.argsort(order)[columns]
        fixed = _numeric(slopes)[:, own]
        self.quadratics = [
            QuadraticRate.of(
                unknowns,
                _numeric(h)[own][:, own],
                _dense(fixed[[k]])[0],
                place[moving == k],
                np.flatnonzero(moving == k),
            )
            for k, h in enumerate(hessians)
        ]

    def _split(self, matrix: Matrix) -> None:
        """``matrix``: derivatives of all rows by live states and algebraic unknowns."""
        count, size = len(self.live), len(self.live) + self.algebraics
        self._joined, self._idle_rows = matrix[:size], _dense(matrix[size:])
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
        solve = solver_of(_diagonal(mass, like=self._joined) - self._joined)

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
            raise np.linalg.LinAlgError("idle states are no sums of the others")
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
        return np.where(np.abs(sums) <= ROUND_OFF * terms, 0.0, sums)


@dataclass(frozen=True)
class QuadraticRate:
    """A rate start(t) + slopes(t) w + w hessian w / 2, in w = unknowns y + offsets s.

    w (nw,): live states and algebraic unknowns; y (n,): modes; s (S,): signals, the first is one.
    """

    unknowns: np.ndarray
    """(nw, n)"""
    own: np.ndarray
    """(n, n), or its diagonal (n,) where no two modes act together; empty for none."""
    bent: np.ndarray
    """(nw, n): hessian unknowns."""
    hessian: Matrix
    fixed: np.ndarray
    """(nw,): slopes at zero unknowns that do not depend on time."""
    moving: np.ndarray
    """(k,): unknowns whose slopes depend on time, ..."""
    slope_rows: np.ndarray
    """(k,): ... and where those stand among the slopes of all rates."""

    @classmethod
    def of(
        cls,
        unknowns: np.ndarray,
        hessian: Matrix,
        fixed: np.ndarray,
        moving: np.ndarray,
        slope_rows: np.ndarray,
    ) -> QuadraticRate:
        """With what follows from all modes computed."""
        bent = np.asarray(hessian @ unknowns)
        own = unknowns.T @ bent
        diagonal = np.diag(own).copy()
        coupling = np.max(np.abs(own - np.diag(diagonal)), initial=0.0)
        if coupling <= ROUND_OFF * np.max(np.abs(diagonal), initial=0.0):
            own = diagonal if diagonal.any() else np.zeros(0)
        return cls(unknowns, own, bent, hessian, fixed, moving, slope_rows)

    def fixed_slopes(self, origin: np.ndarray) -> np.ndarray:
        """Slopes at an origin (nw,) that do not depend on time (nw,)."""
        found = self.fixed + self.hessian @ origin
        found[self.moving] = 0.0
        return np.asarray(found)

    def values(
        self,
        start: np.ndarray,
        slopes: np.ndarray,
        fixed: np.ndarray,
        offsets: np.ndarray,
        signals: np.ndarray,
        modes: np.ndarray,
    ) -> np.ndarray:
        """The rate at N instants (N,).

        ``start`` (N,), ``slopes`` (k, N) and ``fixed`` (nw,), which do not depend on time;
        ``offsets`` (nw, S), ``signals`` (S, N), ``modes`` (n, N).
        """
        cross = offsets.T @ self.bent
        cross[0] += fixed @ self.unknowns
        squares = offsets.T @ np.asarray(self.hessian @ offsets) / 2
        squares[0] += fixed @ offsets
        found = start + np.einsum("sn,sn->n", signals, squares @ signals + cross @ modes)
        if len(slopes):
            along, beside = self.unknowns[self.moving], offsets[self.moving]
            found = found + np.einsum("kn,kn->n", slopes, beside @ signals + along @ modes)
        if self.own.ndim == 2:
            found = found + np.einsum("mn,mn->n", self.own @ modes, modes) / 2
        elif self.own.size:
            found = found + (self.own / 2) @ (modes * modes)
        return np.asarray(found.real)


def _live_and_idle(pattern: ca.Sparsity, states: int) -> tuple[np.ndarray, np.ndarray]:
    """States on which any row depends, and the others."""
    used = np.diff(np.array(pattern.colind())[: states + 1]) > 0
    return np.flatnonzero(used), np.flatnonzero(~used)


def _numeric(matrix: ca.DM) -> Matrix:
    """Dense, or sparse where it is large."""
    if max(matrix.shape) <= MAX_DENSE:
        return np.asarray(matrix.full())
    return matrix.sparse()


def _dense(matrix: Matrix) -> np.ndarray:
    return matrix if isinstance(matrix, np.ndarray) else np.asarray(matrix.toarray())


def _diagonal(values: np.ndarray, like: Matrix) -> Matrix:
    if isinstance(like, np.ndarray):
        return np.diag(values)
    from scipy.sparse import diags

    return diags(values, format="csc")


def solver_of(matrix: Matrix) -> Solve:
    """Solves matrix x = b for many right-hand sides (n, m); raises `LinAlgError` if singular."""
    if isinstance(matrix, np.ndarray):
        diagonal = np.diag(matrix)
        if np.count_nonzero(matrix) == np.count_nonzero(diagonal) == len(diagonal):
            return lambda rhs: np.asarray(rhs / diagonal[:, None])
        inverse = np.linalg.inv(matrix)
        return lambda rhs: np.asarray(inverse @ rhs)
    from scipy.sparse.linalg import splu

    try:
        factors = splu(matrix.tocsc())
    except RuntimeError as error:  # raised for a singular matrix
        raise np.linalg.LinAlgError(str(error)) from error
    return lambda rhs: np.asarray(factors.solve(np.ascontiguousarray(rhs)))


def modal_system(equations: Equations, numbers: np.ndarray, duration: float) -> ModalSystem | None:
    """The modes of equations that are linear with constant coefficients, else None."""
    if equations.rod_form is not RodForm.ARCS or not equations.states.count:
        return None
    if not equations.compiled(_linear_parts).n_out():
        return None
    try:
        return ModalSystem(equations, numbers, duration)
    except (np.linalg.LinAlgError, NotImplementedError):
        return None


def _linear_parts(e: Formulas) -> ca.Function:
    """numbers -> derivatives of the rows by the unknowns; the rates' slopes at zero unknowns,
    where these do not depend on time; their second derivatives.

    A function of no results where the equations are not linear.
    """
    none = ca.Function("linear", [e.parameters], [])
    unknowns, clock, rows = _symbols(e)
    if any(ca.which_depends(rows, unknowns, 2, True)):
        return none
    matrix, slopes = jacobian(rows, unknowns), jacobian(e.quadrature, unknowns)
    hessians = [ca.jacobian(slopes[k, :].T, unknowns) for k in range(slopes.size1())]
    _, idle = _live_and_idle(matrix.sparsity(), e.states.count)
    varies = ca.depends_on(ca.veccat(matrix, *hessians), ca.vertcat(unknowns, clock))
    if varies or (len(idle) and ca.depends_on(e.quadrature, unknowns[idle.tolist()])):
        return none
    zero = ca.substitute([slopes], [unknowns], [SX.zeros(unknowns.shape)])[0]
    return ca.Function("linear", [e.parameters], [matrix, _parted(zero, clock)[0], *hessians])


def _inputs(e: Formulas) -> ca.Function:
    """(time, pieces, numbers, unknowns) -> what depends on time of rows and slopes; all rates."""
    unknowns, clock, rows = _symbols(e)
    slopes = jacobian(e.quadrature, unknowns)
    results = [_parted(rows, clock)[1], ca.densify(e.quadrature), _parted(slopes, clock)[1]]
    given = [e.time, e.pieces, e.parameters, unknowns]
    return ca.Function("inputs", given, ca.cse(results))


def _symbols(e: Formulas) -> tuple[SX, SX, SX]:
    """Unknowns, time with all coefficients of inputs, and rows."""
    unknowns = ca.vertcat(e.states.vector, e.algebraics.vector)
    return unknowns, ca.vertcat(e.time, e.pieces), ca.vertcat(e.ode, e.alg)


def _parted(values: SX, clock: SX) -> tuple[SX, SX]:
    """The entries that do not depend on time, and those that do, each sparse."""
    values = ca.sparsify(values)
    parts = []
    entries = values.nz[:] if values.nnz() else SX(0, 1)
    depends = np.array(ca.which_depends(entries, clock, 1, True), dtype=bool)
    rows, columns = (np.array(k, dtype=int) for k in values.sparsity().get_triplet())
    for own in (~depends, depends):
        chosen = np.flatnonzero(own)
        pattern = ca.Sparsity.triplet(
            *values.shape, rows[chosen].tolist(), columns[chosen].tolist()
        )
        parts.append(SX(pattern, entries[chosen.tolist()]) if len(chosen) else SX(*values.shape))
    return parts[0], parts[1]
