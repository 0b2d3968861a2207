"""A rod without inertia stays on its branch of stable equilibria, or ends by name.

Its equations are algebraic: where a branch ends (a fold), a solver may leap to another
one, and where it loses its stability (a buckling load), stay on a shape that no rod keeps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.numerics.newton import Judge, NewtonError, continuation
from viscodesign.solve.numerics.rod_stability import Stiffness
from viscodesign.solve.numerics.step_geometry import way_of
from viscodesign.solve.problem import Problem, evaluate

NEARBY = 0.1
"""Distance from where a node is foreseen, in lengths of the rod as it is drawn out, up to which
a shape is of the same branch; what lies beyond a fold is further off."""


@dataclass(frozen=True)
class Moment:
    """States (nx,) and inputs at a time [s], to which algebraic unknowns belong."""

    states: np.ndarray
    time: float
    piece: np.ndarray

    def towards(self, other: Moment, share: float) -> Moment:
        """The moment a share of the way from this one to another."""
        return Moment(
            self.states + share * (other.states - self.states),
            self.time + share * (other.time - self.time),
            self.piece + share * (other.piece - self.piece),
        )


def constraints(
    problem: Problem, moment: Moment, z: np.ndarray, load: float = 1.0
) -> tuple[np.ndarray, ca.DM]:
    """Defects of the algebraic equations at a moment, and their Jacobian."""
    tail = problem.tail(moment.time, moment.piece, load)
    alg, jacobian = evaluate(problem.equations.algebraic_function, moment.states, z, *tail)
    return np.asarray(alg).ravel(), jacobian


Earlier = tuple[np.ndarray, float]
"""Algebraic unknowns (nz,) from before a moment, on the same smooth input, and their time [s]."""
FARTHEST = 4.0
"""How far ahead a motion is foreseen, in times that it was followed before."""


def followed(
    problem: Problem,
    start: np.ndarray,
    before: Moment,
    after: Moment,
    earlier: Earlier | None = None,
) -> np.ndarray:
    """Algebraic unknowns (nz,) of a static rod from one moment to another, without a leap.

    ``earlier``: from where it came to ``start``, to foresee by where it goes.
    Raises `SolveError` with the time where the branch ends.
    """

    def family(z: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        return constraints(problem, before.towards(after, share), z)

    try:
        unknowns = problem.equations.algebraics
        accept = branch_judge(unknowns, problem.stiffness)
        previous = _foreseen_by(earlier, before, after)
        return continuation(family, start, accept, way_of(unknowns), previous)
    except NewtonError as failure:
        raise fold(before.towards(after, failure.reached).time) from failure


def _foreseen_by(
    earlier: Earlier | None, before: Moment, after: Moment
) -> tuple[np.ndarray, float] | None:
    """Earlier unknowns with their share of the way from one moment to the other, below zero."""
    if earlier is None:
        return None
    unknowns, time = earlier
    passed, ahead = before.time - time, after.time - before.time
    return (unknowns, -passed / ahead) if 0.0 < ahead <= FARTHEST * passed else None


def on_branch(
    unknowns: Unknowns,
    stiffness: Stiffness,
    near: Sequence[np.ndarray],
    found: np.ndarray,
    jacobian: ca.DM,
) -> bool:
    """Whether a rod's shape is near one of those given, and stable."""
    place = unknowns.blocks["position"].span
    size = max(1.0, float(np.max(np.abs(found[place]))))
    if min(np.max(np.abs(found[place] - other[place])) for other in near) > NEARBY * size:
        return False
    return stiffness.is_stable(np.array(jacobian.nonzeros()))


def branch_judge(unknowns: Unknowns, stiffness: Stiffness | None) -> Judge:
    """What accepts solutions along a branch: all where no rod is static."""
    if stiffness is None:
        return lambda near, found, jacobian: True
    return partial(on_branch, unknowns, stiffness)


def fold(time: float) -> SolveError:
    """The failure of a static rod whose branch of equilibria ends."""
    return SolveError(
        f"the rod has no stable equilibrium near its shape after t = {time:.6g} s: its static "
        "branch ends there, and it would snap to another shape",
        quantity="equilibrium",
        where="rod",
        time_s=float(time),
        remedy="Lower the loads or the pressure, or let effects.inertia and effects.damping be "
        "auto or on to follow the snap.",
    )
