"""Solved times between the outputs, for works that are summed over samples, and for events."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.equations import Equations
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.problem import Schedule
from viscodesign.storage.distinct import distinct


@dataclass(frozen=True)
class SamplingRule:
    """How densely a motion is sampled between its outputs."""

    per_swing: int = 64
    """Samples in the time of an input's swing."""
    per_motion_time: int = 2
    """Samples in the rod's time scale, of which its first period takes almost two (1.8)."""
    per_ringing_time: int = 32
    """The same where an input jumps: the rod's higher modes ring then."""
    max_ringing: int = 8_000
    """Samples of a rod that rings."""
    max_samples: int = 20_000
    """Samples beyond the outputs: they cost little beside a run's steps, but not nothing."""
    max_graded: int = 2_000
    """The same of those after corners."""
    jump_rel: float = 1e-9
    """Part of its size by which an input may change at a corner without a jump."""
    looks_per_swing: int = 16
    """Looks for events in the time of an input's swing, whatever the outputs."""
    free_looks_per_swing: int = 128
    """The same where nothing has to be solved for."""
    max_looks: int = 1_000
    """The most of both in a run."""
    grades: int = 12
    """Samples in the first interval after a jump, each twice as far from it as the one before."""


SAMPLING = SamplingRule()


def with_samples(
    schedule: Schedule, equations: Equations, starts_at_rest: bool, *, for_balances: bool = True
) -> Schedule:
    """The schedule, with edges so close that polynomials between them resolve the motion.

    Where an integrator gives all work they are just close enough to meet events, and where nobody
    asks for balances, unless flows follow from volumes. Nothing is added where nothing moves.
    """
    asked = for_balances or equations.network_form is NetworkForm.UNIFORM
    if not asked or not any(split.sampled.any() for split in equations.work_splits.values()):
        return _refined(schedule, _looks(schedule.edges, equations))
    edges = schedule.edges
    corners = schedule.pieces.changes
    duration = float(edges[-1])
    still = equations.swing_time >= duration and not len(corners)
    if still and not equations.states.count:
        return schedule
    begins = np.concatenate([[0], corners])
    sudden = _jumps(schedule, equations, begins)
    sudden[0] |= starts_at_rest
    extra = [_even(edges, _spacing(equations, duration, rings=bool(sudden.any())))]
    if len(begins) * SAMPLING.grades <= SAMPLING.max_graded:
        # At other corners they would only force an integrator to tiny steps.
        finer = distinct(np.concatenate([edges, extra[0]]))
        extra.append(_graded(finer, edges[begins[sudden]]))
    return _refined(schedule, np.concatenate(extra))


def _looks(edges: np.ndarray, equations: Equations) -> np.ndarray:
    """Times that cut intervals in which an event could come and go unseen."""
    duration = float(edges[-1])
    swing = equations.swing_time or duration
    is_free = not (equations.states.count or equations.algebraics.count)
    looks = SAMPLING.free_looks_per_swing if is_free else SAMPLING.looks_per_swing
    spacing = max(swing / looks, duration / SAMPLING.max_looks)
    return _even(edges, spacing)


def _jumps(schedule: Schedule, equations: Equations, edges: np.ndarray) -> np.ndarray:
    """Whether the value of any inlet changes at edges (n,), the first of which is 0."""
    output, count = equations.outputs_by_tape, len(edges)
    before = schedule.pieces[np.maximum(edges - 1, 0)]
    before[0] = schedule.initial_piece
    values = output.rows(
        [
            np.zeros(equations.states.count),
            np.zeros(equations.algebraics.count),
            np.tile(schedule.edges[edges], 2)[:, None],
            np.concatenate([before, schedule.pieces[edges]]),
            np.ones(1),
            equations.sealed_volumes,
            equations.parameter_values,
        ],
        2 * count,
    )
    names = ("inlet_pressure", "pushed")
    inlets = np.column_stack([values[output.names.index(name)] for name in names])
    sizes = np.maximum(*np.abs([inlets[:count], inlets[count:]]))
    changes = np.abs(inlets[count:] - inlets[:count])
    return np.asarray(np.any(changes > SAMPLING.jump_rel * sizes, axis=1))


def _spacing(equations: Equations, duration: float, *, rings: bool) -> float:
    swing = equations.swing_time or duration
    spacing = swing / SAMPLING.per_swing
    if equations.rod_form is RodForm.DYNAMIC:
        spacing = min(spacing, equations.motion_time / SAMPLING.per_motion_time)
        if rings:
            finest = equations.motion_time / SAMPLING.per_ringing_time
            spacing = min(spacing, max(finest, duration / SAMPLING.max_ringing))
    return max(spacing, duration / SAMPLING.max_samples)


def _even(edges: np.ndarray, spacing: float) -> np.ndarray:
    """Times that cut intervals longer than ``spacing`` into equal parts."""
    parts = np.ceil(np.diff(edges) / spacing * (1 - 1e-9)).astype(int)
    interval = np.repeat(np.arange(len(parts)), parts)
    first = np.concatenate([[0], np.cumsum(parts)[:-1]])
    share = (np.arange(len(interval)) - first[interval]) / parts[interval]
    return np.asarray((edges[interval] + share * np.diff(edges)[interval])[share > 0.0])


def _graded(edges: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Times in the interval after each corner, ever denser towards it."""
    after = edges[np.searchsorted(edges, corners) + 1]
    share = 0.5 ** np.arange(1, SAMPLING.grades + 1)
    return np.asarray((corners[:, None] + np.outer(after - corners, share)).ravel())


def _refined(schedule: Schedule, times: np.ndarray) -> Schedule:
    """The schedule with edges added."""
    edges = distinct(np.concatenate([schedule.edges, times]))
    pieces = schedule.pieces.among(schedule.edges, edges)
    outputs = np.searchsorted(edges, schedule.edges[schedule.outputs])
    return replace(schedule, edges=edges, pieces=pieces, outputs=outputs)
