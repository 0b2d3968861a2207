"""Where a run starts: equilibrium under the first loads, or rest."""

from __future__ import annotations

import itertools

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.network_equations import BELLOW_AMOUNTS, BELLOW_PRESSURES
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.branch_following import (
    OperatingPoint,
    PreviousSolution,
    branch_acceptance,
    constraints,
    follow_branch,
)
from viscodesign.solve.equilibrium_failures import no_equilibrium, step_limit_reached
from viscodesign.solve.initial_guess import bend_to_arcs, set_baseline, straighten, unloaded
from viscodesign.solve.numerics.newton import NewtonError, continuation, newton
from viscodesign.solve.problem import Problem

Instant = tuple[float, np.ndarray]
"""A time [s] and the inlets' coefficients that are valid at it."""


@dataclass(frozen=True)
class Start:
    """Scaled states (nx,) and algebraic unknowns (nz,) at a time."""

    states: np.ndarray
    algebraics: np.ndarray


def equilibrium(problem: Problem, time: float, piece: np.ndarray) -> Start:
    """Where a run starts in the static equilibrium; see `static_equilibrium`."""
    return from_statics(problem, static_equilibrium(problem, time, piece), time, piece)


def static_equilibrium(problem: Problem, time: float, piece: np.ndarray) -> np.ndarray:
    """Static unknowns (ny,) in equilibrium, with the inlets held at their pressures at ``time``.

    The unloaded shape is known in closed form; loads are then raised step by step.
    Raises `SolveError` with the load reached where no equilibrium is found, or where that
    takes more evaluations than a run may take steps.
    """
    equations = problem.equations
    evaluations = itertools.count(1)
    guess = unloaded(problem, time, piece)

    def family(y: np.ndarray, load: float) -> tuple[np.ndarray, ca.DM]:
        if next(evaluations) > problem.max_steps:
            raise step_limit_reached(problem, load, time)
        residual, jacobian, *_ = equations.statics_by_tape(y, *problem.tail(time, piece, load))
        return np.asarray(residual).ravel(), jacobian

    try:
        statics = equations.statics
        accept = branch_acceptance(statics, problem.static_stability)
        return continuation(family, guess, accept, problem.step_geometry(statics))
    except NewtonError as failure:
        raise no_equilibrium(problem, failure, time) from failure


def from_statics(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> Start:
    """Copy the static unknowns to states and algebraic unknowns, with all rates zero."""
    equations = problem.equations
    _, _, amounts, *_ = equations.statics_by_tape(y, *problem.tail(time, piece))
    held = np.asarray(amounts).ravel()

    def spread(unknowns: Unknowns) -> np.ndarray:
        parts, used = [np.zeros(0)], 0
        for name, block in unknowns.blocks.items():
            if block.traits.is_amount:
                parts.append(held[used : used + block.count] / block.size)
                used += block.count
            elif name in equations.statics.blocks:
                parts.append(y[equations.statics.blocks[name].span])
            else:
                parts.append(np.zeros(block.count))
        return np.concatenate(parts)

    return Start(spread(equations.states), spread(equations.algebraics))


def rest(problem: Problem, piece: np.ndarray) -> Start:
    """Pressures at the baseline, the rod straight, unstrained and at rest, just before t = 0."""
    equations = problem.equations
    states = equations.states
    y = np.zeros(equations.statics.count)
    set_baseline(problem, y, 0.0, piece)
    if equations.rod_form is RodForm.STATIC:
        # Without inertia no rod stays straight under pressure: it starts unstrained.
        bend_to_arcs(problem, y, problem.tail(0.0, piece, 0.0))
    else:
        straighten(problem, y)
    start = from_statics(problem, y, 0.0, piece)
    if equations.rod_form in (RodForm.STATIC, RodForm.ARCS) or BELLOW_AMOUNTS not in states.blocks:
        return start
    # A rod held straight under pressure carries moments, and they displace their volume.
    algebraics = _solve_internal(problem, start, piece)
    alg, _ = equations.constraints_by_tape(start.states, algebraics, *problem.tail(0.0, piece))
    residual = np.asarray(alg).ravel()[equations.algebraics.blocks[BELLOW_PRESSURES].span]
    x = start.states.copy()
    x[states.blocks[BELLOW_AMOUNTS].span] -= residual
    return Start(x, algebraics)


def _solve_internal(problem: Problem, start: Start, piece: np.ndarray) -> np.ndarray:
    """Algebraic unknowns (nz,): the internal ones solved for, the others held."""
    equations = problem.equations
    blocks = equations.algebraics.blocks.values()
    internal = [b.span for b in blocks if b.traits.is_internal]
    rows = [k for span in internal for k in range(span.start, span.stop)]
    z = start.algebraics.copy()
    tail = problem.tail(0.0, piece)

    def balance(values: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        z[rows] = values
        alg, jacobian = equations.constraints_by_tape(start.states, z, *tail)
        return np.asarray(alg).ravel()[rows], jacobian[rows, rows]

    try:
        z[rows] = newton(balance, z[rows])
    except NewtonError as failure:
        raise no_equilibrium(problem, failure, 0.0) from failure
    return z


def consistent(
    problem: Problem,
    start: Start,
    time: float,
    piece: np.ndarray,
    before: Instant | None = None,
    previous: PreviousSolution | None = None,
) -> Start:
    """The algebraic unknowns that belong to given states.

    ``before``: the instant to which those of ``start`` belong. A static rod is then followed
    from there, since an equilibrium beyond a fold of its branch is not one that it reaches;
    else its loads are raised from zero where Newton's iteration fails.
    ``previous``: the solution before ``start``. Raises `SolveError` where none are found.
    """
    equations = problem.equations
    if equations.algebraics.count == 0:
        return start
    point = OperatingPoint(start.states, time, piece)
    if before is not None and equations.rod_form is RodForm.STATIC:
        begin = OperatingPoint(start.states, *before)
        found = follow_branch(problem, start.algebraics, begin, point, previous)
        return Start(start.states, found)

    def family(z: np.ndarray, load: float) -> tuple[np.ndarray, ca.DM]:
        return constraints(problem, point, z, load)

    geometry = problem.step_geometry(equations.algebraics)
    try:
        return Start(start.states, newton(lambda z: family(z, 1.0), start.algebraics, geometry))
    except NewtonError:
        pass  # far from the solution: raise the loads step by step
    try:
        accept = branch_acceptance(equations.algebraics, problem.stability)
        return Start(start.states, continuation(family, start.algebraics, accept, geometry))
    except NewtonError as failure:
        raise no_equilibrium(problem, failure, time) from failure
