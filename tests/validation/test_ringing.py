"""Scenes that ring, in which estimates made before the solution miss what an effect does."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import DATA
from viscodesign import Trajectory, load, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities

MISSED = {
    # A water hammer that the bellows answer; a payload at the first natural frequency.
    "ringing_soft_tubes": "feedback",
    "ringing_light": "fluid_mass",
}


def distance(one: Trajectory, other: Trajectory) -> float:
    """Largest distance of two tips [m]."""
    apart = one.tip[:, :2] - other.tip[:, :2]
    return float(np.max(np.hypot(apart[:, 0], apart[:, 1])))


@pytest.mark.parametrize(("name", "missed"), MISSED.items())
def test_the_motion_calls_for_what_the_estimates_miss(name: str, missed: str) -> None:
    path = DATA / f"{name}.yaml"
    first = select_effects(SceneQuantities(load(path)))
    assert missed not in first.active
    found, everything = simulate(load(path)), simulate(load(path, ["effects={others: on}"]))
    assert found.status == everything.status == "complete"
    assert missed in {verdict.name for verdict in found.effects if verdict.taken}
    assert any("the effects left out together move the tip by" in a.reason for a in found.ladder)
    stated = found.accuracy.estimated_tip_error_m
    assert stated is not None
    assert distance(found, everything) <= stated <= found.accuracy.requested_m
    # Without it the accuracy is missed.
    lacking = simulate(load(path, [f"effects={{others: auto, {missed}: off}}"]), verify=False)
    assert distance(lacking, everything) > found.accuracy.requested_m
