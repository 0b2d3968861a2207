"""Compiled outputs beyond `trajectory.csv`: ends of sections, and what inlets deliver."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import compile, simulate
from viscodesign.errors import SpecError
from viscodesign.scene.scene import Scene

SHORT = "run={duration: 2 s, output_interval: 100 ms}"
ARCS = "effects={pressure_distribution: on, others: off}"
GAS = "effects={pressure_distribution: on, gas_compressibility: on, inertia: on, others: off}"
FREE = ["bellows.area_per_pressure", "gauge_pressure"]


@pytest.mark.parametrize("effects", [ARCS, GAS])
def test_they_are_those_of_a_simulation(effects: str) -> None:
    scene = leg(SHORT, effects, "gauge_pressure=2 kPa", config="leg_4_air")
    run = simulate(scene, verify=False)
    own = compile(
        scene, FREE, ["m1_x_m", "m1_z_m", "m2_x_m", "m2_z_m", "inflow_m3"], tolerance=1e-7
    )
    found = own()
    delivered = run["inflow"][:, 0]
    assert found["inflow_m3"] == pytest.approx(delivered, abs=1e-3 * np.ptp(delivered))
    points = (len(run.arc) - 1) // 2
    for k in (1, 2):
        for axis, name in enumerate("xz"):
            place = run.shape[:, k * points, axis]
            assert found[f"m{k}_{name}_m"] == pytest.approx(place, abs=1e-5)


def test_their_slopes_are_those_of_differences() -> None:
    scene = leg(SHORT, GAS, "gauge_pressure=2 kPa", config="leg_4_air")
    own = compile(scene, FREE, ["m1_x_m", "inflow_m3"], tolerance=1e-9)
    slopes, values = own.jacobian(), own.values
    for k, value in enumerate(values):
        change = np.zeros(2)
        change[k] = 1e-3 * value
        for name in own.outputs:
            wanted = (own(values + change)[name] - own(values - change)[name]) / (2 * change[k])
            largest = np.max(np.abs(wanted))
            assert slopes[name][:, k] == pytest.approx(wanted, abs=1e-4 * largest)


def test_inlets_that_share_a_network_deliver_what_cannot_be_told() -> None:
    two = leg(
        SHORT,
        "network={layout: custom, tubes: ["
        "{from: a, to: R1, length: 40 mm, radius: 0.4 mm},"
        "{from: R1, to: R2, length: 40 mm, radius: 0.4 mm},"
        "{from: b, to: L1, length: 40 mm, radius: 0.4 mm},"
        "{from: L1, to: L2, length: 40 mm, radius: 0.4 mm},"
        "{from: R2, to: L2, length: 40 mm, radius: 0.4 mm}]}",
        "input=null",
        "inputs={a: {kind: constant, value: 1 kPa}, b: {kind: constant, value: 2 kPa}}",
        config="leg_4_air",
    )
    with pytest.raises(SpecError, match="must be one of"):
        compile(two, ["bellows.area_per_pressure"], ["inflow_a_m3"])


def test_a_finer_mesh_can_be_asked_for() -> None:
    scene: Scene = leg(SHORT, config="leg_4_air")
    fine = compile(scene, ["bellows.area_per_pressure"], ["tip_x_m"], edges_per_section=6)
    assert fine.settings.edges_per_section == 6
    with pytest.raises(SpecError, match="edges_per_section: must be a whole number from 1"):
        compile(scene, ["bellows.area_per_pressure"], ["tip_x_m"], edges_per_section=0)
