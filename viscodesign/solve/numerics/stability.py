"""Whether an equilibrium is at a minimum of its potential."""

from __future__ import annotations

import casadi as ca
import numpy as np

MAX_DENSE_UNKNOWNS = 150
"""Unknowns up to which full matrices are faster."""
MANY_AT_ONCE = 8
"""Jacobians from which the pivots of all of them are found side by side."""


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
        self._banded = _postponed(self._rows, self._columns, len(order))

    def is_stable(self, entries: np.ndarray) -> bool:
        """Whether the Jacobian with these nonzeros, column by column, is that of a minimum."""
        return bool(self.are_stable(entries[None])[0])

    def are_stable(self, entries: np.ndarray) -> np.ndarray:
        """The same (m,) of m Jacobians with nonzeros (m, nnz)."""
        data = self._signs[self._rows] * entries[:, self._own]
        if len(data) >= MANY_AT_ONCE:
            return self._are_stable_banded(data)
        is_small = len(self._signs) <= MAX_DENSE_UNKNOWNS
        is_stable = self._is_stable_dense if is_small else self._is_stable_sparse
        return np.array([is_stable(row) for row in data], dtype=bool)

    def _are_stable_banded(self, data: np.ndarray) -> np.ndarray:
        """By the signs of the pivots of all matrices side by side, in an order with a narrow band.

        A later place of an unknown that no earlier one touches changes no pivot.
        """
        rows, columns = self._banded[self._rows], self._banded[self._columns]
        count, width = len(self._signs), int(np.max(np.abs(rows - columns), initial=0))
        # Entries (j + d, j) and (j, j + d) are at (j, d); a margin of zeros follows.
        lower, upper = np.zeros((2, count + width, width + 1, len(data)))
        below, above = rows >= columns, rows <= columns
        lower[columns[below], (rows - columns)[below]] = data[:, below].T
        upper[rows[above], (columns - rows)[above]] = data[:, above].T
        far, near = np.tril_indices(width)
        signs = np.empty(count)
        signs[self._banded] = self._signs
        stable = np.ones(len(data), dtype=bool)
        with np.errstate(all="ignore"):  # a pivot of zero is not stable, whatever follows
            for j, sign in enumerate(signs):
                pivot, down, right = lower[j, 0], lower[j, 1:], upper[j, 1:]
                stable &= sign * pivot < 0.0
                scaled = right / pivot
                lower[j + 1 + near, far - near] -= down[far] * scaled[near]
                upper[j + 1 + near, far - near] -= down[near] * scaled[far]
        return stable

    def _is_stable_dense(self, data: np.ndarray) -> bool:
        """By Cholesky's factors of the reduced stiffness."""
        count = len(self._signs)
        matrix = np.zeros((count, count))
        matrix[self._rows, self._columns] = data
        inner, outer = self._internal, self._outer
        try:
            follow = np.linalg.solve(matrix[inner, inner.T], matrix[inner, outer.T])
            stiffness = matrix[outer, outer.T] - matrix[outer, inner.T] @ follow
            np.linalg.cholesky((stiffness + stiffness.T) / 2)
        except np.linalg.LinAlgError:
            return False
        return True

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


def _postponed(rows: np.ndarray, columns: np.ndarray, count: int) -> np.ndarray:
    """Places (n,) of unknowns that wait for their first neighbour, if none comes before them."""
    beside = rows != columns
    first = np.full(count, count)
    np.minimum.at(first, columns[beside], rows[beside])
    np.minimum.at(first, rows[beside], columns[beside])
    everyone = np.arange(count)
    order = np.argsort(np.where(first > everyone, first - 0.5, everyone), kind="stable")
    places = np.empty(count, dtype=int)
    places[order] = everyone
    return places
