"""Damped Newton on sparse systems, and continuation from an easy problem to the real one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.step_geometry import STRAIGHT, StepGeometry

Residual = Callable[[np.ndarray], tuple[np.ndarray, ca.DM]]
LinearSolve = Callable[[np.ndarray], np.ndarray]
Acceptance = Callable[[Sequence[np.ndarray], np.ndarray, ca.DM], bool]
Family = Callable[[np.ndarray, float], tuple[np.ndarray, ca.DM]]


@dataclass(frozen=True)
class NewtonControl:
    """Numbers that steer Newton's iteration and the continuation."""

    correction_tol: float = 1e-12
    """Correction, in sizes of the unknowns, at which the iteration has converged."""
    round_off_tol: float = 1e-8
    """Correction below which stagnation is round-off of a stiff problem, not a failure."""
    max_iterations: int = 60
    max_growing: int = 3
    """Consecutive corrections, each more than twice the one before, that mean divergence."""
    min_damping: float = 1.0 / 1024
    min_continuation_step: float = 2.0**-20
    """Smallest step of the load factor; an imperfection turns a branch sharply near a
    bifurcation."""


CONTROL = NewtonControl()


@dataclass(frozen=True)
class LinearSolverLimits:
    """Up to how many unknowns a direct solver is the fastest (measured)."""

    csparse_lu: int = 120
    """Before SuperLU is called: equal at 80, 0.6 ms slower at 144, 20 ms against 1 ms at 386, where
    the factors of CSparse have filled up. Importing SciPy for it takes 130 ms of every process."""
    integrator_lu: int = 200
    """For an integrator's LU against QR: 6 ms against 0.3 ms at 577, 335 ms against 1.4 ms at
    2305."""


LINEAR = LinearSolverLimits()


class NewtonError(Exception):
    """Newton's iteration stopped short of a solution.

    ``residual``: largest residual, in sizes of the terms; ``worst``: its index;
    ``reached``: load factor that continuation reached.
    """

    def __init__(self, residual: float, worst: int, reached: float = 0.0) -> None:
        super().__init__(f"residual {residual:.2g} in row {worst}, load factor {reached:.3g}")
        self.residual = residual
        self.worst = worst
        self.reached = reached


def newton(function: Residual, start: np.ndarray, geometry: StepGeometry = STRAIGHT) -> np.ndarray:
    """Solve function(y) = 0 from ``start`` (n,), dimensionless, with steps of a ``geometry``.

    Damped by the natural monotonicity test: a step is judged by the correction that
    would follow it, not by the residual, which a stiff axis makes a poor judge.
    Source: Deuflhard, Newton Methods for Nonlinear Problems, section 3.1.
    Raises `NewtonError` where no damping brings the solution nearer, or where corrections
    keep growing.
    """
    y = start.copy()
    residual, jacobian = function(y)
    size, growing = np.inf, 0
    for _ in range(CONTROL.max_iterations):
        if not np.any(residual):
            return y
        solve = _factorised_or_failed(jacobian, residual)
        step = solve(residual)
        before, size = size, _norm(step)
        growing = growing + 1 if size > 2 * before else 0
        if growing >= CONTROL.max_growing:
            break
        if size <= CONTROL.correction_tol:
            return np.asarray(y - step)
        found = _damped_step(function, solve, y, step, geometry)
        if found is None:
            if size <= CONTROL.round_off_tol:
                return y
            break
        y, residual, jacobian = found
    raise NewtonError(_norm(residual), int(np.argmax(np.abs(residual))))


def _damped_step(
    function: Residual,
    solve: LinearSolve,
    y: np.ndarray,
    step: np.ndarray,
    geometry: StepGeometry,
) -> tuple[np.ndarray, np.ndarray, ca.DM] | None:
    """The largest of the halved steps after which the next correction is smaller."""
    size, fraction = _norm(step), 1.0
    # Near round-off, no part of a step could tell a better solution from a worse one.
    smallest = 1.0 if size <= CONTROL.round_off_tol else CONTROL.min_damping
    while fraction >= smallest:
        trial = geometry.step(y, -fraction * step)
        residual, jacobian = function(trial)
        if np.all(np.isfinite(residual)) and _norm(solve(residual)) <= (1 - fraction / 4) * size:
            return trial, residual, jacobian
        fraction /= 2
    return None


def continuation(
    family: Family,
    start: np.ndarray,
    accept: Acceptance = lambda near, found, jacobian: True,
    geometry: StepGeometry = STRAIGHT,
    previous: tuple[np.ndarray, float] | None = None,
) -> np.ndarray:
    """Follow family(y, s) = 0 from ``start`` at s = 0 to s = 1, as fast as Newton allows.

    ``previous``: a solution from before ``start`` and its s < 0, from which the first guess
    is extrapolated.

    ``accept`` judges a solution by its neighbours (the guess and the one before) and by its
    Jacobian: what it refuses is not on the branch, and a shorter step is tried. Raises
    `NewtonError` with the load factor reached, where the branch ends.
    """
    y, reached, step = start, 0.0, 1.0
    while reached < 1.0:
        target = min(1.0, reached + step)
        guess = y
        if previous is not None:
            before, back = previous
            guess = geometry.extrapolate(before, y, (target - reached) / (reached - back))
        try:
            found = newton(partial(_at, family, target), guess, geometry)
            if not accept((guess, y), found, family(found, target)[1]):
                raise NewtonError(0.0, 0)
        except NewtonError as failure:
            step /= 2
            if step < CONTROL.min_continuation_step:
                raise NewtonError(failure.residual, failure.worst, reached) from failure
            continue
        previous, y, reached = (y, reached), found, target
        step *= 2
    return y


def _at(family: Family, load: float, y: np.ndarray) -> tuple[np.ndarray, ca.DM]:
    return family(y, load)


def integrator_linear_solver(unknowns: int) -> str:
    """CasADi's name of the direct solver that suits an integrator of so many unknowns.

    LU by CSparse has pivots that do not depend on the sign of a mirrored problem, unlike
    Householder's QR; but its factors fill up, and those of QR stay sparse.
    """
    return "csparse" if unknowns <= LINEAR.integrator_lu else "qr"


def factorised(matrix: ca.DM) -> LinearSolve:
    """Solver of the linear system, right side (n,) -> (n,).

    Raises `RuntimeError` where the matrix is singular.
    """
    pattern, count = matrix.sparsity(), matrix.size1()
    if count > LINEAR.csparse_lu:
        # Imported here, since it takes longer than solving most scenes, which are smaller.
        from scipy.sparse import csc_matrix
        from scipy.sparse.linalg import splu

        values = np.array(matrix.nonzeros())
        found = splu(csc_matrix((values, pattern.row(), pattern.colind()), (count, count)))
        return lambda right: np.asarray(found.solve(right))
    factors = ca.Linsol("few", "csparse", pattern)
    factors.nfact(matrix)
    return lambda right: np.array(factors.solve(matrix, ca.DM(right))).ravel()


def _factorised_or_failed(jacobian: ca.DM, residual: np.ndarray) -> LinearSolve:
    """Solver of the linear system; `NewtonError` where it is singular."""
    failure = NewtonError(_norm(residual), int(np.argmax(np.abs(residual))))
    if not jacobian.is_regular():
        raise failure
    try:
        return factorised(jacobian)
    except RuntimeError as error:  # raised for a singular matrix
        raise failure from error


def _norm(residual: np.ndarray) -> float:
    size = float(np.max(np.abs(residual))) if residual.size else 0.0
    return size if np.isfinite(size) else np.inf
