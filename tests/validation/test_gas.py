"""Gas whose mass is conserved, against an independent integrator and closed forms.

Ideal gas: rho/rho_0 = (P/P_0)^(1/n); Hagen-Poiseuille in every slice of a tube, so that
mass flow follows the integral of the density over pressure.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import (
    AMBIENT,
    COMPLIANCE,
    REST_VOLUME,
    Network,
    chain,
    only,
    outputs,
    resistance,
    sine,
    step_response,
    worst,
)
from viscodesign import simulate

VISCOSITY = 2e-4
GAS = only("gas_compressibility")
FINE = "accuracy=1e-6"
TIMES = np.linspace(0.02, 1.0, 50)


def fluid(exponent: float) -> str:
    return (
        f"fluid={{name: thick gas, viscosity: {VISCOSITY}, density: 1.2, "
        f"gas_constant: 287.05, polytropic_exponent: {exponent!r}}}"
    )


def ratio(pressure: np.ndarray, exponent: float) -> np.ndarray:
    return np.asarray((1 + pressure / AMBIENT) ** (1 / exponent))


def drive(pressure: np.ndarray, exponent: float) -> np.ndarray:
    """Integral of the density ratio over pressure [Pa]."""
    power = 1 + 1 / exponent
    return np.asarray(AMBIENT / power * (1 + pressure / AMBIENT) ** power)


def network(exponent: float, ambient: float = AMBIENT) -> Network:
    """Four bellows in a row; d(V rho)/dp written out."""

    def stiffness(pressure: np.ndarray) -> np.ndarray:
        volume = REST_VOLUME + COMPLIANCE * pressure
        density = (1 + pressure / ambient) ** (1 / exponent)
        return np.asarray(density * (COMPLIANCE + volume / (exponent * (ambient + pressure))))

    def flow(before: np.ndarray, after: np.ndarray) -> np.ndarray:
        power = 1 + 1 / exponent
        ends = [ambient / power * (1 + p / ambient) ** power for p in (before, after)]
        return np.asarray((ends[0] - ends[1]) / resistance(VISCOSITY))

    return Network(chain(4), stiffness, flow)


def test_reference_approaches_the_incompressible_network() -> None:
    """Under a huge ambient pressure the gas is stiff: the matrix exponential is exact."""
    ambient, step = 1e13, 1e4
    found = network(1.0, ambient).follow(lambda t: step, np.zeros(4), TIMES)
    rate = (np.diag([-2.0, -2, -2, -1]) + np.eye(4, k=1) + np.eye(4, k=-1)) / (
        resistance(VISCOSITY) * COMPLIANCE
    )
    exact = step_response(rate, -rate @ np.full(4, step), TIMES)
    assert worst(found, exact) <= 1e-6


def test_reference_conserves_mass() -> None:
    """The same in terms of masses instead of pressures, which follow from a quadratic."""
    _, inlet = sine(5e3, 3e4, 1.0)
    gas = network(1.0)
    pressure = gas.follow(inlet, np.full(4, inlet(0.0)), TIMES)

    def of_mass(stored: np.ndarray) -> np.ndarray:
        linear = REST_VOLUME + COMPLIANCE * AMBIENT
        constant = AMBIENT * (REST_VOLUME - stored)
        return np.asarray(
            (-linear + np.sqrt(linear**2 - 4 * COMPLIANCE * constant)) / (2 * COMPLIANCE)
        )

    def mass(p: np.ndarray) -> np.ndarray:
        return np.asarray((REST_VOLUME + COMPLIANCE * p) * (1 + p / AMBIENT))

    assert of_mass(mass(pressure)) == pytest.approx(pressure, rel=1e-9, abs=1e-6)
    fine = np.linspace(0.0, 0.5, 2001)
    fine_pressure = gas.follow(inlet, np.full(4, inlet(0.0)), fine)
    into = (drive(np.array([inlet(t) for t in fine]), 1.0) - drive(fine_pressure[:, 0], 1.0)) / (
        resistance(VISCOSITY)
    )
    total = mass(fine_pressure).sum(axis=1)
    flowed = np.trapezoid(into, fine)
    assert total[-1] - total[0] == pytest.approx(flowed, rel=1e-5)


@pytest.mark.parametrize("exponent", [1.0, 1.4])
def test_gas_in_a_chain_follows_the_reference(exponent: float) -> None:
    words, inlet = sine(5e3, 3e4, 1.0)
    scene = leg("bellows.count=4", words, fluid(exponent), outputs(TIMES), GAS, FINE)
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    expected = network(exponent).follow(inlet, np.full(4, inlet(0.0)), TIMES)
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert worst(pressure, expected) <= 1e-5
    # The comparison sees the gas: without it the pressures differ a thousand times as much.
    plain = simulate(leg("bellows.count=4", words, fluid(exponent), outputs(TIMES), only()))
    assert worst(in_order(plain.pressure, plain.bellows, chain_order(2)), expected) >= 1e-2
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8


@pytest.mark.parametrize("exponent", [1.0, 1.3])
@pytest.mark.parametrize("middle", ["R1", "joint"])
def test_steady_flow_from_one_source_to_another(exponent: float, middle: str) -> None:
    """Halfway, the integral of the density is the mean: for n = 1 the root mean square of P."""
    high, low = 6e4, -5e4
    more = ", {from: joint, to: R1, length: 37.5 mm}" if middle == "joint" else ""
    scene = leg(
        "bellows.count=2",
        "network={layout: custom, tube_radius: 0.325 mm, tube_length: 37.5 mm, tubes: ["
        f"{{from: a, to: {middle}}}, {{from: {middle}, to: b}}{more}]}}",
        "input=null",
        f"inputs={{a: {{kind: constant, value: {high}}}, b: {{kind: constant, value: {low}}}}}",
        fluid(exponent),
        "run={duration: 0.1 s}",
        GAS,
        FINE,
    )
    found = simulate(scene, verify=False)
    power = 1 + 1 / exponent
    between = (((AMBIENT + high) ** power + (AMBIENT + low) ** power) / 2) ** (1 / power) - AMBIENT
    assert found.pressure[:, 0] == pytest.approx(between, rel=1e-6)
    flow = (drive(np.array(high), exponent) - drive(np.array(low), exponent)) / (
        2 * resistance(VISCOSITY)
    )
    assert found.flow[:, 0] == pytest.approx(float(flow), rel=1e-6)
    assert found.flow[:, 1] == pytest.approx(float(flow), rel=1e-6)
