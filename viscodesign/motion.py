"""From scaled unknowns back to a motion in SI, with its balances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.balances import read_invariants
from viscodesign.errors import SolveError
from viscodesign.model.arcs import arc_nodes
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.problem import Problem, evaluate_along
from viscodesign.solve.statics import vanished_section
from viscodesign.solve.transient import Solution
from viscodesign.trajectory import Invariants

SHAPE_POINTS = 64
"""Points of a drawn axis, at least."""
NEARLY_EMPTY = 0.2
"""Volume of a bellow, of that at rest, at which a gas's failure is put down to it."""
NEARLY_NOTHING = 0.3
"""Stretch of a section below which a failure is put down to it."""


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
    end, failure = _ended(problem, rows, stretch, solution.failure)
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
        invariants=read_invariants(problem, solution, rows.values, end),
        failure=failure,
    )


def _ended(
    problem: Problem, rows: _Rows, stretch: np.ndarray, failure: SolveError | None
) -> tuple[int, SolveError | None]:
    """Rows up to which a motion has a meaning, and why it ends there."""
    gas = not problem.equations.incompressible
    least = rows["volume"].min(axis=1)
    gone = ~(stretch.min(axis=1) > 0.0)
    lost = np.flatnonzero(gone | (gas & (least <= 0.0)))
    if lost.size:
        end = int(lost[0])
        if gone[end]:
            return end, _thinnest(rows.time[end], stretch[end])
        return end, _emptied(problem, rows, max(end - 1, 0))
    if failure is not None and stretch[-1].min() < NEARLY_NOTHING:
        # The integrator gives up on a section that is about to vanish.
        return len(rows.time), _thinnest(rows.time[-1], stretch[-1])
    if failure is not None and gas and least[-1] < NEARLY_EMPTY * _rest_volume(problem):
        return len(rows.time), _emptied(problem, rows, -1)
    return len(rows.time), failure


def _rest_volume(problem: Problem) -> float:
    """What one bellow holds at zero gauge [m3]."""
    return float(problem.equations.rest_amounts[0])


def _emptied(problem: Problem, rows: _Rows, row: int) -> SolveError:
    """The failure of a bellow that is sucked empty: no gas fills a volume of nothing."""
    volume = rows["volume"][row]
    name, time = problem.bellows[int(np.argmin(volume))], float(rows.time[row])
    share = float(np.min(volume)) / _rest_volume(problem)
    return SolveError(
        f"{name} is sucked empty after t = {time:.6g} s, where it holds {share:.3g} of its rest "
        "volume: the linear law goes on to negative volumes, which no gas can fill",
        quantity="volume",
        where=name,
        time_s=time,
        remedy="Let effects.collapse be auto, or raise the lowest pressure.",
    )


def _thinnest(time: float, stretch: np.ndarray) -> SolveError:
    return vanished_section(float(time), int(np.argmin(stretch)), float(np.min(stretch)))


def _evaluate(problem: Problem, solution: Solution) -> _Rows:
    """Call the output function at every solved edge."""
    equations = problem.equations
    values = evaluate_along(problem, solution.states, solution.algebraics)
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
