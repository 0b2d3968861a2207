"""Algebraic unknowns solved for with the states held."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from viscodesign.native.tables import Assembly

MAX_DENSE_ALGEBRAIC = 150
"""Algebraic unknowns up to which full matrices are the faster ones."""
ALGEBRAIC_TOL = 1e-9
"""Correction of algebraic unknowns, in their sizes, after which they count as solved: what it
leaves is its square, times how strongly the equations are curved.
"""
STIFF_ROUND_OFF = 1e-8
"""Correction that is round-off of stiff equations if it no longer gets smaller."""
LARGEST_LEFT = 0.75
"""Part of a correction that the next one may be, or it did not lead nearer."""
MAX_CORRECTIONS = 12

LinearSolve = Callable[..., np.ndarray]
"""Solution of a right side (nz, ...); ``transposed``: with the transposed matrix."""


class AlgebraicPart:
    """Rows and columns of a structure's Jacobian that hold no rates.

    Seldom solved, and with pivots: these equations alone may have none in the order that suits a
    step. ``mass`` (n,): 0 for algebraic rows; ``rows``, ``columns`` (nnz,): places of its entries.
    """

    def __init__(self, mass: np.ndarray, rows: np.ndarray, columns: np.ndarray) -> None:
        self.is_algebraic = mass == 0.0
        """(n,)"""
        self._count, place = int(np.sum(self.is_algebraic)), np.cumsum(self.is_algebraic) - 1
        self._kept = np.flatnonzero(self.is_algebraic[rows] & self.is_algebraic[columns])
        self._rows, self._columns = place[rows[self._kept]], place[columns[self._kept]]

    def solver(self, J: np.ndarray) -> LinearSolve:
        """Solves with entries J (nnz or more,). Raises `ZeroDivisionError` where it is singular."""
        values = J[self._kept]
        if not np.all(np.isfinite(values)):
            raise ZeroDivisionError("algebraic equations are not finite")
        if self._count > MAX_DENSE_ALGEBRAIC:
            return _sparse_solver(self._rows, self._columns, values, self._count)
        matrix = np.zeros((self._count, self._count))
        matrix[self._rows, self._columns] = values

        def solve(right: np.ndarray, *, transposed: bool) -> np.ndarray:
            try:
                return np.linalg.solve(matrix.T if transposed else matrix, right)
            except np.linalg.LinAlgError as error:
                raise ZeroDivisionError("algebraic equations are singular") from error

        return solve

    def steps(self, J: np.ndarray, residual: np.ndarray) -> np.ndarray:
        """Newton's steps (m, n) of m rows with entries J (m, nnz or more) and residuals (m, n).

        NaN where the equations are singular.
        """
        found, right = np.zeros(residual.shape), -residual[:, self.is_algebraic]
        if self._count > MAX_DENSE_ALGEBRAIC:
            for k, entries in enumerate(J):
                try:
                    found[k, self.is_algebraic] = self.solver(entries)(right[k], transposed=False)
                except ZeroDivisionError:
                    found[k] = np.nan
            return found
        matrices = np.zeros((len(J), self._count, self._count))
        matrices[:, self._rows, self._columns] = J[:, self._kept]
        found[:, self.is_algebraic] = solve_each(matrices, right)
        return found

    def corrected(self, assembly: Assembly, Y: np.ndarray) -> np.ndarray | None:
        """Unknowns (n,) from a guess in Y, whose drives are set, by Newton's steps.

        None where a step does not lead nearer: one that is damped may.
        """
        Y, before = Y.copy(), np.inf
        for _ in range(MAX_CORRECTIONS):
            try:
                solve = self.solver(assembly.jacobian(Y))
                step = solve(assembly.residual(Y)[self.is_algebraic], transposed=False)
            except ZeroDivisionError:
                return None
            size = float(np.max(np.abs(step), initial=0.0))
            is_round_off = size <= STIFF_ROUND_OFF and size > LARGEST_LEFT * before
            if not (size <= LARGEST_LEFT * before or is_round_off):
                return None
            if not is_round_off:
                Y[: assembly.unknowns][self.is_algebraic] -= step
            if size <= ALGEBRAIC_TOL or is_round_off:
                return Y[: assembly.unknowns]
            before = size
        return None


def solve_each(matrices: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solutions (m, n) of full matrices (m, n, n) and right sides (m, n); NaN where singular."""
    try:
        return np.asarray(np.linalg.solve(matrices, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        if len(matrices) == 1:
            return np.full(right.shape, np.nan)
    return np.concatenate(
        [solve_each(m[None], r[None]) for m, r in zip(matrices, right, strict=True)]
    )


def _sparse_solver(
    rows: np.ndarray, columns: np.ndarray, values: np.ndarray, count: int
) -> LinearSolve:
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import splu

    try:
        factors = splu(csc_matrix((values, (rows, columns)), (count, count)))
    except RuntimeError as error:  # raised for a singular matrix
        raise ZeroDivisionError("algebraic equations are singular") from error

    def solve(right: np.ndarray, *, transposed: bool) -> np.ndarray:
        if transposed:
            return np.asarray(factors.solve(right, "T"))  # type: ignore[call-overload]
        return np.asarray(factors.solve(right))

    return solve
