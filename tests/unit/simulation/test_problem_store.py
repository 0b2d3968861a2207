"""What equal scenes share from one run to the next, and other scenes do not."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.effects.tip_displacements import TipDisplacements
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation import solve_once
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import ProblemStore

SHORT = ("run={duration: 0.2 s, output_interval: 0.05 s}", "bellows.count=4")
CHANGES = (
    "network.tube_length=41 mm",
    "input.fall_time=0.6 s",
    "run.duration=0.3 s",
    "accuracy=0.4 %",
    "effects.gravity=on",
    "loads.tip_force={x: -0.0 N, z: 1e-12 N}",
    "fluid=water",
)


@pytest.mark.parametrize("change", CHANGES)
def test_only_equal_scenes_have_one_digest(change: str) -> None:
    assert leg(*SHORT).digest == leg(*SHORT).digest
    assert leg(*SHORT).digest != leg(*SHORT, change).digest


def test_an_equal_scene_builds_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    first = simulate(leg(*SHORT), verify=False)
    monkeypatch.setattr(solve_once, "build", None)
    monkeypatch.setattr(solve_once, "equilibrium", None)
    again = simulate(leg(*SHORT), verify=False)
    assert np.array_equal(first.tip, again.tip)


def test_an_equal_scene_estimates_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    first = select_effects(SceneQuantities(leg(*SHORT, "effects=auto")))
    monkeypatch.setattr(TipDisplacements, "between", None)
    again = select_effects(SceneQuantities(leg(*SHORT, "effects=auto")))
    assert first.verdicts == again.verdicts


def test_a_start_cannot_be_changed_by_a_run() -> None:
    quantities = SceneQuantities(leg(*SHORT))
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    prepared = ProblemStore(2).problem(quantities, effects, settings)
    start = prepared.start(settings.tolerance, settings.solver)
    with pytest.raises(ValueError, match="read-only"):
        start.states[0] = 1.0
