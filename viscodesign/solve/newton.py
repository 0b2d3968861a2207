"""Damped Newton on sparse systems, and continuation from an easy problem to the real one."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import casadi as ca
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla

Residual = Callable[[np.ndarray], tuple[np.ndarray, ca.DM]]
Family = Callable[[np.ndarray, float], tuple[np.ndarray, ca.DM]]

CONVERGED = 1e-11
"""Residual, in sizes of the equations' terms, from which quadratic convergence finishes it."""
MAX_ITERATIONS = 40
SMALLEST_STEP = 1.0 / 1024


class NewtonError(Exception):
    """Newton's iteration came to a stop short of a solution.

    ``residual``: largest defect, in sizes of the terms; ``worst``: its index;
    ``reached``: load factor that continuation came to.
    """

    def __init__(self, residual: float, worst: int, reached: float = 0.0) -> None:
        super().__init__(f"defect {residual:.2g} at {worst}, load factor {reached:.3g}")
        self.residual = residual
        self.worst = worst
        self.reached = reached


def newton(function: Residual, start: np.ndarray) -> np.ndarray:
    """Solve function(y) = 0 from ``start`` (n,), dimensionless.

    Raises `NewtonError` where the defect cannot be reduced.
    """
    y = start.copy()
    residual, jacobian = function(y)
    size = _norm(residual)
    for _ in range(MAX_ITERATIONS):
        if size == 0.0:
            return y
        step = _solve(jacobian, residual)
        y, residual, jacobian, new_size = _advance(function, y, step, size)
        if new_size <= CONVERGED and new_size >= 0.5 * size:
            return y  # nothing left but round-off
        if new_size <= 1e-14:
            return y
        size = new_size
    if size <= CONVERGED:
        return y
    raise NewtonError(size, int(np.argmax(np.abs(residual))))


def _advance(
    function: Residual, y: np.ndarray, step: np.ndarray, size: float
) -> tuple[np.ndarray, np.ndarray, ca.DM, float]:
    """Take the largest of the halved steps that reduces the defect."""
    fraction = 1.0
    while True:
        trial = y - fraction * step
        residual, jacobian = function(trial)
        new_size = _norm(residual)
        if new_size < (1 - 0.1 * fraction) * size or size <= CONVERGED:
            return trial, residual, jacobian, new_size
        fraction /= 2
        if fraction < SMALLEST_STEP:
            raise NewtonError(size, int(np.argmax(np.abs(residual))))


def continuation(family: Family, start: np.ndarray) -> np.ndarray:
    """Follow family(y, s) = 0 from ``start`` at s = 0 to s = 1, as fast as Newton allows.

    Raises `NewtonError` with the load factor reached, where the branch ends.
    """
    y, reached, step = start, 0.0, 1.0
    previous: tuple[np.ndarray, float] | None = None
    while reached < 1.0:
        target = min(1.0, reached + step)
        guess = y if previous is None else _extrapolate(previous, (y, reached), target)
        try:
            found = newton(partial(_at, family, target), guess)
        except NewtonError as failure:
            step /= 2
            if step < SMALLEST_STEP:
                raise NewtonError(failure.residual, failure.worst, reached) from failure
            continue
        previous, y, reached = (y, reached), found, target
        step *= 2
    return y


def _at(family: Family, load: float, y: np.ndarray) -> tuple[np.ndarray, ca.DM]:
    return family(y, load)


def _extrapolate(
    before: tuple[np.ndarray, float], now: tuple[np.ndarray, float], target: float
) -> np.ndarray:
    slope = (now[0] - before[0]) / (now[1] - before[1])
    return np.asarray(now[0] + slope * (target - now[1]))


def _solve(jacobian: ca.DM, residual: np.ndarray) -> np.ndarray:
    matrix = to_scipy(jacobian)
    try:
        step = spla.splu(matrix).solve(residual)
    except RuntimeError:  # SuperLU's word for an exactly singular matrix
        step = np.full_like(residual, np.nan)
    if not np.all(np.isfinite(step)):
        raise NewtonError(_norm(residual), int(np.argmax(np.abs(residual))))
    return step


def to_scipy(matrix: ca.DM) -> sp.csc_matrix:
    """A CasADi matrix as scipy's, without a dense copy."""
    sparsity = matrix.sparsity()
    return sp.csc_matrix(
        (np.array(matrix.nonzeros()), sparsity.row(), sparsity.colind()), shape=matrix.shape
    )


def _norm(residual: np.ndarray) -> float:
    size = float(np.max(np.abs(residual))) if residual.size else 0.0
    return size if np.isfinite(size) else np.inf
