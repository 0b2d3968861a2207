"""Sparse LU without pivoting in an order that keeps the factors sparse."""

from __future__ import annotations

import numpy as np


class SparseLU:
    """Factors of matrices M s - J of one pattern, M diagonal.

    ``rows``, ``columns`` (nnz,): places of the entries of J (n, n). The order is by minimum
    degree; the diagonal always belongs to the pattern. A row without mass and without an own
    entry on the diagonal may turn out singular: `factor` says so.
    """

    def __init__(self, size: int, rows: np.ndarray, columns: np.ndarray) -> None:
        raise NotImplementedError

    def factor(self, entries: np.ndarray, mass: np.ndarray, scale: float) -> np.ndarray:
        """Factors of diag(mass) scale - J for J's entries (nnz,).

        Raises `ZeroDivisionError` at a pivot that is zero or not finite.
        """
        raise NotImplementedError

    def solve(self, factors: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Solution (n,) for a right side (n,)."""
        raise NotImplementedError
