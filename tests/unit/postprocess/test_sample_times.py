"""Solved times between outputs."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign.postprocess.sample_times import SAMPLING
from viscodesign.simulation.build_problem import schedule
from viscodesign.solve.problem import Problem

COUPLED = "effects={pressure_distribution: on, feedback: on, inertia: on, damping: on, others: off}"
NETWORK = "effects={pressure_distribution: on, others: off}"
JUMP = "input={kind: step, value: 1 kPa, time: 0.5 s}"
FEW = "run={duration: 2 s, output_times: [0, 0.3, 2]}"


def made(*changes: str) -> Problem:
    return problem_of(leg("bellows.count=4", *changes))


def test_integrable_works_need_looks_for_events_alone() -> None:
    plain, problem = schedule(leg("bellows.count=4", NETWORK, FEW)), made(NETWORK, FEW)
    edges, spacing = problem.schedule.edges, problem.equations.swing_time / SAMPLING.looks_per_swing
    assert np.isin(plain.edges, edges).all()
    assert np.max(np.diff(edges)) <= spacing * (1 + 1e-9)
    assert len(edges) <= 2.0 / spacing + len(plain.edges)


def test_outputs_close_enough_need_nothing_more() -> None:
    close = "run={duration: 2 s, output_interval: 0.02 s}"
    plain = schedule(leg("bellows.count=4", NETWORK, close))
    assert np.array_equal(made(NETWORK, close).schedule.edges, plain.edges)


@pytest.mark.parametrize("changes", [(), (JUMP,)])
def test_sampling_keeps_outputs_and_inputs(changes: tuple[str, ...]) -> None:
    plain = schedule(leg("bellows.count=4", COUPLED, FEW, *changes))
    problem = made(COUPLED, FEW, *changes)
    found, equations = problem.schedule, problem.equations
    assert np.array_equal(found.edges[found.outputs], plain.edges[plain.outputs])
    assert np.isin(plain.edges, found.edges).all()
    middles = (found.edges[:-1] + found.edges[1:]) / 2
    interval = np.searchsorted(plain.edges, middles) - 1
    every = np.arange(len(middles))
    assert np.array_equal(found.pieces[every], plain.pieces[interval])
    swing = equations.swing_time or 2.0
    assert np.max(np.diff(found.edges)) <= swing / SAMPLING.per_swing * (1 + 1e-9)
    assert len(found.edges) <= SAMPLING.max_samples


def test_samples_are_dense_after_jumps_only() -> None:
    edges = made(COUPLED, FEW, JUMP).schedule.edges
    gaps = np.diff(edges)
    behind = int(np.searchsorted(edges, 0.5))
    assert gaps[behind : behind + SAMPLING.grades] == pytest.approx(
        gaps[behind] * np.array([1.0, *2.0 ** np.arange(SAMPLING.grades - 1)])
    )
    assert gaps[0] > 100 * gaps[behind]
