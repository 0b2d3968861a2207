"""Work integrals on a grid, and balances of runs that keep them."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.balances import ENERGY_NOISE, _trapezoids, _work

SHORT = ("bellows.count=4", "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}",
         "run={duration: 1 s, output_interval: 0.01 s}")  # fmt: skip


def column(values: np.ndarray) -> np.ndarray:
    return values[:, None]


def test_trapezoids_are_exact_for_straight_forces() -> None:
    time = np.array([0.0, 0.2, 0.5, 1.1])
    found = _trapezoids(column(2 + 3 * time), column(time), 1)
    assert found == pytest.approx(2 * time + 1.5 * time**2)


def test_work_is_exact_for_cubics_on_an_even_grid() -> None:
    time = np.linspace(0.0, 2.0, 17)
    best, noise = _work(column(time**3 - time), column(time))
    assert best == pytest.approx((time**4 / 4 - time**2 / 2)[::2], rel=1e-12, abs=1e-13)
    assert noise <= 1e-13


def test_work_adds_columns_and_follows_the_path() -> None:
    time = np.linspace(0.0, 1.0, 33)
    force = np.column_stack((np.ones(33), time))
    path = np.column_stack((np.sin(time), time))
    best, _ = _work(force, path)
    assert best == pytest.approx((np.sin(time) + time**2 / 2)[::2], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("count", [9, 33, 129])
def test_the_noise_bounds_the_error(count: int) -> None:
    time = np.linspace(0.0, 2 * np.pi, count)
    best, noise = _work(column(np.cos(time)), column(np.sin(time)))
    exact = (time / 2 + np.sin(2 * time) / 4)[::2]
    assert np.max(np.abs(best - exact)) <= 3 * noise
    assert noise <= 0.3 * (9 / count) ** 4


def test_a_loop_of_a_steady_force_costs_nothing() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 65)
    best, _ = _work(column(np.full(65, 7.0)), column(np.sin(angle)))
    assert best[-1] == pytest.approx(0.0, abs=1e-12)


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
def test_runs_keep_both_balances(effects: str) -> None:
    found = simulate(
        leg(*SHORT, f"effects={{{effects}, others: off}}", "accuracy=1e-3"), verify=False
    )
    assert found.status == "complete"
    balance = found.invariants
    assert balance.volume_imbalance_rel is not None
    assert balance.volume_imbalance_rel <= 1e-8
    assert balance.energy_imbalance_rel is not None
    assert balance.energy_imbalance_rel <= 2e-3


def test_too_few_outputs_tell_no_energy() -> None:
    few = simulate(
        leg(*SHORT, "run={duration: 1 s, output_times: [0, 1]}", "effects=off"), verify=False
    )
    assert few.invariants.energy_imbalance_rel is None
    assert few.invariants.volume_imbalance_rel is not None


def test_outputs_too_coarse_for_the_work_tell_no_energy() -> None:
    """Where one pressure is shared the work is integrated over the outputs."""

    gas = "effects={gas_compressibility: on, others: off}"
    wide = "input={kind: sine, amplitude: 30 kPa, frequency: 1 Hz}"

    def told(interval: float) -> float | None:
        run = f"run={{duration: 2 s, output_interval: {interval}}}"
        found = simulate(leg(*SHORT, wide, run, gas), verify=False)
        return found.invariants.energy_imbalance_rel

    assert told(0.2) is None
    fine = told(0.01)
    assert fine is not None
    assert fine <= 10 * ENERGY_NOISE


def test_a_standstill_is_in_balance() -> None:
    still = simulate(
        leg("bellows.count=4", "input={kind: constant, value: 1 kPa}", "run.duration=1 s",
            "effects={pressure_distribution: on, others: off}"),
        verify=False,
    )  # fmt: skip
    assert still.invariants.volume_imbalance_rel == pytest.approx(0.0, abs=1e-12)
    assert still.invariants.energy_imbalance_rel == pytest.approx(0.0, abs=1e-9)
