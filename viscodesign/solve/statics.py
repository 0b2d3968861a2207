"""Where a run starts: equilibrium under the first loads, or rest."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.model.rod_equations import MOVING, RodForm
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.branch_following import (
    NEARBY,
    Earlier,
    Moment,
    branch_judge,
    constraints,
    followed,
)
from viscodesign.solve.numerics.newton import NewtonError, continuation, newton
from viscodesign.solve.numerics.step_geometry import way_of
from viscodesign.solve.problem import Problem, evaluate

Instant = tuple[float, np.ndarray]
"""A time [s] and the inlets' coefficients that hold at it."""


@dataclass(frozen=True)
class Start:
    """Scaled states (nx,) and algebraic unknowns (nz,) at a time."""

    states: np.ndarray
    algebraics: np.ndarray


def equilibrium(problem: Problem, time: float, piece: np.ndarray, *, loaded: bool = True) -> Start:
    """Static equilibrium with the inlets held at their pressures at ``time``.

    The unloaded shape is known in closed form; loads are then raised step by step,
    unless ``loaded`` is false: then they wait to act at once.
    Raises `SolveError` with the load reached where no equilibrium is found, or where that
    takes more evaluations than a run may take steps.
    """
    equations = problem.equations
    evaluations = itertools.count(1)
    guess = _unloaded(problem, time, piece)
    if not loaded:
        return _from_statics(problem, guess, time, piece)

    def family(y: np.ndarray, load: float) -> tuple[np.ndarray, ca.DM]:
        if next(evaluations) > problem.most_steps:
            raise _overworked(problem, load, time)
        residual, jacobian, *_ = evaluate(
            equations.static_function, y, *problem.tail(time, piece, load)
        )
        return np.asarray(residual).ravel(), jacobian

    try:
        statics = equations.statics
        accept = branch_judge(statics, problem.static_stiffness)
        y = continuation(family, guess, accept, way_of(statics))
    except NewtonError as failure:
        raise _no_equilibrium(problem, failure, time) from failure
    return _from_statics(problem, y, time, piece)


def _unloaded(problem: Problem, time: float, piece: np.ndarray) -> np.ndarray:
    """Steady pressures, and the arcs that they bend the rod to."""
    equations = problem.equations
    statics = equations.statics
    y = np.zeros(statics.count)
    if "position" in statics.blocks:
        y[statics.blocks["position"].span] = _arc_positions(problem, None, None)
    tail = problem.tail(time, piece, 0.0)
    if "swelling" in statics.blocks:
        _at_baseline(problem, y, time, piece)
    fluid = [n for n in statics.blocks if "pressure" in n or n in ("flow", "swelling")]
    for _ in range(MOST_BENDS):
        before = y.copy()
        try:
            _settle(problem, y, fluid, tail)
        except NewtonError as failure:
            raise _no_pressures(problem, time) from failure
        if "position" not in statics.blocks:
            break
        _bend_to_arcs(problem, y, tail)
        # A rod that is not yet bent bears forces, and they take volume of what is sealed.
        if np.max(np.abs(y - before), initial=0.0) <= BENT:
            break
    return y


MOST_BENDS = 20
"""Times that the rod is bent to the arcs of the pressures that were found with it."""
BENT = 1e-9
"""Change of any unknown at which both belong to each other."""
GENTLE = 8
"""Power of the share that is balanced: fast flow begins to bend its law far below the last
pressure."""


def _settle(
    problem: Problem, y: np.ndarray, names: Sequence[str], tail: tuple[float | np.ndarray, ...]
) -> None:
    """Solve blocks of the static unknowns ``y`` by their own equations, the others held.

    At once where that works; else what is not yet balanced is taken away bit by bit. Always so
    where bellows snap: of several swellings a bellow has the one that it comes to first.
    """
    statics = problem.equations.statics
    spans = [block.span for name, block in statics.blocks.items() if name in names]
    if not spans:
        return
    chosen = np.concatenate([np.arange(statics.count)[span] for span in spans])
    trial = y.copy()

    def balance(values: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        trial[chosen] = values
        residual, jacobian, *_ = evaluate(problem.equations.static_function, trial, *tail)
        return np.asarray(residual).ravel()[chosen], jacobian[chosen.tolist(), chosen.tolist()]

    if "swelling" not in statics.blocks:
        with suppress(NewtonError):
            y[chosen] = newton(balance, y[chosen])
            return
    begun, _ = balance(y[chosen])

    def family(values: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        defect, jacobian = balance(values)
        return defect - (1 - share**GENTLE) * begun, jacobian

    own = [k for k in range(len(chosen)) if chosen[k] in _swellings(statics)]

    def settled(near: Sequence[np.ndarray], found: np.ndarray, jacobian: ca.DM) -> bool:
        far = min(np.max(np.abs((found - other)[own]), initial=0.0) for other in near)
        return far <= NEARBY and bool(np.all(np.array(ca.diag(jacobian))[own] > 0.0))

    y[chosen] = continuation(family, y[chosen], settled)


def _swellings(statics: Unknowns) -> range:
    block = statics.blocks.get("swelling")
    return range(block.span.start, block.span.stop) if block is not None else range(0)


def _at_baseline(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> None:
    """Put all pressures in ``y`` at the baseline, and the swellings that go with them."""
    for name, block in problem.equations.statics.blocks.items():
        if "pressure" in name:
            y[block.span] = problem.baseline / block.size
    try:
        _settle(problem, y, ["swelling"], problem.tail(time, piece, 0.0))
    except NewtonError as failure:
        raise _no_pressures(problem, time) from failure


def _no_pressures(problem: Problem, time: float) -> SolveError:
    if "swelling" in problem.equations.statics.blocks:
        return SolveError(
            f"no steady state is come to at t = {time:.6g} s: on the way from bellows.curve's "
            "rest to the first pressure a bellow snaps",
            quantity="swelling",
            where="network",
            time_s=time,
            remedy="Begin at a pressure below that of the first snap and raise it, or take "
            "run.start: rest.",
        )
    return SolveError(
        f"the steady pressures of the network cannot be found at t = {time:.6g} s",
        quantity="pressure",
        where="network",
        time_s=time,
        remedy="Look for tubes whose resistances differ by many orders of magnitude, for material "
        "curves that are nearly level, and for flow far beyond laminar (effects.flow_regime: off).",
    )


def _bend_to_arcs(problem: Problem, y: np.ndarray, tail: tuple[float | np.ndarray, ...]) -> None:
    """Put the nodes on the arcs that the pressures in ``y`` ask for."""
    _, _, _, curvature, stretch = evaluate(problem.equations.static_function, y, *tail)
    total = 1 + np.asarray(stretch).ravel()
    if np.min(total) <= 0.0:
        raise vanished_section(0.0, int(np.argmin(total)), float(np.min(total)))
    y[problem.equations.statics.blocks["position"].span] = _arc_positions(
        problem, np.asarray(curvature).ravel(), total - 1
    )


def _arc_positions(
    problem: Problem, curvature: np.ndarray | None, stretch: np.ndarray | None
) -> np.ndarray:
    """Scaled node positions of the unloaded rod (straight where no strain is given)."""
    body = problem.body
    count = problem.equations.statics.blocks["position"].count // 2
    if curvature is None or stretch is None:
        curvature, stretch = np.zeros(body.sections), np.zeros(body.sections)
    positions, _ = arc_nodes(
        curvature[None, :], 1 + stretch[None, :], body.section_length, count // body.sections
    )
    return np.asarray(positions[0].ravel() / body.length)


def _from_statics(problem: Problem, y: np.ndarray, time: float, piece: np.ndarray) -> Start:
    """Spread the static unknowns over states and algebraic unknowns; all is still."""
    equations = problem.equations
    _, _, amounts, *_ = evaluate(equations.static_function, y, *problem.tail(time, piece))
    known = {name: y[block.span] for name, block in equations.statics.blocks.items()}
    if "volume" in equations.states.blocks:
        held = np.asarray(amounts).ravel() / equations.states.blocks["volume"].size
        known["volume"], known["node_volume"] = np.split(held, [len(problem.bellows)])
        known["inflow"] = np.zeros(len(equations.driven))
    if equations.rod_form in MOVING:
        known["velocity"] = np.zeros_like(known["position"])
        known["acceleration"] = np.zeros_like(known["position"])
    return Start(_gather(equations.states, known), _gather(equations.algebraics, known))


def _gather(unknowns: Unknowns, known: dict[str, np.ndarray]) -> np.ndarray:
    return np.concatenate([known[name] for name in unknowns.blocks] or [np.zeros(0)])


def rest(problem: Problem, piece: np.ndarray) -> Start:
    """Pressures at the baseline, the rod straight, unstrained and still, just before t = 0."""
    equations = problem.equations
    statics, states = equations.statics, equations.states
    y = np.zeros(statics.count)
    _at_baseline(problem, y, 0.0, piece)
    if equations.rod_form is RodForm.STATIC:
        # Without inertia no rod stays straight under pressure: it starts unstrained.
        _bend_to_arcs(problem, y, problem.tail(0.0, piece, 0.0))
    elif "position" in statics.blocks:
        y[statics.blocks["position"].span] = _arc_positions(problem, None, None)
    start = _from_statics(problem, y, 0.0, piece)
    if equations.rod_form in (RodForm.STATIC, RodForm.ARCS) or "volume" not in states.blocks:
        return start
    # A rod held straight under pressure bears moments, and they take their volume.
    algebraics = _solve_block(problem, start, "elastic_curvature", piece)
    ode_alg = evaluate(
        equations.algebraic_function, start.states, algebraics, *problem.tail(0.0, piece)
    )
    defect = np.asarray(ode_alg[0]).ravel()[equations.algebraics.blocks["pressure"].span]
    x = start.states.copy()
    x[states.blocks["volume"].span] -= defect
    return Start(x, algebraics)


def _solve_block(problem: Problem, start: Start, name: str, piece: np.ndarray) -> np.ndarray:
    """Solve one block's equations for its unknowns, the others held."""
    equations = problem.equations
    span = equations.algebraics.blocks[name].span
    rows = list(range(span.start, span.stop))
    z = start.algebraics.copy()
    tail = problem.tail(0.0, piece)

    def block(values: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        z[span] = values
        alg, jacobian = evaluate(equations.algebraic_function, start.states, z, *tail)
        return np.asarray(alg).ravel()[span], jacobian[rows, rows]

    try:
        z[span] = newton(block, z[span])
    except NewtonError as failure:
        raise _no_equilibrium(problem, failure, 0.0) from failure
    return z


def consistent(
    problem: Problem,
    start: Start,
    time: float,
    piece: np.ndarray,
    before: Instant | None = None,
    earlier: Earlier | None = None,
) -> Start:
    """The algebraic unknowns that belong to given states.

    ``before``: when those of ``start`` held. A static rod is then followed from there,
    since beyond a fold of its branch another equilibrium would be none that it comes to;
    else its loads are raised from nothing where Newton's iteration fails.
    ``earlier``: from where it had come there. Raises `SolveError` where none are found.
    """
    equations = problem.equations
    if equations.algebraics.count == 0:
        return start
    moment = Moment(start.states, time, piece)
    if before is not None and equations.rod_form is RodForm.STATIC:
        begin = Moment(start.states, *before)
        return Start(start.states, followed(problem, start.algebraics, begin, moment, earlier))

    def family(z: np.ndarray, load: float) -> tuple[np.ndarray, ca.DM]:
        return constraints(problem, moment, z, load)

    way = way_of(equations.algebraics)
    try:
        return Start(start.states, newton(lambda z: family(z, 1.0), start.algebraics, way))
    except NewtonError:
        pass  # far from the solution: come to it along the loads
    try:
        accept = branch_judge(equations.algebraics, problem.stiffness)
        return Start(start.states, continuation(family, start.algebraics, accept, way))
    except NewtonError as failure:
        raise _no_equilibrium(problem, failure, time) from failure


def vanished_section(time: float, section: int, stretch: float) -> SolveError:
    """The failure of a section (from 0 at the clamp) that is pressed to nothing."""
    return SolveError(
        f"section {section + 1} is pressed to {stretch:.3g} of its length at t = {time:.6g} s: "
        "the linear law shortens it to nothing",
        quantity="stretch",
        where=f"section {section + 1}",
        time_s=float(time),
        remedy="Raise the lowest pressure, or check bellows.extension_per_pressure and "
        "actuator.youngs_modulus.",
    )


def _overworked(problem: Problem, load: float, time: float) -> SolveError:
    return SolveError(
        f"the limit of {problem.most_steps} steps was reached on the way to the equilibrium at "
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
        "Lower the loads or the pressure, or take inertia in ('effects.inertia: on', "
        "'run.start: rest') to follow the motion past the point where the static branch ends."
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
