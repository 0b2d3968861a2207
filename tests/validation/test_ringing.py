"""Scenes that ring, in which estimates made before the solution miss what an effect does."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import CONFIGS, DATA
from viscodesign import Trajectory, load, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import Settings, suggest_settings
from viscodesign.simulation.judged_effects import JUDGING, coarser
from viscodesign.simulation.solve_once import solve, tip_difference

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


SWINGS_LONG = {
    "actuator.length": "82 mm", "bellows.count": 6, "network.layout": "straight", "fluid": "air",
    "actuator.youngs_modulus": "2.47 MPa", "actuator.damping_time": "0.028 ms",
    "network.tube_radius": "1.12 mm", "network.tube_length": "43.7 mm", "loads.gravity": "on",
    "input": {"kind": "step", "value": "1.1 kPa", "time": "0.2445 s"},
    "run.duration": "3.2 s", "run.output_interval": "16 ms", "accuracy": 0.003,
}  # fmt: skip


def test_what_shifts_a_frequency_is_measured_where_the_rod_rings() -> None:
    """Over 124 swings, which coarse solutions damp: alone, they would tell too little."""
    path = CONFIGS / "leg_16_straight_air_auto.yaml"
    run = simulate(load(path, SWINGS_LONG))
    stated, omitted = run.accuracy.estimated_tip_error_m, run.accuracy.omitted_m
    assert stated is not None
    assert omitted is not None
    scene = SceneQuantities(load(path, {**SWINGS_LONG, "effects": {"others": "on"}}))
    effects = select_effects(scene).effects
    edges, tolerance = run.settings["edges_per_section"], run.settings["tolerance"]
    fine = Settings(2 * edges, tolerance / 100)
    reference = solve(scene, effects, fine).motion.tip[:, :2]
    true = float(np.max(np.hypot(*(run.tip[:, :2] - reference).T)))
    assert 0.3 * stated < true < stated <= run.accuracy.requested_m
    # As coarse as the first solution with everything, the neglected effects seem to do less.
    chosen = select_effects(SceneQuantities(load(path, SWINGS_LONG)))
    assert {v.name for v in run.effects if v.taken} == chosen.active
    first = coarser(suggest_settings(scene, chosen.effects))
    few, all_of_them = (solve(scene, own, first) for own in (chosen.effects, effects))
    hidden = JUDGING.stated_per_told_apart * tip_difference(few.motion, all_of_them.motion)
    assert hidden < 0.6 * omitted
