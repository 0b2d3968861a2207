"""Integrals of what is a formula of the time: no unknown, hence no integrator, has a part in it."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.model.formulation import Equations
from viscodesign.solve.problem import Problem

PER_SWING = 32
"""Parts of an input's swing that are integrated each by itself, at first."""
MOST_PARTS = 20_000
"""Parts of one interval, at most."""
POINTS = 4
"""Points of Gauss in each."""
EXACT = 1e-7
"""Change of an integral, of the largest, at which it is taken as exact."""
MOST_HALVINGS = 7


def timed_integrals(problem: Problem, first: int, count: int) -> np.ndarray:
    """Of the timed rates from edge ``first`` to each of the ``count`` edges that follow (n, m).

    Parts are halved until that changes little.
    """
    equations = problem.equations
    if not equations.timed_quadrature.numel() or not count:
        return np.zeros((equations.timed_quadrature.numel(), count))
    edges = problem.schedule.edges[first : first + count + 1]
    spacing = (equations.swing_time or edges[-1]) / PER_SWING
    found = _summed(problem, first, edges, spacing)
    for _ in range(MOST_HALVINGS):
        before, spacing = found, spacing / 2
        found = _summed(problem, first, edges, spacing)
        if np.max(np.abs(found - before)) <= EXACT * np.max(np.abs(found)):
            break
    return found


def _summed(problem: Problem, first: int, edges: np.ndarray, spacing: float) -> np.ndarray:
    """The same by Gauss's rule on parts of every interval that are no longer than ``spacing``."""
    equations = problem.equations
    parts = np.ceil(np.minimum(np.diff(edges) / spacing, MOST_PARTS)).astype(int)
    cuts = [np.linspace(a, b, n + 1) for a, b, n in zip(edges, edges[1:], parts, strict=False)]
    begins, ends = np.concatenate([c[:-1] for c in cuts]), np.concatenate([c[1:] for c in cuts])
    own = problem.schedule.pieces[first : first + len(parts)]
    pieces = np.repeat(own, parts, axis=0).T
    rates = equations.compiled.get("timed", lambda: _rates(equations))
    told = np.zeros((equations.timed_quadrature.numel(), len(begins)))
    for place, weight in zip(*np.polynomial.legendre.leggauss(POINTS), strict=True):
        at = begins + (place + 1) / 2 * (ends - begins)
        values = np.array(rates(at[None, :], pieces, problem.numbers()))
        told += weight / 2 * (ends - begins) * values
    return np.asarray(np.cumsum(told, axis=1)[:, np.cumsum(parts) - 1])


def _rates(equations: Equations) -> ca.Function:
    """(time, pieces, numbers) -> timed rates over the size of an energy (n,)."""
    arguments = [equations.time, equations.pieces, equations.parameters]
    return ca.Function("timed", arguments, [equations.timed_quadrature])
