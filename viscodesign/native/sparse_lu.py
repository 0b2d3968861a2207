"""Sparse LU without pivoting in an order that keeps the factors sparse."""

from __future__ import annotations

import numpy as np

from viscodesign.native.loops import DTYPES, Loops, native_loops

PLACES = DTYPES["places"]
FIRST_GUESS = 4
"""Entries of the factors over those of the matrix that are tried first."""


class SparseLU:
    """Factors of matrices diag(mass) scale - J of one pattern.

    ``rows``, ``columns`` (nnz,): places of the entries of J (n, n). The order is by minimum
    degree; the diagonal always belongs to the pattern. A row without mass and without an own
    entry on the diagonal may turn out singular: `factor` says so.
    """

    def __init__(
        self, size: int, rows: np.ndarray, columns: np.ndarray, *, loops: Loops | None = None
    ) -> None:
        self.loops = loops or native_loops()
        self.size, self.entries = size, len(rows)
        rows, columns = np.asarray(rows, dtype=np.int64), np.asarray(columns, dtype=np.int64)
        self.order = minimum_degree(size, rows, columns).astype(PLACES)
        """Unknowns in the order of their elimination (n,)."""
        turn = np.argsort(self.order)
        own = turn[rows] * size + turn[columns]
        self.lu_start, self.lu_columns, self.diagonal = self._pattern(own)
        """Rows of the factors: first entries (n + 1,), columns, entries of the diagonal (n,)."""
        lu_rows = np.repeat(np.arange(size), np.diff(self.lu_start))
        self.place = np.searchsorted(lu_rows * size + self.lu_columns, own).astype(PLACES)
        """Entries of the factors that those of J belong to (nnz,)."""

    @property
    def count(self) -> int:
        """Entries of the factors."""
        return len(self.lu_columns)

    def factor(self, entries: np.ndarray, mass: np.ndarray, scale: float) -> np.ndarray:
        """Factors of diag(mass) scale - J for J's entries (nnz,).

        Raises `ZeroDivisionError` at a pivot that is zero or not finite.
        """
        if len(entries) < self.entries or len(mass) != self.size:
            raise ValueError("needs all entries of J and the masses of all rows")
        lu = np.empty(self.count)
        own = (self.place, mass, scale, self.order, self.diagonal, lu)
        self.loops("lu_fill", self.size, self.count, self.entries, entries, *own)
        pattern = (self.lu_start, self.lu_columns, self.diagonal)
        failed = self.loops("lu_factor", self.size, *pattern, lu, np.empty(self.size))
        if failed:
            raise ZeroDivisionError(f"no pivot for unknown {self.order[failed - 1]}")
        return lu

    def solve(self, factors: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Solution (n,) for a right side (n,)."""
        if len(factors) != self.count or len(right) != self.size:
            raise ValueError("needs the factors of this pattern and one right side")
        solution = np.empty(self.size)
        pattern = (self.order, self.lu_start, self.lu_columns, self.diagonal)
        work = np.empty(self.size)
        self.loops("lu_solve", self.size, *pattern, factors, right, solution, work)
        return solution

    def _pattern(self, own: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows of the factors, for entries of J at row * size + column in order of elimination."""
        size = self.size
        keys = np.unique(np.concatenate([own, np.arange(size) * (size + 1)]))
        start = np.searchsorted(keys, np.arange(size + 1) * size).astype(PLACES)
        columns = (keys % size).astype(PLACES)
        lu_start, diagonal = np.zeros(size + 1, PLACES), np.zeros(size, PLACES)
        follow = np.zeros(size + 1, PLACES)
        capacity = FIRST_GUESS * len(keys)
        while True:
            lu_columns = np.empty(capacity, PLACES)
            result = (lu_start, lu_columns, diagonal, follow)
            count = self.loops("lu_pattern", size, start, columns, capacity, *result)
            if count >= 0:
                return lu_start, lu_columns[:count].copy(), diagonal
            capacity *= 2


def minimum_degree(size: int, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Order of the unknowns that keeps the factors sparse (SuperLU's, of A + A')."""
    import scipy.sparse as sparse
    from scipy.sparse.linalg import splu

    diagonal = np.arange(size)
    i = np.concatenate([rows, columns, diagonal])
    j = np.concatenate([columns, rows, diagonal])
    values = np.concatenate([np.full(2 * len(rows), -1e-3), np.full(size, float(size))])
    dominant = sparse.csc_matrix((values, (i, j)), shape=(size, size))
    return np.argsort(splu(dominant, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0).perm_c)
