"""Actuators that share fluid against exact symmetry, an independent solution, and limits."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.coupled_specs import FLOW_ALONE, LEFT, RIGHT, SINE, coupled_spec, on_one_syringe
from tests.thorough import ALL
from viscodesign import SeveralRuns, load, load_several, simulate, simulate_several

TWO_AND_A_TUBE = [{"from": "left.L1", "to": "right.R1", "length": "50 mm", "radius": "1 mm"}]


@pytest.fixture(scope="module")
def syringe() -> SeveralRuns:
    """Two unequal legs under gravity on one syringe, with effects and error as they come."""
    return simulate_several(load_several(on_one_syringe(effects={"tube_compliance": "off"})))


def test_a_shared_syringe_gives_what_both_take_up(syringe: SeveralRuns) -> None:
    left, right = syringe["left"], syringe["right"]
    assert (left["inlet_pressure"] == right["inlet_pressure"]).all()
    (shared,) = syringe.coupled
    both = left.inflow["inlet"] + right.inflow["inlet"]
    assert np.abs(both - shared.inflow["A"]).max() < 1e-12 * np.ptp(both)
    assert np.ptp(both) > 1e-7
    # Boyle's law in the barrel: what has left it is there.
    area, ambient = math.pi * 0.015**2 / 4, 101325.0
    pushed = np.interp(left.time, [0, 0.6, 1.2], [0, 8e-3, 2e-3]) * area
    held = (area * 0.04 - pushed) * (1 + shared.inlet_pressure["A"] / ambient)
    filled = area * 0.04 * (1 + 20e3 / ambient)
    assert np.abs(held + both - filled).max() < 1e-5 * np.ptp(both)


def test_balances_and_error_are_those_of_the_whole(syringe: SeveralRuns) -> None:
    for run in syringe.runs.values():
        assert run.status == "complete"
        assert run.invariants.volume_imbalance_rel < 1e-8  # type: ignore[operator]
        assert run.invariants.energy_imbalance_rel < 1e-3  # type: ignore[operator]
        assert run.accuracy.requested_m == pytest.approx(0.005 * 0.022)
        assert run.accuracy.estimated_tip_error_m <= run.accuracy.requested_m  # type: ignore[operator]
    assert syringe["left"].effects == syringe["right"].effects


def test_each_moves_alone_as_it_does_among_others(syringe: SeveralRuns) -> None:
    """With the pressures of the run at its inlets, by the path of a single actuator."""
    for run in syringe.runs.values():
        alone = simulate(load(run.spec_text), verify=False)
        # Its inlet's pressure is straight between the outputs there.
        assert np.abs(alone.tip - run.tip)[:, :2].max() < 0.2 * run.accuracy.requested_m
        assert np.ptp(run.tip[:, :2], axis=0).max() > 2 * run.accuracy.requested_m


@pytest.mark.skipif(not ALL, reason="thorough")
def test_the_order_in_the_spec_changes_nothing(syringe: SeveralRuns) -> None:
    spec = on_one_syringe(effects={"tube_compliance": "off"})
    spec["actuators"] = dict(reversed(spec["actuators"].items()))
    again = simulate_several(load_several(spec), verify=False)
    for name, run in syringe.runs.items():
        assert np.abs(run.tip - again[name].tip)[:, :2].max() < run.accuracy.requested_m


def test_two_equal_ones_on_one_tube_are_one_on_half_of_it() -> None:
    """Each has half of the shared tube's flow: a tube of twice the length for one alone."""
    leg = copy.deepcopy(LEFT)
    effects = {**FLOW_ALONE, "gravity": "on", "damping": "on"}
    tubes = [
        {"from": "A", "to": "T", "length": "400 mm", "radius": "0.4 mm"},
        *({"from": "T", "to": f"{n}.R1", "length": "40 mm", "radius": "0.4 mm"}
          for n in ("left", "right")),
    ]  # fmt: skip
    pair = coupled_spec(actuators={"left": leg, "right": {"like": "left"}}, tubes=tubes,
                        effects=effects, accuracy="0.05 %")  # fmt: skip
    found = simulate_several(load_several(pair), verify=False)
    assert np.abs(found["left"].tip - found["right"].tip).max() < 1e-10
    single = {key: value for key, value in pair.items() if key not in ("actuators", "inputs")}
    chain = ["T", "R1", "R2", "L2", "L1"]
    sizes = [("40 mm", "0.4 mm"), *[("37.5 mm", "0.15 mm")] * 3]
    own = [{"from": "inlet", "to": "T", "length": "800 mm", "radius": "0.4 mm"}]
    own += [{"from": a, "to": b, "length": length, "radius": radius}
            for a, b, (length, radius) in zip(chain, chain[1:], sizes, strict=False)]  # fmt: skip
    del single["tubes"]
    one = simulate(
        load({**single, **leg, "input": SINE, "network": {"layout": "custom", "tubes": own}}),
        verify=False,
    )
    assert np.ptp(one.tip[:, 0]) > 1e-3
    assert np.abs(one.tip - found["left"].tip)[:, :2].max() < 2e-5  # of 40 mm: the accuracy
    assert np.abs(one.pressure - found["left"].pressure).max() < 5.0


def test_a_wide_tube_between_two_against_an_own_solution() -> None:
    """Pressures of six bellows by SciPy, and tips by the arcs that belong to them."""
    spec = coupled_spec(tubes=TWO_AND_A_TUBE, effects=FLOW_ALONE, accuracy="0.02 %",
                        loads={"gravity": "off"})  # fmt: skip
    spec["actuators"]["left"] = {**LEFT, "source": "A"}
    run = simulate_several(load_several(spec), verify=False)
    scene = load_several(spec).joined[0]
    time = run["left"].time
    pressure = _pressures(time, scene.fluid.viscosity)
    own = np.column_stack([run["left"].pressure, run["right"].pressure])
    assert np.abs(own - pressure[:, [0, 1, 3, 2, 4, 5]]).max() < 10.0  # of +-10 kPa
    for name, columns, numbers in (
        ("left", (0, 1, 3, 2), (1.8e6, 0.02)),
        ("right", (4, 5), (1.5e6, 0.022)),
    ):
        tip = _tips(pressure[:, columns], *numbers)
        assert np.abs(run[name].tip[:, :2] - tip).max() < 1e-5
        assert np.ptp(tip) > 1e-3
    assert np.ptp(own[:, 4]) > 500


def _pressures(time: np.ndarray, viscosity: float) -> np.ndarray:
    """Gauge pressures of left R1, R2, L2, L1, then right R1, L1 (T, 6) [Pa].

    Isothermal air in bellows of linear volume, Poiseuille flow between them.
    """
    ambient, base = 101325.0, 20e3
    length = np.array([18e-3] * 4 + [15e-3] * 2)
    rest, compliance = 10e-3 * 12e-3 * length, 3.413e-9 * length
    tube = [(0.0375, 0.15e-3)] * 4 + [(0.05, 1e-3), (0.0375, 0.18e-3)]
    resistance = np.array([8 * viscosity * own / (math.pi * radius**4) for own, radius in tube])

    def slope(t: float, p: np.ndarray) -> np.ndarray:
        nodes = np.concatenate([[base + 1e4 * math.sin(math.pi * t)], p])
        head = nodes + nodes**2 / (2 * ambient)
        flow = (head[:-1] - head[1:]) / resistance
        net = flow - np.append(flow[1:], 0.0)
        content = compliance * (1 + p / ambient) + (rest + compliance * p) / ambient
        return net / content

    found = solve_ivp(slope, (0.0, time[-1]), np.full(6, base), "Radau", time, rtol=1e-9,
                      atol=1e-5)  # fmt: skip
    return np.asarray(found.y.T)


def _tips(pressure: np.ndarray, modulus: float, section: float) -> np.ndarray:
    """Ends of arcs by the pressures (T, R1..RS, L1..LS) of sections, clamp first (T, 2) [m]."""
    count = pressure.shape[1] // 2
    if count == 1:
        section = 0.022
    place, angle = np.zeros((len(pressure), 2)), np.zeros(len(pressure))
    for j in range(count):
        right, left = pressure[:, j], pressure[:, count + j]
        turn = 10.266 * (left - right) / modulus
        chord = (section + 0.047 * (left + right) / modulus) * np.sinc(turn / 2 / np.pi)
        place += (chord * np.array([np.sin(angle + turn / 2), np.cos(angle + turn / 2)])).T
        angle = angle + turn
    return place


@pytest.mark.skipif(not ALL, reason="thorough")
def test_a_tube_that_lets_next_to_nothing_through_changes_nothing() -> None:
    thin = [{"from": "left.L1", "to": "right.L1", "length": "1 m", "radius": "10 um"}]
    spec = coupled_spec(tubes=thin, effects={**FLOW_ALONE, "gravity": "on"})
    for name in ("left", "right"):
        spec["actuators"][name] = {**spec["actuators"][name], "source": "A"}
    apart: dict[str, Any] = {key: value for key, value in spec.items() if key != "tubes"}
    found, single = (simulate_several(load_several(own), verify=False) for own in (spec, apart))
    assert found.coupled
    assert not single.coupled
    for name in ("left", "right"):
        assert np.abs(found[name].pressure - single[name].pressure).max() < 20.0
        assert np.abs(found[name].tip - single[name].tip)[:, :2].max() < 5e-5


def test_one_that_touches_a_wall_does_so_as_it_does_alone() -> None:
    """With the pressures of the run at its inlets, by the contact of a single actuator."""
    wall = {"kind": "line", "point": {"x": "-0.3 mm"}, "normal": "90 deg", "friction": 0.3}
    left = {**LEFT, "loads": {"gravity": "on", "ground": wall}}
    effects = {**FLOW_ALONE, "gravity": "on", "damping": "on"}
    spec = coupled_spec(actuators={"left": left, "right": RIGHT}, effects=effects)
    runs = simulate_several(load_several(spec), verify=False)
    assert [name for name in runs.frame() if "gap" in name] == ["left.contact_gap_m"]
    run, free = runs["left"], runs["right"]
    normal, gap = run["contact_normal"], run["contact_gap"]
    assert free.contacts == ()
    assert normal.max() > 0.1
    assert np.count_nonzero(normal) > 5
    assert gap.min() > -1e-12
    assert np.abs(normal * gap).max() < 1e-12
    assert np.all(np.abs(run["contact_tangential"]) <= 0.3 * normal + 1e-12)
    alone = simulate(load(run.spec_text), verify=False)
    assert alone.contacts == run.contacts
    assert np.abs(alone.tip - run.tip)[:, :2].max() < 0.2 * run.accuracy.requested_m
    assert np.abs(alone["contact_normal"] - normal).max() < 0.01 * normal.max()
