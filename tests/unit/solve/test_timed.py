"""Integrals of formulas of the time."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.build import build, suggest_settings
from viscodesign.effects.conditions import Conditions
from viscodesign.effects.select import select_effects
from viscodesign.solve.timed import timed_integrals

AMPLITUDE, COMPLIANCE, COUNT = 3e3, 0.018 * 3.413e-9, 4


@pytest.mark.parametrize("outputs", ["output_times: [0, 0.9]", "output_interval: 0.05 s"])
def test_work_of_a_source_on_linear_bellows(outputs: str) -> None:
    """One pressure p = P sin(omega t) for all does n C p^2/2, however far apart the edges are."""
    scene = leg(
        f"bellows.count={COUNT}",
        f"input={{kind: sine, amplitude: {AMPLITUDE!r}, frequency: 1 Hz}}",
        f"run={{duration: 0.9 s, {outputs}}}",
        "effects={others: off}",
    )
    conditions = Conditions(scene)
    effects = select_effects(conditions).effects
    problem = build(conditions, effects, suggest_settings(conditions, effects))
    edges, size = problem.schedule.edges, problem.equations.energy_size
    names = list(problem.equations.rates)
    found = timed_integrals(problem, 0, len(edges) - 1)[names.index("pump")] * size
    pressure = AMPLITUDE * np.sin(2 * np.pi * edges[1:])
    assert found == pytest.approx(COUNT * COMPLIANCE * pressure**2 / 2, rel=1e-7, abs=1e-12)
    # A later stretch goes on from where it begins.
    if len(edges) > 3:
        late = timed_integrals(problem, 3, len(edges) - 4)[names.index("pump")] * size
        assert late == pytest.approx(found[3:] - found[2], rel=1e-7, abs=1e-12)
