"""Sparse LU written out as straight-line formulas, with pivots on the diagonal.

For a system that is solved thousands of times with one pattern, formulas without any
search or index cost a third of a general sparse solver. Pivots on the diagonal suit
the matrices of a step of an implicit method, which have masses, compliances and
stiffnesses there.

CasADi's own symbolic factorisations do not replace it: for the system of a step of the paper's
leg, ``qr_sparse`` needs 41,325 operations, this elimination 10,922. SuperLU (through SciPy)
only gives the order of the unknowns, since its factors are numbers.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX


def has_whole_diagonal(pattern: ca.Sparsity) -> bool:
    """Whether no diagonal entry of a square pattern is structurally zero."""
    rows, columns = (np.array(k, dtype=int) for k in pattern.get_triplet())
    return int(np.sum(rows == columns)) == pattern.size1()


class SymbolicLU:
    """Factors and solutions of matrices of one pattern.

    ``pattern``: of a square matrix without structural zeros on the diagonal.
    Raises `ValueError` where there is one.
    """

    def __init__(self, pattern: ca.Sparsity) -> None:
        size = pattern.size1()
        rows, columns = (np.array(k, dtype=int) for k in pattern.get_triplet())
        if not has_whole_diagonal(pattern):
            raise ValueError("a diagonal entry is structurally zero")
        self.pattern = pattern
        order = _minimum_degree(size, rows, columns)
        place = np.argsort(order)
        self._order = order.tolist()
        self._fill = _Fill.of(size, place[rows], place[columns])
        # Indices of the matrix's own entries among those of its factors.
        self._own = [
            self._fill.index[pair]
            for pair in zip(place[rows].tolist(), place[columns].tolist(), strict=True)
        ]
        self.solution = self._solution()

    def factors(self, matrix: SX) -> SX:
        """Entries of L (without its unit diagonal) and U as one column."""
        values = SX.zeros(self._fill.count)
        values[self._own] = matrix.nz[:]
        for pivot in self._fill.pivots:
            if not pivot.lower:
                continue
            multipliers = values[pivot.lower] / values[pivot.diagonal]
            values[pivot.lower] = multipliers
            if pivot.upper:
                products = ca.vec(multipliers @ values[pivot.upper].T)
                values[pivot.targets] = values[pivot.targets] - products
        return values

    def _solution(self) -> ca.Function:
        """(factors, right side) -> solution."""
        count = len(self._order)
        factors, right = SX.sym("factors", self._fill.count), SX.sym("right", count)
        y = right[self._order]
        for k, pivot in enumerate(self._fill.pivots):
            if pivot.lower:
                y[pivot.rows] = y[pivot.rows] - factors[pivot.lower] * y[k]
        for k in reversed(range(count)):
            pivot = self._fill.pivots[k]
            rest = ca.dot(factors[pivot.upper], y[pivot.rows_upper]) if pivot.upper else SX(0)
            y[k] = (y[k] - rest) / factors[pivot.diagonal]
        solution = SX.zeros(count)
        solution[self._order] = y
        return ca.Function("solution", [factors, right], [solution])


@dataclass(frozen=True)
class _Pivot:
    """One step of the elimination; indices into the factors' entries, and into the unknowns."""

    diagonal: int
    lower: list[int]
    upper: list[int]
    rows: list[int]
    rows_upper: list[int]
    targets: list[int]
    """Entries that the product of lower and upper changes, column by column."""


@dataclass(frozen=True)
class _Fill:
    """Entries of the factors, fill-in included."""

    index: dict[tuple[int, int], int]
    pivots: list[_Pivot]

    @property
    def count(self) -> int:
        return len(self.index)

    @staticmethod
    def of(size: int, rows: np.ndarray, columns: np.ndarray) -> _Fill:
        below: list[set[int]] = [set() for _ in range(size)]
        right: list[set[int]] = [set() for _ in range(size)]
        for i, j in zip(rows.tolist(), columns.tolist(), strict=True):
            if i > j:
                below[j].add(i)
            elif j > i:
                right[i].add(j)
        for k in range(size):
            for i in below[k]:
                right[i].update(j for j in right[k] if j > i)
            for j in right[k]:
                below[j].update(i for i in below[k] if i > j)
        index: dict[tuple[int, int], int] = {}
        for k in range(size):
            for pair in ((k, k), *((i, k) for i in sorted(below[k]))):
                index.setdefault(pair, len(index))
            for j in sorted(right[k]):
                index.setdefault((k, j), len(index))
        pivots = [_Fill._pivot(k, sorted(below[k]), sorted(right[k]), index) for k in range(size)]
        return _Fill(index, pivots)

    @staticmethod
    def _pivot(
        k: int, below: list[int], right: list[int], index: dict[tuple[int, int], int]
    ) -> _Pivot:
        return _Pivot(
            diagonal=index[k, k],
            lower=[index[i, k] for i in below],
            upper=[index[k, j] for j in right],
            rows=below,
            rows_upper=right,
            targets=[index[i, j] for j in right for i in below],
        )


def _minimum_degree(size: int, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Order of the unknowns that keeps the factors sparse (SuperLU's, of A + A')."""
    from scipy.sparse import csc_matrix
    from scipy.sparse.linalg import splu

    diagonal = np.arange(size)
    i = np.concatenate([rows, columns, diagonal])
    j = np.concatenate([columns, rows, diagonal])
    values = np.concatenate([np.full(2 * len(rows), -1e-3), np.full(size, float(size))])
    dominant = csc_matrix((values, (i, j)), shape=(size, size))
    return np.argsort(splu(dominant, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0).perm_c)
