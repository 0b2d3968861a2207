"""Pressures of the network alone, against exact solutions and another program."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg

from tests.scenes import chain_order, in_order, leg, reference
from viscodesign import Scene, simulate
from viscodesign.estimate.scene_quantities import SceneQuantities

ONE_WAY = "effects={pressure_distribution: on, others: off}"
FINE = "accuracy=0.001 %"
SHARE_OF_SWING = 1e-6


def exact_step_response(scene: Scene, times: np.ndarray, step: float) -> np.ndarray:
    """Pressures (T, B) after a step at t = 0 from zero, by the matrix exponential."""
    quantities = SceneQuantities(scene)
    graph = quantities.graph
    (component,) = graph.components()
    laplacian = quantities.laplacian(component)
    count = len(component.bellows)
    own, cross = laplacian[:count, :count], laplacian[:count, count:]
    inlet = np.zeros(len(laplacian))
    nodes = [*component.bellows, *component.junctions]
    for tube in graph.tubes:
        for end, other in ((tube.start, tube.end), (tube.end, tube.start)):
            if end in graph.inlets:
                inlet[nodes.index(other)] += step / quantities.resistances[tube.name]
    drive = inlet[:count]
    if component.junctions:
        solved = np.linalg.solve(
            laplacian[count:, count:], np.column_stack([cross.T, inlet[count:]])
        )
        own = own - cross @ solved[:, :-1]
        drive = drive - cross @ solved[:, -1]
    rates = own / quantities.bellow.compliance
    steady = np.linalg.solve(own, drive)
    return np.array([steady - scipy.linalg.expm(-rates * t) @ steady for t in times])


def tubes(*ends: str) -> str:
    """A custom network from 'a b 37.5' triples: ends and length in mm."""
    entries = []
    for entry in ends:
        start, end, length = entry.split()
        entries.append(f"{{from: {start}, to: {end}, length: {length} mm, radius: 0.325 mm}}")
    return "network={layout: custom, tubes: [" + ", ".join(entries) + "]}"


GRAPHS = {
    "chain": "network.layout=straight",
    "crossed": "network.layout=crossed",
    "tree": tubes("inlet j1 37.5", "j1 R1 20", "j1 j2 40", "j2 R2 10", "j2 L1 55", "R2 L2 37.5"),
    "loop": tubes(
        "inlet R1 37.5", "R1 R2 20", "R2 L2 40", "L2 L1 10", "L1 R1 55", "R2 L1 37.5", "R1 R2 80"
    ),
}
STEP = 1e4


@pytest.mark.parametrize("graph", GRAPHS)
def test_step_response_matches_the_matrix_exponential(graph: str) -> None:
    count = 4 if graph in ("tree", "loop") else 16
    scene = leg(
        f"bellows.count={count}",
        GRAPHS[graph],
        f"input={{kind: step, value: {STEP}}}",
        "run={duration: 2 s, output_interval: 0.1 s}",
        ONE_WAY,
        FINE,
    )
    found = simulate(scene)
    names = SceneQuantities(scene).graph.components()[0].bellows
    exact = exact_step_response(scene, found.time, STEP)
    error = in_order(found.pressure, found.bellows, list(names)) - exact
    assert found.status == "complete"
    # At t = 0 the tables have the state before the jump takes effect: zero, as expected.
    assert np.max(np.abs(error)) <= SHARE_OF_SWING * STEP
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8


def test_paper_pulse_through_16_bellows_from_rest() -> None:
    case = reference("network")["chain16_air_from_zero"]
    expected = np.array(case["pressure_pa"], dtype=float)
    scene = leg(
        "fluid={name: thin air, viscosity: 2e-5, density: 1.2}",
        f"run={{duration: 10 s, start: rest, output_times: {case['times_s']}}}",
        ONE_WAY,
        FINE,
    )
    found = simulate(scene)
    pressure = in_order(found.pressure, found.bellows, chain_order(8))
    assert np.max(np.abs(pressure - expected)) <= SHARE_OF_SWING * np.ptp(expected)


def test_paper_pulse_through_a_star_with_a_junction() -> None:
    case = reference("network")["star_air_equilibrated"]
    network, order = case["network"], case["node_order"]
    resistance = reference("network")["parameters"]["R_air"]
    names = dict(zip(order, ["j0", "R1", "R2", "R3", "L1", "L2"], strict=True)) | {"in": "inlet"}
    ends = [
        f"{names[e['a']]} {names[e['b']]} {37.5 * e['R'] / resistance!r}" for e in network["edges"]
    ]
    scene = leg(
        "bellows.count=6",
        tubes(*ends),
        "fluid={name: thin air, viscosity: 2e-5, density: 1.2}",
        f"run={{duration: 10 s, output_times: {case['times_s']}}}",
        ONE_WAY,
        FINE,
    )
    found = simulate(scene)
    expected = np.array(case["pressure_pa"], dtype=float)[:, 1:]
    pressure = in_order(found.pressure, found.bellows, [names[n] for n in order[1:]])
    assert np.max(np.abs(pressure - expected)) <= SHARE_OF_SWING * np.ptp(expected)


def test_pressures_obey_the_maximum_principle() -> None:
    found = simulate(
        leg("input={kind: square, high: 5 kPa, low: -3 kPa, frequency: 1 Hz}", ONE_WAY)
    )
    slack = 1e-3 * 8e3
    assert found.pressure.min() >= -3e3 - slack
    assert found.pressure.max() <= 5e3 + slack


def test_listing_tubes_in_another_order_changes_nothing() -> None:
    listed = ["inlet R1 37.5", "R1 R2 20", "R2 L2 40", "L2 L1 10", "L1 R1 55"]
    common = ("bellows.count=4", ONE_WAY, "run={duration: 1 s}", "accuracy=0.01 %")
    one = simulate(leg(*common, tubes(*listed)))
    other = simulate(leg(*common, tubes(*reversed(listed))))
    assert np.max(np.abs(one.tip - other.tip)) <= 1e-4 * 0.109
