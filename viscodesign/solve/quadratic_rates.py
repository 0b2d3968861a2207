"""Rates that are quadratic in the unknowns of linear equations: powers of the energy balance."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.numerics.dense_or_sparse import Matrix

SUM_ROUND_OFF = 1e-13
"""Part of the terms of a sum below which the sum is round-off."""


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
        if coupling <= SUM_ROUND_OFF * np.max(np.abs(diagonal), initial=0.0):
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
