"""From scaled unknowns back to a motion in SI, with its balances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.arcs import arc_nodes
from viscodesign.model.formulation import NetworkForm, RodForm
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.statics import vanished_section
from viscodesign.solve.transient import Solution
from viscodesign.trajectory import Invariants

SHAPE_POINTS = 64
"""Points of a drawn axis, at least."""
NEARLY_NOTHING = 0.3
"""Stretch of a section below which a failure is put down to it."""
STANDSTILL = 1e-3
"""Part of what is stored below which a motion counts as none in the balances."""
ENERGY_NOISE = 1e-4
"""Part of the work by which the output grid may misjudge a work integral and still be told."""


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
    failure = solution.failure
    stretch, turn = _section_strains(problem, rows)
    end = len(rows.time)
    gone = np.flatnonzero(~(stretch.min(axis=1) > 0.0))
    if gone.size:
        end = int(gone[0])
        failure = _thinnest(rows.time[end], stretch[end])
        if end == 0:
            raise failure
    elif failure is not None and stretch[-1].min() < NEARLY_NOTHING:
        # The integrator gives up on a section that is about to vanish.
        failure = _thinnest(rows.time[-1], stretch[-1])
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
        arc=arc,
        shape=shape,
        section_stretch=stretch[keep],
        section_turn=turn[keep],
        invariants=_invariants(problem, solution, rows, end),
        failure=failure,
    )


def _thinnest(time: float, stretch: np.ndarray) -> SolveError:
    return vanished_section(float(time), int(np.argmin(stretch)), float(np.min(stretch)))


def _evaluate(problem: Problem, solution: Solution) -> _Rows:
    """Call the output function at every solved edge."""
    equations, schedule = problem.equations, problem.schedule
    count = solution.reached
    # A state just before a corner belongs to the interval that ends there.
    piece = schedule.pieces[np.maximum(np.arange(count) - 1, 0)].T
    results = evaluate(
        equations.output_function.map(count),
        solution.states,
        solution.algebraics,
        schedule.edges[:count],
        piece,
        np.ones(count),
        np.tile(problem.sealed_volumes[:, None], count),
        np.tile(equations.parameter_values[:, None], count),
    )
    names = equations.output_function.name_out()
    values = {n: np.array(r).T for n, r in zip(names, results, strict=True)}
    if equations.network_form is NetworkForm.DISTRIBUTED:
        states = equations.states.physical("volume", solution.states).T
        values["volume"] = problem.rest_volume + states
    for name in ("pressure", "volume", "unpaired_volume"):
        values[name] = values[name][:, problem.places]
    return _Rows(schedule.edges[:count], values)


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


# -- balances -----------------------------------------------------------------


def _invariants(problem: Problem, solution: Solution, rows: _Rows, end: int) -> Invariants:
    volume = _volume_imbalance(problem, solution, rows, end)
    energy, coupling = _energy_imbalance(problem, solution, rows, end)
    return Invariants(volume, energy, coupling)


def _volume_imbalance(problem: Problem, solution: Solution, rows: _Rows, end: int) -> float:
    """Largest difference between what flowed in and what is stored, over what moved."""
    equations = problem.equations
    names = list(problem.bellows)
    # Where nothing moves, round-off is told against what is stored.
    moved = max(
        float(np.max(np.abs(rows["volume"][:end] - rows["volume"][0]))),
        STANDSTILL * float(np.max(np.abs(rows["volume"][:end]))),
    )
    worst = 0.0
    fed = np.zeros((0, end))
    if "inflow" in equations.states.blocks:
        fed = equations.states.physical("inflow", solution.states)[:, :end]
    for component, inflow in zip(equations.fed, fed, strict=False):
        held = rows["volume"][:end, [names.index(b) for b in component.bellows]].sum(axis=1)
        scale = max(moved, float(np.max(np.abs(inflow))))
        worst = max(worst, float(np.max(np.abs(held - held[0] - inflow))) / scale)
    for component, filled in zip(equations.sealed, problem.sealed_volumes, strict=True):
        held = rows["volume"][:end, [names.index(b) for b in component.bellows]].sum(axis=1)
        reference = held[0] if equations.network_form is NetworkForm.DISTRIBUTED else filled
        worst = max(worst, float(np.max(np.abs(held - reference))) / moved)
    return worst


def _energy_imbalance(
    problem: Problem, solution: Solution, rows: _Rows, end: int
) -> tuple[float | None, float | None]:
    """Energy balance over the work done, and the work of unpaired coupling [J].

    Work that pressures do through an unpaired volume, and through the whole volume
    where one pressure is shared, is integrated over the solved times; where they are
    too coarse for it the balance is not told.
    """
    if end < 5:
        return None, None
    every = np.arange(0, end, 2)
    stored = np.sum(
        [
            rows[name][every, 0]
            for name in ("fluid_energy", "kinetic_energy", "load_energy", "elastic_energy")
            if name in rows.values
        ],
        axis=0,
    )
    pressure, unpaired = rows["pressure"][:end], rows["unpaired_volume"][:end]
    coupling, noise = _work(unpaired, pressure)
    integrals = dict(zip(problem.equations.rates, solution.integrals[:, every], strict=True))
    if "pump_power" in integrals:
        pump = integrals["pump_power"] - integrals["tube_loss"]
        scale = float(np.max(np.abs(integrals["pump_power"])))
    else:
        pump, pump_noise = _work(pressure, rows["volume"][:end])
        noise = noise + pump_noise
        scale = float(np.max(np.abs(pump)))
    lost = integrals.get("material_loss", np.zeros(len(every)))
    scale = max(
        scale,
        float(np.ptp(stored)),
        float(np.max(np.abs(coupling))),
        STANDSTILL * float(np.max(np.abs(stored))),
    )
    if scale == 0.0:
        return 0.0, 0.0
    coupled = float(coupling[-1]) if np.any(unpaired) else None
    if noise > ENERGY_NOISE * scale:
        return None, coupled
    imbalance = stored - stored[0] - pump + lost - coupling
    return float(np.max(np.abs(imbalance))) / scale, coupled


def _work(force: np.ndarray, path: np.ndarray) -> tuple[np.ndarray, float]:
    """Running integral of force d(path), summed over columns, at every second row.

    The trapezoidal rule on all rows and on every second one, extrapolated to nothing
    between them (Richardson); the second value is how far that still is uncertain, by
    the next doubling.
    """
    fine, coarse = (_trapezoids(force, path, step) for step in (1, 2))
    coarsest = _trapezoids(force, path, 4)
    best = (4 * fine[::2] - coarse) / 3
    worse = (4 * coarse[::2] - coarsest) / 3
    return best, float(np.max(np.abs(best[::2] - worse))) / 15


def _trapezoids(force: np.ndarray, path: np.ndarray, step: int) -> np.ndarray:
    some, way = force[::step], path[::step]
    parts = np.sum((some[1:] + some[:-1]) / 2 * np.diff(way, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(parts)])
