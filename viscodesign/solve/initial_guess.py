"""Where the search for an equilibrium begins: steady pressures, and the rod bent to their arcs."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.unknowns import Block
from viscodesign.solve.branch_following import (
    SAME_BRANCH_DISTANCE,
)
from viscodesign.solve.equilibrium_failures import no_pressures
from viscodesign.solve.event_failures import thinnest_section
from viscodesign.solve.numerics.newton import NewtonError, continuation, newton
from viscodesign.solve.problem import Problem


@dataclass(frozen=True)
class InitialGuess:
    """Numbers that steer the way to the equilibrium without loads."""

    max_bends: int = 20
    """Times that the rod is bent to the arcs of the pressures that were found with it."""
    bend_tol: float = 1e-9
    """Change of any unknown at which shape and pressures agree."""
    homotopy_power: int = 8
    """Power of the balanced share: fast flow departs from its linear law far below the last
    pressure."""


GUESS = InitialGuess()


def unloaded(problem: Problem, time: float, piece: np.ndarray) -> np.ndarray:
    """Steady pressures, and the rod bent to the arcs that belong to them."""
    statics = problem.equations.statics
    y = np.zeros(statics.count)
    straighten(problem, y)
    tail = problem.tail(time, piece, 0.0)
    if statics.multivalued:
        set_baseline(problem, y, time, piece)
    fluid = [block for block in statics.blocks.values() if not block.traits.of_rod]
    for _ in range(GUESS.max_bends):
        before = y.copy()
        try:
            _settle(problem, y, fluid, tail)
        except NewtonError as failure:
            raise no_pressures(problem, time) from failure
        if statics.branch_span is None:
            break
        bend_to_arcs(problem, y, tail)
        # A rod that is not yet bent carries forces, which displace volume of what is sealed.
        if np.max(np.abs(y - before), initial=0.0) <= GUESS.bend_tol:
            break
    return y


def set_baseline(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> None:
    """Set all pressures in ``y`` to the baseline, and the swellings that belong to them."""
    blocks = problem.equations.statics.blocks.values()
    for block in blocks:
        if block.traits.is_pressure:
            y[block.span] = problem.baseline / block.size
    try:
        swellings = [block for block in blocks if block.traits.is_multivalued]
        _settle(problem, y, swellings, problem.tail(time, piece, 0.0))
    except NewtonError as failure:
        raise no_pressures(problem, time) from failure


def _settle(
    problem: Problem, y: np.ndarray, blocks: Sequence[Block], tail: tuple[float | np.ndarray, ...]
) -> None:
    """Solve blocks of the static unknowns ``y`` by their own equations, in place.

    By Newton's iteration where that converges, else by a homotopy that removes the residual
    gradually. Always the homotopy where unknowns are multivalued: of several swellings a bellow
    has the one that it reaches first.
    """
    if not blocks:
        return
    statics = problem.equations.statics
    chosen = np.concatenate([np.arange(statics.count)[block.span] for block in blocks])
    trial = y.copy()

    def balance(values: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        trial[chosen] = values
        residual, jacobian, *_ = problem.equations.statics_by_tape(trial, *tail)
        return np.asarray(residual).ravel()[chosen], jacobian[chosen.tolist(), chosen.tolist()]

    if not statics.multivalued:
        with suppress(NewtonError):
            y[chosen] = newton(balance, y[chosen])
            return
    initial, _ = balance(y[chosen])

    def family(values: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        residual, jacobian = balance(values)
        return residual - (1 - share**GUESS.homotopy_power) * initial, jacobian

    own = np.flatnonzero(np.isin(chosen, statics.multivalued))

    def near_and_stable(near: Sequence[np.ndarray], found: np.ndarray, jacobian: ca.DM) -> bool:
        distance = min(np.max(np.abs((found - other)[own]), initial=0.0) for other in near)
        stable = bool(np.all(np.array(ca.diag(jacobian))[own] > 0.0))
        return distance <= SAME_BRANCH_DISTANCE and stable

    y[chosen] = continuation(family, y[chosen], near_and_stable)


def straighten(problem: Problem, y: np.ndarray) -> None:
    """Put the rod straight and unstrained into the static unknowns ``y``."""
    span, sections = problem.equations.statics.branch_span, problem.body.sections
    if span is not None:
        y[span] = problem.rod.unloaded_coordinates(np.zeros(sections), np.ones(sections))


def bend_to_arcs(problem: Problem, y: np.ndarray, tail: tuple[float | np.ndarray, ...]) -> None:
    """Bend the rod in ``y`` to the arcs of the pressures in it."""
    *_, curvature, stretch = problem.equations.statics_by_tape(y, *tail)
    total = 1 + np.asarray(stretch).ravel()
    if np.min(total) <= 0.0:
        raise thinnest_section(0.0, total)
    span = problem.equations.statics.branch_span
    y[span] = problem.rod.unloaded_coordinates(np.asarray(curvature).ravel(), total)
