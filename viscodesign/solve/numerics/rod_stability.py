"""Whether a static rod is at a minimum of its potential."""

from __future__ import annotations

import casadi as ca
import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from viscodesign.model.unknowns import Unknowns

MOST_FOR_FULL = 150
"""Unknowns up to which full matrices are faster."""


class Stiffness:
    """Judges a rod's equilibria by the Jacobians of its equations, all of one pattern.

    Stable: the stiffness is positive definite, the elastic curvature eliminated and pressures
    held. Then, of the mixed system's symmetric factors, every curvature has a negative pivot,
    every position a positive one. Each position stands after the three curvatures that it
    bends; so no pivot is near zero unless the stiffness is near singular, and none has to be
    searched for.
    """

    def __init__(self, unknowns: Unknowns, pattern: ca.Sparsity) -> None:
        order, bends = _along_the_rod(unknowns)
        place = np.full(pattern.size1(), -1)
        place[order] = np.arange(len(order))
        rows, columns = (place[np.array(k, dtype=int)] for k in pattern.get_triplet())
        own = np.flatnonzero((rows >= 0) & (columns >= 0))
        own = own[np.lexsort((rows[own], columns[own]))]
        self._own = own
        self._rows, self._columns = rows[own].astype(np.int32), columns[own]
        self._bends, self._places = (np.flatnonzero(k)[:, None] for k in (bends, ~bends))
        counts = np.bincount(columns[own], minlength=len(order))
        self._starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        # Compatibility is minus its own symmetric part, forces are minus a gradient.
        self._signs = np.where(bends, 1.0, -1.0)

    def is_stable(self, entries: np.ndarray) -> bool:
        """Whether the Jacobian with these nonzeros, column by column, is a stable one's."""
        data = self._signs[self._rows] * entries[self._own]
        few = len(self._signs) <= MOST_FOR_FULL
        return self._is_stable_full(data) if few else self._is_stable_sparse(data)

    def _is_stable_full(self, data: np.ndarray) -> bool:
        """The same for few unknowns, with the stiffness written out."""
        count = len(self._signs)
        matrix = np.zeros((count, count))
        matrix[self._rows, self._columns] = data
        bend, place = self._bends, self._places
        follow = np.linalg.solve(matrix[bend, bend.T], matrix[bend, place.T])
        stiffness = matrix[place, place.T] - matrix[place, bend.T] @ follow
        try:
            np.linalg.cholesky((stiffness + stiffness.T) / 2)
        except np.linalg.LinAlgError:
            return False
        return True

    def _is_stable_sparse(self, data: np.ndarray) -> bool:
        """The same by the signs of pivots."""
        count = len(self._signs)
        try:
            factors = splu(
                csc_matrix((data, self._rows, self._starts), shape=(count, count)),
                permc_spec="NATURAL",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:  # its word for a singular matrix
            return False
        plain = np.array_equal(factors.perm_r, np.arange(count))
        return plain and bool(np.all(self._signs * factors.U.diagonal() < 0.0))


def _along_the_rod(unknowns: Unknowns) -> tuple[np.ndarray, np.ndarray]:
    """The rod's unknowns from the clamp on (n,), and which of them are curvatures."""
    bend = unknowns.blocks["elastic_curvature"].span
    place = unknowns.blocks["position"].span
    edges = bend.stop - bend.start
    # A node's place turns the chords at itself and at both neighbours.
    after = np.minimum(np.arange(edges) + 2, edges - 1)
    key = np.concatenate([np.arange(edges), np.repeat(after, 2) + 0.5])
    every = np.concatenate([np.arange(bend.start, bend.stop), np.arange(place.start, place.stop)])
    order = np.argsort(key, kind="stable")
    return every[order], order < edges
