"""Damped Newton on sparse systems, and continuation from an easy problem to the real one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.solve.numerics.linear import factorised
from viscodesign.solve.numerics.step_geometry import STRAIGHT, Way

Residual = Callable[[np.ndarray], tuple[np.ndarray, ca.DM]]
Judge = Callable[[Sequence[np.ndarray], np.ndarray, ca.DM], bool]
Family = Callable[[np.ndarray, float], tuple[np.ndarray, ca.DM]]

CONVERGED = 1e-12
"""Correction, in sizes of the unknowns, at which the iteration has arrived."""
ROUND_OFF = 1e-8
"""Correction below which a standstill is round-off of a stiff problem, not a failure."""
MAX_ITERATIONS = 60
MOST_GROWING = 3
"""Corrections in a row, each more than twice the one before, after which none will arrive."""
SMALLEST_FRACTION = 1.0 / 1024
"""Of a Newton step."""
SMALLEST_STEP = 2.0**-20
"""Of a branch; an imperfection turns it sharply near a bifurcation."""


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


def newton(function: Residual, start: np.ndarray, way: Way = STRAIGHT) -> np.ndarray:
    """Solve function(y) = 0 from ``start`` (n,), dimensionless, with steps along a ``way``.

    Damped by the natural monotonicity test: a step is judged by the correction that
    would follow it, not by the defect, which a stiff axis makes a poor judge.
    Source: Deuflhard, Newton Methods for Nonlinear Problems, section 3.1.
    Raises `NewtonError` where no fraction of a step brings the solution nearer, or corrections
    grow and grow.
    """
    y = start.copy()
    residual, jacobian = function(y)
    size, growing = np.inf, 0
    for _ in range(MAX_ITERATIONS):
        if not np.any(residual):
            return y
        solve = _factorised(jacobian, residual)
        step = solve(residual)
        before, size = size, _norm(step)
        growing = growing + 1 if size > 2 * before else 0
        if growing >= MOST_GROWING:
            break
        if size <= CONVERGED:
            return np.asarray(y - step)
        found = _advance(function, solve, y, step, way)
        if found is None:
            if size <= ROUND_OFF:
                return y
            break
        y, residual, jacobian = found
    raise NewtonError(_norm(residual), int(np.argmax(np.abs(residual))))


def _advance(
    function: Residual,
    solve: Callable[[np.ndarray], np.ndarray],
    y: np.ndarray,
    step: np.ndarray,
    way: Way,
) -> tuple[np.ndarray, np.ndarray, ca.DM] | None:
    """The largest of the halved steps after which the next correction is smaller."""
    size, fraction = _norm(step), 1.0
    # What is near round-off is no further from the solution than any part of a step would tell.
    smallest = 1.0 if size <= ROUND_OFF else SMALLEST_FRACTION
    while fraction >= smallest:
        trial = way.step(y, -fraction * step)
        residual, jacobian = function(trial)
        if np.all(np.isfinite(residual)) and _norm(solve(residual)) <= (1 - fraction / 4) * size:
            return trial, residual, jacobian
        fraction /= 2
    return None


def continuation(
    family: Family,
    start: np.ndarray,
    accept: Judge = lambda near, found, jacobian: True,
    way: Way = STRAIGHT,
    previous: tuple[np.ndarray, float] | None = None,
) -> np.ndarray:
    """Follow family(y, s) = 0 from ``start`` at s = 0 to s = 1, as fast as Newton allows.

    ``previous``: a solution from before ``start`` and its s < 0, to foresee the first by.

    ``accept`` judges a solution by its neighbours (where it was foreseen, and the one
    before) and by its Jacobian: what it refuses is not on the branch, and a shorter step is
    tried. Raises `NewtonError` with the load factor reached, where the branch ends.
    """
    y, reached, step = start, 0.0, 1.0
    while reached < 1.0:
        target = min(1.0, reached + step)
        guess = y
        if previous is not None:
            before, back = previous
            guess = way.beyond(before, y, (target - reached) / (reached - back))
        try:
            found = newton(partial(_at, family, target), guess, way)
            if not accept((guess, y), found, family(found, target)[1]):
                raise NewtonError(0.0, 0)
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


def _factorised(jacobian: ca.DM, residual: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Solver of the linear system; `NewtonError` where it is singular."""
    failure = NewtonError(_norm(residual), int(np.argmax(np.abs(residual))))
    if not jacobian.is_regular():
        raise failure
    try:
        return factorised(jacobian)
    except RuntimeError as error:  # its word for a singular matrix
        raise failure from error


def _norm(residual: np.ndarray) -> float:
    size = float(np.max(np.abs(residual))) if residual.size else 0.0
    return size if np.isfinite(size) else np.inf
