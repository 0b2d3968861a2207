"""Linear networks by their modes: exact solutions, balances, and when they apply."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import COMPLIANCE, columns, only, resistance
from viscodesign import Scene, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import Settings, build, suggest_settings
from viscodesign.simulation.solve_once import Run, solve, tip_difference
from viscodesign.solve.solvers import modes
from viscodesign.solve.solvers.modes import LinearModes
from viscodesign.solve.transient import DEFAULT_SOLVER

ROUND_OFF = 1e-12
AIR = "fluid={name: thin, viscosity: 2e-5, density: 1.2}"
RATE = 1 / (resistance(2e-5) * COMPLIANCE)
"""Of a bellow behind one tube [1/s]."""
HALF = "{kind: constant, value: 0}"
RUN = "run={duration: 0.4 s, output_interval: 10 ms}"


def solved(scene: Scene, solver: str = "modes", tolerance: float = 1e-6) -> Run:
    quantities = SceneQuantities(scene)
    return solve(quantities, select_effects(quantities).effects, Settings(1, tolerance, solver))


def one_bellow(source: str, *more: str) -> tuple[np.ndarray, np.ndarray]:
    """Times and gauge pressure of a bellow, each of which has a tube to the inlet of its own."""
    run = solved(leg(*columns(8, source, HALF), AIR, RUN, only(), *more))
    assert run.solution.solver == "modes"
    assert run.is_complete
    return run.motion.time, run.motion.pressure[:, run.problem.bellows.index("L2")]


def test_step() -> None:
    time, found = one_bellow("{kind: step, value: 5 kPa}")
    assert found == pytest.approx(5e3 * -np.expm1(-RATE * time), abs=5e3 * ROUND_OFF)


def test_ramp() -> None:
    time, found = one_bellow("{kind: table, rows: [[0, 0], [0.4, 4 kPa]]}")
    exact = 1e4 * (time + np.expm1(-RATE * time) / RATE)
    assert found == pytest.approx(exact, abs=4e3 * ROUND_OFF)


@pytest.mark.parametrize("frequency", [0.7, 30.0, 900.0])
def test_sine(frequency: float) -> None:
    """From slow to dozens of periods between two outputs."""
    time, found = one_bellow(f"{{kind: sine, amplitude: 3 kPa, frequency: {frequency}}}")
    w = 2 * np.pi * frequency
    forced = RATE * np.sin(w * time) - w * np.cos(w * time) + w * np.exp(-RATE * time)
    exact = 3e3 * RATE * forced / (RATE**2 + w**2)
    assert found == pytest.approx(exact, abs=3e3 * ROUND_OFF)


@pytest.mark.parametrize("times", ["output_interval: 20 ms", "output_times: [0, 0.3, 0.31, 2]"])
def test_chain_of_bellows_against_the_matrix_exponential(times: str) -> None:
    scene = leg(AIR, only(), "input={kind: step, value: 5 kPa, time: 0.1}",
                f"run={{duration: 2 s, {times}}}")  # fmt: skip
    run = solved(scene)
    matrix = RATE * (np.diag(np.ones(15), 1) + np.diag(np.ones(15), -1) - 2 * np.eye(16))
    matrix[-1, -1] = -RATE
    since = np.maximum(run.motion.time - 0.1, 0.0)
    exact = 5e3 * (1 - np.array([expm(matrix * t).sum(axis=1) for t in since]))
    found = in_order(run.motion.pressure, run.problem.bellows, chain_order(8))
    assert np.max(np.abs(found - exact)) <= 5e3 * ROUND_OFF
    volume, energy = (
        run.motion.invariants.volume_imbalance_rel,
        run.motion.invariants.energy_imbalance_rel,
    )
    assert volume is not None
    assert volume <= 1e-13
    assert energy is not None
    assert energy <= 1e-8


def tubes(*ends: str) -> str:
    entries = (entry.split() for entry in ends)
    each = ", ".join(
        f"{{from: {a}, to: {b}, length: {length} mm, radius: 0.325 mm}}" for a, b, length in entries
    )
    return f"network={{layout: custom, tubes: [{each}]}}"


OTHERS = {
    "tree": ("bellows.count=8", AIR, RUN, only(), tubes("inlet j1 37.5", "j1 R1 20", "j1 j2 40", "j2 R2 10", "j2 L1 55", "R2 L2 37.5")),
    "sealed part": ("bellows.count=8", AIR, RUN, only(), tubes("inlet R1 37", "R1 R2 20", "L1 L2 30"), "gauge_pressure=2 kPa"),
    "two inlets": (*columns(8, "{kind: sine, amplitude: 3 kPa, frequency: 1}", "{kind: step, value: 4 kPa, time: 0.2}"), AIR, RUN, only()),
    "head": (RUN, only("gravity"), "fluid=water"),
    "inertance": (RUN, only("fluid_inertance"), "fluid=water"),
    "wide tube": (RUN, AIR, only(), "network.changes={R2-R3: {length: 37.5 nm}}"),
    "uneven outputs": (AIR, only(), "run={duration: 0.4 s, output_times: [0, 0.01, 0.037, 0.2, 0.2001, 0.4]}"),
    "at rest": (AIR, only(), "run={duration: 0.4 s, output_interval: 10 ms, start: rest}", "input={kind: constant, value: 2 kPa}"),
}  # fmt: skip


@pytest.mark.parametrize("case", OTHERS)
def test_other_networks_agree_with_the_default_solver(case: str) -> None:
    scene = leg(*OTHERS[case])
    found, other = solved(scene), solved(scene, DEFAULT_SOLVER, 1e-9)
    assert found.solution.solver == "modes"
    assert found.is_complete
    size = np.max(np.abs(other.motion.pressure))
    assert np.max(np.abs(found.motion.pressure - other.motion.pressure)) <= 1e-6 * size
    delivered = found.motion["inflow"] - other.motion["inflow"]
    assert np.max(np.abs(delivered)) <= 1e-6 * np.max(np.abs(other.motion["inflow"]), initial=1e-12)
    invariants = found.motion.invariants
    assert invariants.volume_imbalance_rel is None or invariants.volume_imbalance_rel <= 1e-12
    assert invariants.energy_imbalance_rel is None or invariants.energy_imbalance_rel <= 1e-7
    ends = found.solution.integrals[:, -1:], other.solution.integrals[:, -1:]
    assert ends[0] == pytest.approx(ends[1], rel=1e-6, abs=1e-9)


def test_memory_limits_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = leg(AIR, only(), "run={duration: 2 s, output_interval: 20 ms}")
    whole = solved(scene)
    monkeypatch.setattr(modes, "RULES", replace(modes.RULES, numbers_at_once=100))
    parts = solved(scene)
    assert tip_difference(whole.motion, parts.motion) <= 1e-13
    first, second = (run.motion.invariants.energy_imbalance_rel or 0.0 for run in (whole, parts))
    assert max(first, second) <= 1e-8


TAKEN = {
    "one-way": (only(), True),
    "gas": (only("gas_compressibility"), False),
    "flow regime": (only("flow_regime"), False),
    "loaded rod": ("effects={pressure_distribution: on, gravity: on, others: off}", False),
    "uniform pressure": ("effects={others: off}", False),
}  # fmt: skip


@pytest.mark.parametrize("case", TAKEN)
def test_linear_equations_are_recognised_by_their_formulas(case: str) -> None:
    effects, takes = TAKEN[case]
    scene = leg(effects, RUN, "loads.gravity=on")
    quantities = SceneQuantities(scene)
    chosen = select_effects(quantities).effects
    settings = suggest_settings(quantities, chosen)
    assert LinearModes.takes(build(quantities, chosen, settings)) is takes
    run = solve(quantities, chosen, settings)
    assert run.solution.solver == ("modes" if takes else settings.solver)
    assert run.is_exact_in_time is takes
    assert not run.solution.attempts


def test_a_solver_asked_for_by_name_is_kept() -> None:
    assert solved(leg(only(), RUN), DEFAULT_SOLVER).solution.solver == DEFAULT_SOLVER


def test_one_solution_suffices() -> None:
    found = simulate(leg(only(), RUN))
    assert found.status == "complete"
    assert found.settings["solver"] == "modes"
    assert found.accuracy.estimated_tip_error_m is not None
    assert found.accuracy.estimated_tip_error_m <= 1e-6 * 0.109
    assert found.cost.verify_s == 0.0


def test_a_scene_at_rest_stays_at_rest_to_the_last_digit() -> None:
    run = solved(leg(AIR, only(), RUN, "input={kind: constant, value: 60 kPa}"))
    assert np.all(run.motion.pressure == run.motion.pressure[0])
    assert np.all(run.solution.integrals == 0.0)
    assert np.all(run.motion["inflow"] == run.motion["inflow"][0])


def test_a_short_pulse_beside_an_input_that_jumps_is_not_missed() -> None:
    """A jump says nothing of how fast the other inlet swings, here within 2 ms of 2 s."""
    pulse = "{kind: double_sigmoid, start: 0, drop: -50 kPa, fall_time: 0.18, rise_time: 0.22, transition: 0.2 ms}"
    scene = leg(*columns(8, pulse, "{kind: step, value: 1 kPa, time: 1.5}"), AIR, only(),
                "run={duration: 2 s, output_times: [0, 0.2, 0.3, 2]}")  # fmt: skip
    run = solved(scene)
    found = run.motion.pressure[:, run.problem.bellows.index("L2")]
    rose = 5e4 * -np.expm1(-RATE * 0.02)
    assert found[1] == pytest.approx(rose, rel=1e-4)
    peak = 5e4 * -np.expm1(-RATE * 0.04)
    assert found[2] == pytest.approx(peak * np.exp(-RATE * 0.08), rel=1e-4)
