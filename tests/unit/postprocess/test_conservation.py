"""Balances of fluid and energy."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.conservation import Ledger
from viscodesign.postprocess.motion import read_motion
from viscodesign.postprocess.outputs import read_outputs
from viscodesign.postprocess.solved_edges import SolvedEdges
from viscodesign.results.trajectory import Invariants
from viscodesign.simulation.build_problem import build, suggest_settings
from viscodesign.solve.statics import equilibrium
from viscodesign.solve.transient import integrate

SHORT = ("bellows.count=4", "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}",
         "run={duration: 1 s, output_interval: 0.01 s}")  # fmt: skip


@pytest.mark.parametrize(
    "effects",
    [
        "pressure_distribution: on",
        "pressure_distribution: on, flow_regime: on, fluid_inertance: on",
        "pressure_distribution: on, collapse: on, gas_compressibility: on",
        "pressure_distribution: on, inertia: on, damping: on, fluid_mass: on",
        "gas_compressibility: on",
    ],
)
def test_fluid_and_energy_balances_hold(effects: str) -> None:
    found = simulate(
        leg(*SHORT, f"effects={{{effects}, others: off}}", "accuracy=1e-3"), verify=False
    )
    assert found.status == "complete"
    balance = found.invariants
    assert balance.volume_imbalance_rel is not None
    assert balance.volume_imbalance_rel <= 1e-8
    assert balance.energy_imbalance_rel is not None
    assert balance.energy_imbalance_rel <= 2e-3


@pytest.mark.parametrize(
    "effects",
    [
        "pressure_distribution: on",
        "gas_compressibility: on",
        "pressure_distribution: on, feedback: on, inertia: on, damping: on",
    ],
)
def test_balances_do_not_depend_on_output_times(effects: str) -> None:
    """Two outputs give the balances of many."""

    def told(outputs: str) -> Invariants:
        run = f"run={{duration: 1 s, {outputs}}}"
        scene = leg(*SHORT, run, f"effects={{{effects}, others: off}}")
        return simulate(scene, verify=False, tolerance=1e-6).invariants

    few, many = told("output_times: [0, 1]"), told("output_interval: 0.01 s")
    for found in (few, many):
        assert found.energy_imbalance_rel is not None
        assert found.energy_imbalance_rel <= 2e-3
    if many.coupling_work_j is not None:
        assert few.coupling_work_j == pytest.approx(many.coupling_work_j, rel=1e-3)


def test_balances_do_not_depend_on_block_sizes() -> None:
    """Rows added in blocks of any length, across corners, give the same balances."""
    pulses = "input={kind: square, low: 0, high: 3 kPa, frequency: 4 Hz}"
    effects = "effects={inertia: on, damping: on, feedback: on, others: off}"
    quantities = SceneQuantities(leg(*SHORT, pulses, effects))
    chosen = select_effects(quantities).effects
    settings = suggest_settings(quantities, chosen)
    problem = build(quantities, chosen, settings)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    found = integrate(problem, start, settings.tolerance)
    wanted = read_motion(problem, found).invariants
    rows = next(read_outputs(problem, found)).values
    for length in (1, 2, 7, 50):
        ledger = Ledger(problem)
        for k in range(0, found.reached, length):
            cut = slice(k, k + length)
            told = {name: values[cut] for name, values in rows.items()}
            unknowns = found.states[:, cut], found.algebraics[:, cut]
            ledger.add(SolvedEdges(k, *unknowns, found.integrals[:, cut], told))
        again = ledger.invariants(found.work.steps)
        assert again.energy_imbalance_rel == pytest.approx(wanted.energy_imbalance_rel, rel=1e-6)
        assert again.coupling_work_j == pytest.approx(wanted.coupling_work_j, rel=1e-9)
        assert again.volume_imbalance_rel == wanted.volume_imbalance_rel


def test_a_run_at_rest_is_balanced() -> None:
    still = simulate(
        leg("bellows.count=4", "input={kind: constant, value: 1 kPa}", "run.duration=1 s",
            "effects={pressure_distribution: on, others: off}"),
        verify=False,
    )  # fmt: skip
    assert still.invariants.volume_imbalance_rel == pytest.approx(0.0, abs=1e-12)
    assert still.invariants.energy_imbalance_rel == pytest.approx(0.0, abs=1e-9)
