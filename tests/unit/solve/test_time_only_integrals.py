"""Integrals of rates that depend on time alone."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign.solve.problem import Problem
from viscodesign.solve.time_only_integrals import timed_integrals

AMPLITUDE, COMPLIANCE, COUNT = 3e3, 0.018 * 3.413e-9, 4


def pump_work(problem: Problem, first: int) -> np.ndarray:
    """Integrals from an edge to each of the following ones [J]."""
    row = list(problem.equations.rates).index("pump")
    count = len(problem.schedule.edges) - 1 - first
    return timed_integrals(problem, first, count)[row] * problem.equations.energy_size


@pytest.mark.parametrize("outputs", ["output_times: [0, 0.9]", "output_interval: 0.05 s"])
def test_work_of_a_source_on_linear_bellows(outputs: str) -> None:
    """One pressure p = P sin(omega t) for all does n C p^2/2, however far apart the edges are."""
    scene = leg(
        f"bellows.count={COUNT}",
        f"input={{kind: sine, amplitude: {AMPLITUDE!r}, frequency: 1 Hz}}",
        f"run={{duration: 0.9 s, {outputs}}}",
        "effects={others: off}",
    )
    problem = problem_of(scene)
    edges = problem.schedule.edges
    found = pump_work(problem, 0)
    pressure = AMPLITUDE * np.sin(2 * np.pi * edges[1:])
    assert found == pytest.approx(COUNT * COMPLIANCE * pressure**2 / 2, rel=1e-7, abs=1e-12)
    # A later stretch goes on from where it begins.
    if len(edges) > 3:
        assert pump_work(problem, 3) == pytest.approx(found[3:] - found[2], rel=1e-7, abs=1e-12)


def test_a_pulse_much_shorter_than_its_interval() -> None:
    """It comes back to where it began: p has done no work, whatever the curve between."""
    pulse = (
        "input={kind: double_sigmoid, start: 0, drop: 3 kPa, fall_time: 1 ms, rise_time: 1.2 ms, "
        "transition: 1 us}"
    )
    scene = leg(
        f"bellows.count={COUNT}",
        pulse,
        "run={duration: 10 s, output_times: [1.1 ms, 10 s]}",
        "effects={others: off}",
    )
    problem = problem_of(scene)
    edges = problem.schedule.edges
    found = pump_work(problem, 0)
    inside = found[np.searchsorted(edges, 1.1e-3) - 1]
    assert inside == pytest.approx(COUNT * COMPLIANCE * 3e3**2 / 2, rel=1e-7)
    assert found[-1] == pytest.approx(0.0, abs=1e-7 * inside)
