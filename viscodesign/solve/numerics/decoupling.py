"""A constant matrix in its modes.

Exchange between stores is symmetric once every store is scaled: then the modes are orthogonal,
and nothing is lost however close two of them are. Other matrices have modes as well, which are
used where they are well separated.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from viscodesign.lazy_dataclass import dataclass

Solve = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class DecouplingLimits:
    """Which matrices are taken, and how exactly."""

    symmetry: float = 1e-10
    """Departure from symmetry, over the largest entry, that is round-off of an elimination."""
    max_unsymmetric: int = 200
    """Size up to which matrices without symmetry are taken: they take thirty times longer."""
    max_condition: float = 1e4
    """Largest condition number of the modes of such a matrix: it grows where two of them nearly
    coincide."""
    max_spread: float = 1e6
    """Fastest rate over that of the run from which slow modes are found by the inverse: by the
    matrix itself, their rates have errors of round-off times the fastest one."""
    most_spread: float = 1e11
    """The same up to which matrices are taken: exchange at such a rate is a difference of nearly
    equal values, and loses as many digits."""
    growth: float = 1e-10
    """Rate of growth, over the fastest rate, that is round-off."""


LIMITS = DecouplingLimits()
GROWS = "a mode grows"


@dataclass(frozen=True)
class Modes:
    """Modes of dx/dt = A x + b: x = shapes y, dy/dt = -rates y + drive(b)."""

    rates: np.ndarray
    """(n,), real or complex [1/s]."""
    shapes: np.ndarray
    """(n, n)"""
    inverse: np.ndarray
    """(n, n): y = inverse x."""
    shift: float = 0.0
    """With one, ``b`` acts through (shift - A)^-1 b, which keeps the digits of slow modes."""

    def drive(self, value: np.ndarray) -> np.ndarray:
        """How b (n, m) acts on the modes; with a shift, given (shift - A)^-1 b."""
        found = self.inverse @ value
        return np.asarray((self.rates + self.shift)[:, None] * found if self.shift else found)


def decoupled(matrix: np.ndarray, shifted: Callable[[float], Solve], rate: float) -> Modes:
    """The modes of a matrix (n, n).

    Raises `numpy.linalg.LinAlgError` where they are too inaccurate, or grow.

    ``shifted``: makes a solver of (shift - A) x = b. ``rate``: the slowest of interest, that of
    the run.
    """
    size = balancing(matrix)
    if size is None:
        return _general(matrix, rate)
    balanced = matrix * size / size[:, None]
    balanced = (balanced + balanced.T) / 2
    found, vectors = np.linalg.eigh(-balanced)
    if found[-1] > LIMITS.most_spread * rate:
        raise np.linalg.LinAlgError("flows through the widest tubes would be round-off")
    shift = 0.0
    if found[-1] > LIMITS.max_spread * rate:
        shift = rate
        inverse = shifted(shift)(np.eye(len(matrix))) * size / size[:, None]
        largest, vectors = np.linalg.eigh((inverse + inverse.T) / 2)
        largest, vectors = largest[::-1], vectors[:, ::-1]
        if largest[-1] <= 0.0:
            raise np.linalg.LinAlgError(GROWS)
        slow = 1 / largest - shift
        direct = -np.einsum("ik,ij,jk->k", vectors, balanced, vectors, optimize=True)
        found = np.where(slow > np.sqrt(shift * abs(direct[-1])), direct, slow)
    if found.min() < -LIMITS.growth * max(found.max(), rate):
        raise np.linalg.LinAlgError(GROWS)
    exact = 4 * len(matrix) * np.finfo(float).eps * (shift or found.max())
    rates = np.where(found <= exact, 0.0, found)
    return Modes(rates, size[:, None] * vectors, vectors.T / size, shift)


def balancing(matrix: np.ndarray) -> np.ndarray | None:
    """Sizes d (n,) that make A_ij d_j/d_i symmetric; None where there are none."""
    size = np.ones(len(matrix))
    if not _is_symmetric(matrix):
        seen = np.zeros(len(matrix), dtype=bool)
        for root in range(len(matrix)):
            if seen[root]:
                continue
            seen[root], front = True, [root]
            while front:
                i = front.pop()
                near = np.flatnonzero((matrix[i] * matrix[:, i] > 0.0) & ~seen)
                size[near] = size[i] * np.sqrt(matrix[near, i] / matrix[i, near])
                seen[near] = True
                front += near.tolist()
        if not np.isfinite(size).all() or not _is_symmetric(matrix * size / size[:, None]):
            return None
    return size


def _is_symmetric(matrix: np.ndarray) -> bool:
    apart = np.max(np.abs(matrix - matrix.T), initial=0.0)
    return bool(apart <= LIMITS.symmetry * np.max(np.abs(matrix), initial=0.0))


def _general(matrix: np.ndarray, rate: float) -> Modes:
    if len(matrix) > LIMITS.max_unsymmetric:
        raise np.linalg.LinAlgError("too many states without symmetry")
    found, vectors = np.linalg.eig(matrix)
    rates = -found
    fastest = np.max(np.abs(rates))
    if fastest > LIMITS.max_spread * rate:
        raise np.linalg.LinAlgError("slow modes would be round-off")
    if np.linalg.cond(vectors) > LIMITS.max_condition:
        raise np.linalg.LinAlgError("two modes nearly coincide")
    if rates.real.min() < -LIMITS.growth * fastest:
        raise np.linalg.LinAlgError(GROWS)
    rates = np.where(rates.real > 0.0, rates, rates - rates.real)
    return Modes(rates, vectors, np.linalg.inv(vectors))
