"""Whether an equilibrium is at a minimum of its potential."""

from __future__ import annotations

import casadi as ca
import numpy as np

MAX_DENSE_UNKNOWNS = 150
"""Unknowns up to which full matrices are faster."""
DENSE_AT_ONCE = 64
"""Full matrices that are factorised in one call: a small one takes less time than a call."""


class StabilityTest:
    """Judges equilibria by the Jacobians of their equations, all of one pattern.

    Stable: the stiffness is positive definite once the internal unknowns are eliminated, with
    all other unknowns held. Then, of the mixed system's symmetric factors, every internal
    unknown has a negative pivot, every coordinate a positive one.

    ``order`` (n,): rows of the coordinates and internal unknowns in an order of elimination that
    needs no pivoting; ``internal`` (n,): which of them are internal. Their equations are minus
    the gradient of the potential by a coordinate, and plus that by an internal unknown.
    """

    def __init__(self, order: np.ndarray, internal: np.ndarray, pattern: ca.Sparsity) -> None:
        place = np.full(pattern.size1(), -1)
        place[order] = np.arange(len(order))
        rows, columns = (place[np.array(k, dtype=int)] for k in pattern.get_triplet())
        own = np.flatnonzero((rows >= 0) & (columns >= 0))
        own = own[np.lexsort((rows[own], columns[own]))]
        self._own = own
        self._rows, self._columns = rows[own].astype(np.int32), columns[own]
        self._internal, self._outer = (np.flatnonzero(k)[:, None] for k in (internal, ~internal))
        counts = np.bincount(columns[own], minlength=len(order))
        self._starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        self._signs = np.where(internal, 1.0, -1.0)

    def is_stable(self, entries: np.ndarray) -> bool:
        """Whether the Jacobian with these nonzeros, column by column, is that of a minimum."""
        return bool(self.are_stable(entries[None])[0])

    def are_stable(self, entries: np.ndarray) -> np.ndarray:
        """The same (m,) of m Jacobians with nonzeros (m, nnz)."""
        data = self._signs[self._rows] * entries[:, self._own]
        if len(self._signs) > MAX_DENSE_UNKNOWNS:
            return np.array([self._is_stable_sparse(row) for row in data], dtype=bool)
        found = np.zeros(len(data), dtype=bool)
        for begin in range(0, len(data), DENSE_AT_ONCE):
            some = slice(begin, begin + DENSE_AT_ONCE)
            found[some] = self._are_stable_dense(data[some])
        return found

    def _are_stable_dense(self, data: np.ndarray) -> np.ndarray:
        """By Cholesky's factors of the reduced stiffness."""
        count = len(self._signs)
        matrix = np.zeros((len(data), count, count))
        matrix[:, self._rows, self._columns] = data
        inner, outer = self._internal, self._outer
        try:
            follow = np.linalg.solve(matrix[:, inner, inner.T], matrix[:, inner, outer.T])
            stiffness = matrix[:, outer, outer.T] - matrix[:, outer, inner.T] @ follow
            np.linalg.cholesky((stiffness + stiffness.transpose(0, 2, 1)) / 2)
        except np.linalg.LinAlgError:  # raised for all of them if one has no such factors
            if len(data) == 1:
                return np.zeros(1, dtype=bool)
            half = len(data) // 2
            parts = [self._are_stable_dense(part) for part in (data[:half], data[half:])]
            return np.concatenate(parts)
        return np.ones(len(data), dtype=bool)

    def _is_stable_sparse(self, data: np.ndarray) -> bool:
        """By the signs of the pivots."""
        from scipy.sparse import csc_matrix
        from scipy.sparse.linalg import splu

        count = len(self._signs)
        try:
            factors = splu(
                csc_matrix((data, self._rows, self._starts), shape=(count, count)),
                permc_spec="NATURAL",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # raised for a singular matrix
            return False
        unpermuted = np.array_equal(factors.perm_r, np.arange(count))
        return unpermuted and bool(np.all(self._signs * factors.U.diagonal() < 0.0))
