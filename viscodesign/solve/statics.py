"""Where a run starts: equilibrium under the first loads, or rest."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.network_equations import BELLOW_AMOUNTS, BELLOW_PRESSURES
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.unknowns import Block, Unknowns
from viscodesign.solve.branch_following import (
    SAME_BRANCH_DISTANCE,
    OperatingPoint,
    PreviousSolution,
    branch_acceptance,
    constraints,
    follow_branch,
)
from viscodesign.solve.numerics.newton import NewtonError, continuation, newton
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Problem, evaluate

Instant = tuple[float, np.ndarray]
"""A time [s] and the inlets' coefficients that are valid at it."""


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


@dataclass(frozen=True)
class Start:
    """Scaled states (nx,) and algebraic unknowns (nz,) at a time."""

    states: np.ndarray
    algebraics: np.ndarray


def equilibrium(problem: Problem, time: float, piece: np.ndarray, *, loaded: bool = True) -> Start:
    """Static equilibrium with the inlets held at their pressures at ``time``.

    The unloaded shape is known in closed form; loads are then raised step by step,
    unless ``loaded`` is false: then they are to act suddenly.
    Raises `SolveError` with the load reached where no equilibrium is found, or where that
    takes more evaluations than a run may take steps.
    """
    equations = problem.equations
    evaluations = itertools.count(1)
    guess = _unloaded(problem, time, piece)
    if not loaded:
        return _from_statics(problem, guess, time, piece)

    def family(y: np.ndarray, load: float) -> tuple[np.ndarray, ca.DM]:
        if next(evaluations) > problem.max_steps:
            raise _step_limit_reached(problem, load, time)
        residual, jacobian, *_ = evaluate(
            equations.static_function, y, *problem.tail(time, piece, load)
        )
        return np.asarray(residual).ravel(), jacobian

    try:
        statics = equations.statics
        accept = branch_acceptance(statics, problem.static_stability)
        y = continuation(family, guess, accept, problem.step_geometry(statics))
    except NewtonError as failure:
        raise _no_equilibrium(problem, failure, time) from failure
    return _from_statics(problem, y, time, piece)


def _unloaded(problem: Problem, time: float, piece: np.ndarray) -> np.ndarray:
    """Steady pressures, and the rod bent to the arcs that belong to them."""
    statics = problem.equations.statics
    y = np.zeros(statics.count)
    _straighten(problem, y)
    tail = problem.tail(time, piece, 0.0)
    if _multivalued(statics):
        _set_baseline(problem, y, time, piece)
    fluid = [block for block in statics.blocks.values() if not block.traits.of_rod]
    for _ in range(GUESS.max_bends):
        before = y.copy()
        try:
            _settle(problem, y, fluid, tail)
        except NewtonError as failure:
            raise _no_pressures(problem, time) from failure
        if statics.branch_span is None:
            break
        _bend_to_arcs(problem, y, tail)
        # A rod that is not yet bent carries forces, which displace volume of what is sealed.
        if np.max(np.abs(y - before), initial=0.0) <= GUESS.bend_tol:
            break
    return y


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
        residual, jacobian, *_ = evaluate(problem.equations.static_function, trial, *tail)
        return np.asarray(residual).ravel()[chosen], jacobian[chosen.tolist(), chosen.tolist()]

    multivalued = _multivalued(statics)
    if not multivalued:
        with suppress(NewtonError):
            y[chosen] = newton(balance, y[chosen])
            return
    initial, _ = balance(y[chosen])

    def family(values: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        residual, jacobian = balance(values)
        return residual - (1 - share**GUESS.homotopy_power) * initial, jacobian

    own = np.flatnonzero(np.isin(chosen, multivalued))

    def near_and_stable(near: Sequence[np.ndarray], found: np.ndarray, jacobian: ca.DM) -> bool:
        distance = min(np.max(np.abs((found - other)[own]), initial=0.0) for other in near)
        stable = bool(np.all(np.array(ca.diag(jacobian))[own] > 0.0))
        return distance <= SAME_BRANCH_DISTANCE and stable

    y[chosen] = continuation(family, y[chosen], near_and_stable)


def _multivalued(statics: Unknowns) -> list[int]:
    """Unknowns whose equations may have several solutions."""
    own = (b.span for b in statics.blocks.values() if b.traits.is_multivalued)
    return [k for span in own for k in range(span.start, span.stop)]


def _set_baseline(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> None:
    """Set all pressures in ``y`` to the baseline, and the swellings that belong to them."""
    blocks = problem.equations.statics.blocks.values()
    for block in blocks:
        if block.traits.is_pressure:
            y[block.span] = problem.baseline / block.size
    try:
        swellings = [block for block in blocks if block.traits.is_multivalued]
        _settle(problem, y, swellings, problem.tail(time, piece, 0.0))
    except NewtonError as failure:
        raise _no_pressures(problem, time) from failure


def _straighten(problem: Problem, y: np.ndarray) -> None:
    """Put the rod straight and unstrained into the static unknowns ``y``."""
    span, sections = problem.equations.statics.branch_span, problem.body.sections
    if span is not None:
        y[span] = problem.rod.unloaded_coordinates(np.zeros(sections), np.ones(sections))


def _bend_to_arcs(problem: Problem, y: np.ndarray, tail: tuple[float | np.ndarray, ...]) -> None:
    """Bend the rod in ``y`` to the arcs of the pressures in it."""
    *_, curvature, stretch = evaluate(problem.equations.static_function, y, *tail)
    total = 1 + np.asarray(stretch).ravel()
    if np.min(total) <= 0.0:
        raise vanished_section(0.0, int(np.argmin(total)), float(np.min(total)))
    span = problem.equations.statics.branch_span
    y[span] = problem.rod.unloaded_coordinates(np.asarray(curvature).ravel(), total)


def _from_statics(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> Start:
    """Copy the static unknowns to states and algebraic unknowns, with all rates zero."""
    equations = problem.equations
    _, _, amounts, *_ = evaluate(equations.static_function, y, *problem.tail(time, piece))
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
    _set_baseline(problem, y, 0.0, piece)
    if equations.rod_form is RodForm.STATIC:
        # Without inertia no rod stays straight under pressure: it starts unstrained.
        _bend_to_arcs(problem, y, problem.tail(0.0, piece, 0.0))
    else:
        _straighten(problem, y)
    start = _from_statics(problem, y, 0.0, piece)
    if equations.rod_form in (RodForm.STATIC, RodForm.ARCS) or BELLOW_AMOUNTS not in states.blocks:
        return start
    # A rod held straight under pressure carries moments, and they displace their volume.
    algebraics = _solve_internal(problem, start, piece)
    alg, _ = evaluate(
        equations.algebraic_function, start.states, algebraics, *problem.tail(0.0, piece)
    )
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
        alg, jacobian = evaluate(equations.algebraic_function, start.states, z, *tail)
        return np.asarray(alg).ravel()[rows], jacobian[rows, rows]

    try:
        z[rows] = newton(balance, z[rows])
    except NewtonError as failure:
        raise _no_equilibrium(problem, failure, 0.0) from failure
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
        raise _no_equilibrium(problem, failure, time) from failure


def vanished_section(time: float, section: int, stretch: float) -> SolveError:
    """The failure of a section (from 0 at the clamp) that is compressed to nothing."""
    return SolveError(
        f"section {section + 1} is compressed to {100 * stretch:.3g} % of its length at "
        f"t = {time:.6g} s; the linear law no longer holds",
        quantity="stretch",
        where=f"section {section + 1}",
        time_s=float(time),
        remedy="Raise the lowest pressure, or check bellows.extension_per_pressure and "
        "actuator.youngs_modulus.",
    )


def _no_pressures(problem: Problem, time: float) -> SolveError:
    if _multivalued(problem.equations.statics):
        return SolveError(
            f"no steady state can be reached at t = {time:.6g} s: on the way from the rest state "
            "of bellows.curve to the first pressure, a bellow snaps through",
            quantity="swelling",
            where="network",
            time_s=time,
            remedy="Start at a pressure below that of the first snap and raise it, or set "
            "run.start: rest.",
        )
    return SolveError(
        f"the steady pressures of the network cannot be found at t = {time:.6g} s",
        quantity="pressure",
        where="network",
        time_s=time,
        remedy="Check for tubes whose resistances differ by many orders of magnitude, for material "
        "curves that are nearly flat, and for turbulent flow.",
    )


def _step_limit_reached(problem: Problem, load: float, time: float) -> SolveError:
    return SolveError(
        f"the limit of {problem.max_steps} steps was reached on the way to the equilibrium at "
        f"t = {time:.6g} s, at {100 * load:.3g} % of the loads",
        quantity="work",
        where="rod",
        time_s=time,
        remedy="Raise run.max_steps, lower the loads, or ask for less accuracy.",
    )


def _no_equilibrium(problem: Problem, failure: NewtonError, time: float) -> SolveError:
    percent = 100 * failure.reached
    form = problem.equations.rod_form
    remedy = (
        advice(problem.remedies, Obstacle.NO_EQUILIBRIUM, "Lower the loads or the pressure")
        if form is not RodForm.ARCS
        else "Check the network's tubes and pressures."
    )
    return SolveError(
        f"no stable equilibrium: the branch from the unloaded shape ends at {percent:.3g} % "
        "of the loads",
        quantity="equilibrium",
        where="rod" if form is not RodForm.ARCS else "network",
        time_s=time,
        remedy=remedy,
    )
