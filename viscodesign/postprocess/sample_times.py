"""Solved times between the outputs, where works must be summed over them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.model.formulation import Equations
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.problem import Schedule

PER_SWING = 64
"""Samples in the time of an input's swing."""
PER_MOTION = 2
"""The same in the rod's own time, of which its first period takes almost two (1.8)."""
MOST_SAMPLES = 20_000
"""Samples of a run beyond its outputs: they cost little beside its steps, but not nothing."""
MOST_GRADED = 2_000
"""The same of those behind corners."""
SAME = 1e-9
"""Part of its size by which an input may differ on both sides of a corner and not jump."""
GRADES = 12
"""Samples in the first interval behind a corner, each twice as far from it as the one before."""


def with_samples(schedule: Schedule, equations: Equations, starts_at_rest: bool) -> Schedule:
    """The schedule, with edges so close that polynomials between them tell what happens.

    Nothing is added where an integrator tells all work, nor where nothing moves.
    """
    if not any(way.sampled.any() for way in equations.ways.values()):
        return schedule
    edges = schedule.edges
    corners = schedule.pieces.changes
    duration = float(edges[-1])
    still = equations.swing_time >= duration and not len(corners)
    if still and not equations.states.count:
        return schedule
    extra = [_even(edges, _spacing(equations, duration))]
    begins = [0, *corners.tolist()]
    if len(begins) * GRADES <= MOST_GRADED:
        # Elsewhere they would but make an integrator begin with tiny steps.
        sudden = [k for k in begins if _jumps(schedule, equations, k) or (not k and starts_at_rest)]
        extra.append(_graded(np.union1d(edges, extra[0]), edges[sudden]))
    return _refined(schedule, np.concatenate(extra))


def _jumps(schedule: Schedule, equations: Equations, edge: int) -> bool:
    """Whether any inlet's value is another behind an edge than before it."""
    output = equations.output_function
    names = output.name_out()
    unknowns = np.zeros(equations.states.count), np.zeros(equations.algebraics.count)
    tail = 1.0, equations.sealed_volumes, equations.parameter_values
    before = schedule.pieces[edge - 1] if edge else schedule.initial_piece
    told = []
    for piece in (before, schedule.pieces[edge]):
        values = output.call([*unknowns, schedule.edges[edge], piece, *tail])
        inlets = [values[names.index(name)] for name in ("inlet_pressure", "pushed")]
        told.append(np.concatenate([np.array(value).ravel() for value in inlets]))
    sizes = np.maximum(*np.abs(told))
    return bool(np.any(np.abs(told[1] - told[0]) > SAME * sizes))


def _spacing(equations: Equations, duration: float) -> float:
    swing = equations.swing_time or duration
    spacing = swing / PER_SWING
    if equations.rod_form is RodForm.DYNAMIC:
        spacing = min(spacing, equations.motion_time / PER_MOTION)
    return max(spacing, duration / MOST_SAMPLES)


def _even(edges: np.ndarray, spacing: float) -> np.ndarray:
    """Times that cut intervals longer than ``spacing`` into equal parts."""
    parts = np.ceil(np.diff(edges) / spacing * (1 - 1e-9)).astype(int)
    interval = np.repeat(np.arange(len(parts)), parts)
    first = np.concatenate([[0], np.cumsum(parts)[:-1]])
    share = (np.arange(len(interval)) - first[interval]) / parts[interval]
    return np.asarray((edges[interval] + share * np.diff(edges)[interval])[share > 0.0])


def _graded(edges: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Times in the interval behind each corner, ever denser towards it."""
    after = edges[np.searchsorted(edges, corners) + 1]
    share = 0.5 ** np.arange(1, GRADES + 1)
    return np.asarray((corners[:, None] + np.outer(after - corners, share)).ravel())


def _refined(schedule: Schedule, times: np.ndarray) -> Schedule:
    """The schedule with edges added."""
    edges = np.union1d(schedule.edges, times)
    pieces = schedule.pieces.among(schedule.edges, edges)
    outputs = np.searchsorted(edges, schedule.edges[schedule.outputs])
    return replace(schedule, edges=edges, pieces=pieces, outputs=outputs)
