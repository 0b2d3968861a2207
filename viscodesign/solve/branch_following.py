"""A rod without inertia stays on its branch of stable equilibria, or the run ends at its limit.

Its equations are algebraic: where a branch ends (a fold), a solver may jump to another
one, and where it loses its stability (a buckling load), it may stay on an unstable shape.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.numerics.newton import Acceptance, NewtonError, continuation
from viscodesign.solve.numerics.stability import StabilityTest
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Problem

SAME_BRANCH_DISTANCE = 0.1
"""Distance of a coordinate from its extrapolation, in sizes of the largest one, up to which a
solution is on the same branch; what lies beyond a fold is further off."""
MAX_EXTRAPOLATION = 4.0
"""How far ahead a branch is extrapolated, in lengths of the step before."""


@dataclass(frozen=True)
class OperatingPoint:
    """States (nx,) and inputs at a time [s], which determine the algebraic unknowns."""

    states: np.ndarray
    time: float
    piece: np.ndarray

    def towards(self, other: OperatingPoint, share: float) -> OperatingPoint:
        """The point a share of the way from this one to another."""
        return OperatingPoint(
            self.states + share * (other.states - self.states),
            self.time + share * (other.time - self.time),
            self.piece + share * (other.piece - self.piece),
        )


PreviousSolution = tuple[np.ndarray, float]
"""Algebraic unknowns (nz,) at an earlier time [s] on the same smooth input."""


def constraints(
    problem: Problem, point: OperatingPoint, z: np.ndarray, load: float = 1.0
) -> tuple[np.ndarray, ca.DM]:
    """Residual (nz,) of the algebraic equations at a point, and its Jacobian (nz, nz)."""
    tail = problem.tail(point.time, point.piece, load)
    alg, jacobian = problem.equations.constraints_by_tape(point.states, z, *tail)
    return np.asarray(alg).ravel(), jacobian


def follow_branch(
    problem: Problem,
    start: np.ndarray,
    before: OperatingPoint,
    after: OperatingPoint,
    previous: PreviousSolution | None = None,
) -> np.ndarray:
    """Algebraic unknowns (nz,) of a static rod at ``after``, on the branch of ``start``.

    ``previous``: the solution before ``start``, from which the next is extrapolated.
    Raises `SolveError` with the time at which the branch ends.
    """

    def family(z: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        return constraints(problem, before.towards(after, share), z)

    try:
        unknowns = problem.equations.algebraics
        accept = branch_acceptance(unknowns, problem.stability)
        geometry = problem.step_geometry(unknowns)
        earlier = _as_share_of_step(previous, before, after)
        return continuation(family, start, accept, geometry, earlier)
    except NewtonError as failure:
        raise limit_point(problem, before.towards(after, failure.reached).time) from failure


def _as_share_of_step(
    previous: PreviousSolution | None, before: OperatingPoint, after: OperatingPoint
) -> tuple[np.ndarray, float] | None:
    """An earlier solution and its position along the current step, as a negative fraction."""
    if previous is None:
        return None
    unknowns, time = previous
    passed, ahead = before.time - time, after.time - before.time
    return (unknowns, -passed / ahead) if 0.0 < ahead <= MAX_EXTRAPOLATION * passed else None


def branch_acceptance(unknowns: Unknowns, stability: StabilityTest | None) -> Acceptance:
    """Accepts solutions that stay on a branch; all of them where there are no branches."""
    span = unknowns.branch_span
    if stability is None or span is None:
        return lambda near, found, jacobian: True
    return partial(_on_branch, span, stability)


def _on_branch(
    span: slice,
    stability: StabilityTest,
    near: Sequence[np.ndarray],
    found: np.ndarray,
    jacobian: ca.DM,
) -> bool:
    """Whether a solution is near one of those given, and stable."""
    if not on_same_branch(span, near, found):
        return False
    return stability.is_stable(np.array(jacobian.nonzeros()))


def on_same_branch(span: slice, near: Sequence[np.ndarray], found: np.ndarray) -> bool:
    """Whether a solution is near one of those given."""
    size = max(1.0, float(np.max(np.abs(found[span]))))
    distance = min(np.max(np.abs(found[span] - other[span])) for other in near)
    return bool(distance <= SAME_BRANCH_DISTANCE * size)


def limit_point(problem: Problem, time: float) -> SolveError:
    """The failure of a static rod whose branch of equilibria ends."""
    return SolveError(
        f"the rod has no stable equilibrium near its shape after t = {time:.6g} s: limit point "
        "(fold or buckling load), at which it would snap through to another shape",
        quantity="equilibrium",
        where="rod",
        time_s=float(time),
        remedy=advice(problem.remedies, Obstacle.LIMIT_POINT, "Lower the loads or the pressure"),
    )
