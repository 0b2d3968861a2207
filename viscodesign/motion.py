"""From scaled unknowns back to a motion in SI, with its balances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.balances import Block, Ledger
from viscodesign.errors import SolveError
from viscodesign.model.arcs import arc_nodes
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.problem import Problem, evaluate_along
from viscodesign.solve.statics import refined
from viscodesign.solve.transient import Solution
from viscodesign.trajectory import Invariants
from viscodesign.watching import first_ending

SHAPE_POINTS = 64
"""Points of a drawn axis, at least."""


@dataclass(frozen=True)
class Motion:
    """T output times, B bellows, Q tubes, K shape points, S sections; all SI."""

    time: np.ndarray
    tip: np.ndarray
    inlet_pressure: np.ndarray
    """(T, inlets) gauge."""
    pressure: np.ndarray
    volume: np.ndarray
    flow: np.ndarray
    junction_pressure: np.ndarray
    """(T, junctions) gauge."""
    arc: np.ndarray
    shape: np.ndarray
    section_stretch: np.ndarray
    section_turn: np.ndarray
    invariants: Invariants
    failure: SolveError | None


@dataclass(frozen=True)
class _Rows:
    """Named outputs at every solved edge, time along the first axis."""

    time: np.ndarray
    values: dict[str, np.ndarray]

    def __getitem__(self, name: str) -> np.ndarray:
        return self.values[name]


def read_motion(problem: Problem, solution: Solution) -> Motion:
    """Evaluate every output and balance over what was solved.

    A section pressed to nothing ends the motion just before, with its name.
    """
    rows = _evaluate(problem, solution)
    stretch, turn = _section_strains(problem, rows)
    end, failure = first_ending(problem, rows.time, rows.values, stretch, solution.failure)
    if end == 0 and failure is not None:
        raise failure
    outputs = problem.schedule.outputs
    keep = outputs[outputs < end]
    arc, shape, angle = _shapes(problem, rows, keep)
    return Motion(
        time=rows.time[keep],
        tip=np.column_stack((shape[:, -1], angle)),
        inlet_pressure=rows["inlet_pressure"][keep],
        pressure=rows["pressure"][keep],
        volume=rows["volume"][keep],
        flow=_flows(problem, rows)[keep],
        junction_pressure=rows["junction_pressure"][keep],
        arc=arc,
        shape=shape,
        section_stretch=stretch[keep],
        section_turn=turn[keep],
        invariants=_invariants(problem, solution, rows.values, end),
        failure=failure,
    )


def _evaluate(problem: Problem, solution: Solution) -> _Rows:
    """Call the output function at every solved edge."""
    equations = problem.equations
    algebraics = solution.algebraics
    shared = equations.network_form is NetworkForm.UNIFORM and equations.sealed
    if shared or "junction_pressure" in equations.algebraics.blocks:
        # What comes to a junction leaves it, and what is sealed stays: between the steps of an
        # integrator that holds to its tolerance only.
        algebraics = refined(problem, solution.states, algebraics)
    values = evaluate_along(problem, solution.states, algebraics)
    if equations.network_form is NetworkForm.DISTRIBUTED:
        # From the states, in which what is stored and what flowed in agree to round-off.
        blocks = [n for n in ("volume", "node_volume") if n in equations.states.blocks]
        held = [equations.states.physical(n, solution.states).T for n in blocks]
        values["stored"] = equations.rest_amounts + np.concatenate(held, axis=1)
        if equations.incompressible:
            bellows = values["stored"][:, : len(problem.bellows)]
            values["volume"] = bellows - values["tube_volume"]
    for name in ("pressure", "volume", "unpaired_volume"):
        values[name] = values[name][:, problem.places]
    return _Rows(problem.schedule.edges[: solution.reached], values)


def _invariants(
    problem: Problem, solution: Solution, rows: dict[str, np.ndarray], end: int
) -> Invariants:
    """Both balances up to the first ``end`` solved edges."""
    ledger = Ledger(problem)
    told = {name: values[:end] for name, values in rows.items()}
    unknowns = solution.states[:, :end], solution.algebraics[:, :end]
    ledger.add(Block(0, *unknowns, solution.integrals[:, :end], told))
    return ledger.invariants(solution.work.steps)


def _section_strains(problem: Problem, rows: _Rows) -> tuple[np.ndarray, np.ndarray]:
    """Smallest stretch and turn of every section (T, S)."""
    sections = problem.body.sections
    if problem.equations.rod_form is RodForm.ARCS:
        turn = rows["intrinsic_curvature"] * problem.body.section_length
        return 1 + rows["intrinsic_stretch"], turn
    stretch = rows["stretch"].reshape(len(rows.time), sections, -1).min(axis=2)
    ends = rows["angle"].reshape(len(rows.time), sections, -1)[:, :, -1]
    return stretch, np.diff(ends, axis=1, prepend=0.0)


def _shapes(
    problem: Problem, rows: _Rows, keep: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Reference arc (K,), axis (T, K, 2) from the clamp on, and angle of the tip (T,)."""
    body = problem.body
    if problem.equations.rod_form is RodForm.ARCS:
        points = -(-SHAPE_POINTS // body.sections)
        nodes, angles = arc_nodes(
            rows["intrinsic_curvature"][keep],
            1 + rows["intrinsic_stretch"][keep],
            body.section_length,
            points,
        )
        tip_angle = angles[:, -1]
    else:
        nodes, tip_angle = _interpolated_nodes(problem, rows, keep)
    clamp = np.zeros((len(keep), 1, 2))
    shape = np.concatenate([clamp, nodes], axis=1)
    return np.linspace(0.0, body.length, shape.shape[1]), shape, tip_angle


def _interpolated_nodes(
    problem: Problem, rows: _Rows, keep: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The chain's nodes, with points between them on cubics that meet the tangents."""
    position = rows["position"][keep].reshape(len(keep), -1, 2)
    edges = position.shape[1]
    per_edge = max(1, -(-SHAPE_POINTS // edges))
    angle = np.concatenate([np.zeros((len(keep), 1)), rows["angle"][keep]], axis=1)
    nodes = np.concatenate([np.zeros((len(keep), 1, 2)), position], axis=1)
    tangent = np.stack((np.sin(angle), np.cos(angle)), axis=-1)
    chord = np.diff(nodes, axis=1)
    length = np.hypot(chord[..., 0], chord[..., 1])[:, :, None]
    between = [
        _hermite(nodes[:, :-1], nodes[:, 1:], length * tangent[:, :-1], length * tangent[:, 1:], s)
        for s in np.arange(1, per_edge + 1) / per_edge
    ]
    points = np.stack(between, axis=2).reshape(len(keep), edges * per_edge, 2)
    return points, angle[:, -1]


def _hermite(
    a: np.ndarray, b: np.ndarray, slope_a: np.ndarray, slope_b: np.ndarray, s: float
) -> np.ndarray:
    if s == 1.0:
        return b
    return np.asarray(
        (1 + 2 * s) * (1 - s) ** 2 * a
        + s**2 * (3 - 2 * s) * b
        + s * (1 - s) ** 2 * slope_a
        + s**2 * (s - 1) * slope_b
    )


def _flows(problem: Problem, rows: _Rows) -> np.ndarray:
    """Tube flows (T, Q); with one pressure per network, those that its volume changes ask for."""
    if problem.equations.network_form is NetworkForm.DISTRIBUTED:
        return rows["flow"]
    if len(rows.time) < 2:
        return np.zeros((len(rows.time), len(problem.flow_shares)))
    from scipy.interpolate import CubicSpline

    rates = CubicSpline(rows.time, rows["volume"], axis=0)(rows.time, 1)
    return np.asarray(rates @ problem.flow_shares.T)
