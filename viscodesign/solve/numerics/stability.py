"""Whether an equilibrium is at a minimum of its potential."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.native.loops import DTYPES, native_loops
from viscodesign.native.machine import this_machine
from viscodesign.native.unavailable import NativeUnavailable


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
        self._own = np.flatnonzero((rows >= 0) & (columns >= 0))
        rows, columns = rows[self._own], columns[self._own]
        signs = np.where(internal, 1.0, -1.0)
        self._factors = signs[rows]
        places = _postponed(rows, columns, len(order))
        self._signs = np.empty(len(order))
        self._signs[places] = signs
        rows, columns = places[rows], places[columns]
        self._width = int(np.max(np.abs(rows - columns), initial=0))
        self._bands = _in_band(rows, columns, self._width), _in_band(columns, rows, self._width)

    def is_stable(self, entries: np.ndarray) -> bool:
        """Whether the Jacobian with these nonzeros, column by column, is that of a minimum."""
        return bool(self.are_stable(entries[None])[0])

    def are_stable(self, entries: np.ndarray) -> np.ndarray:
        """The same (m,) of m Jacobians with nonzeros (m, nnz).

        By the signs of the pivots, in an order with a narrow band.
        """
        data = self._factors * entries[:, self._own]
        try:
            return self._by_loop(data)
        except NativeUnavailable:
            return self._side_by_side(data)

    def _by_loop(self, data: np.ndarray) -> np.ndarray:
        """Natively. Raises `NativeUnavailable`."""
        this_machine()  # code that was made before may have been switched off
        count, (matrices, entries) = len(self._signs), data.shape
        band = np.empty(2 * (count + self._width) * (self._width + 1))
        found = np.empty(matrices, dtype=DTYPES["counts"])
        given = matrices, entries, count, self._width, *self._bands, self._signs
        native_loops()("have_signs", *given, data.reshape(-1), band, found)
        return np.asarray(found == 1)

    def _side_by_side(self, data: np.ndarray) -> np.ndarray:
        """The same of all matrices at once."""
        count, width = len(self._signs), self._width
        # Entries (j + d, j) and (j, j + d) are at (j, d); a margin of zeros follows.
        both = np.zeros((2, (count + width) * (width + 1), len(data)))
        for side, places in zip(both, self._bands, strict=True):
            side[places[places >= 0]] = data[:, places >= 0].T
        lower, upper = both.reshape(2, count + width, width + 1, len(data))
        far, near = np.tril_indices(width)
        stable = np.ones(len(data), dtype=bool)
        with np.errstate(all="ignore"):  # a pivot of zero is not stable, whatever follows
            for j, sign in enumerate(self._signs):
                pivot, down, right = lower[j, 0], lower[j, 1:], upper[j, 1:]
                stable &= sign * pivot < 0.0
                scaled = right / pivot
                lower[j + 1 + near, far - near] -= down[far] * scaled[near]
                upper[j + 1 + near, far - near] -= down[near] * scaled[far]
        return stable


def _in_band(rows: np.ndarray, columns: np.ndarray, width: int) -> np.ndarray:
    """Places (nnz,) of entries in a band below the diagonal, column by column; -1 above it."""
    places = columns * (width + 1) + rows - columns
    return np.where(rows >= columns, places, -1).astype(DTYPES["places"])


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
