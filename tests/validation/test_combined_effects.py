"""Network effects combined in one scene, against an independent integrator."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import (
    AMBIENT,
    COMPLIANCE,
    REST_VOLUME,
    TUBE,
    Network,
    chain,
    only,
    outputs,
    resistance,
    worst,
)
from tests.validation.test_collapse import followed, followed_slope, pulse
from tests.validation.test_flow_regime import DENSITY, fluid, loss
from viscodesign import simulate

FINE = "accuracy=1e-6"


def ringing_bellow(
    radius: float, step: float, lost: Callable[[float], float], times: np.ndarray
) -> np.ndarray:
    """Pressure (T,) of one bellow behind one tube with the loss ``lost`` of its flow."""
    inertance = 4 / 3 * DENSITY * TUBE / (np.pi * radius**2)
    size = step * np.sqrt(COMPLIANCE / inertance)

    def rate(t: float, y: np.ndarray) -> list[float]:
        pressure, flow = y[0] * step, y[1] * size
        speeding = step - pressure - lost(flow)
        return [flow / COMPLIANCE / step, speeding / inertance / size]

    found = solve_ivp(
        rate, (0.0, times[-1]), [0.0, 0.0], "DOP853", t_eval=times, rtol=1e-10, atol=1e-12
    )
    assert found.success, found.message
    return np.asarray(found.y[0] * step)


@pytest.mark.parametrize("viscosity", [1e-5, 1e-3])
def test_turbulence_damps_a_ringing_bellow(viscosity: float) -> None:
    """I dq/dt = p_a - p_b - loss(q), from laminar flow far into the turbulent range."""
    radius, step = 2e-3, 1e4
    period = 2 * np.pi * np.sqrt(4 / 3 * DENSITY * TUBE / (np.pi * radius**2) * COMPLIANCE)
    times = np.linspace(0.05, 4.0, 80) * period
    scene = leg(
        "bellows.count=2",
        f"network={{layout: custom, tube_radius: {radius}, tube_length: {TUBE}, "
        "tubes: [{from: inlet, to: R1}, {from: inlet, to: L1}]}",
        f"input={{kind: step, value: {step}}}",
        fluid(viscosity),
        outputs(times, "rest"),
        only("fluid_inertance", "flow_regime"),
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    expected = ringing_bellow(radius, step, lambda q: loss(q, viscosity, TUBE, radius, 1.5), times)
    assert np.max(np.abs(found.pressure - expected[:, None])) <= 2e-5 * step
    slow = ringing_bellow(radius, step, lambda q: resistance(viscosity, TUBE, radius) * q, times)
    assert np.max(np.abs(slow - expected)) >= 0.1 * step


def test_gas_in_bellows_that_collapse_under_the_published_pulse() -> None:
    """Down to 435 Pa absolute: mass is (V_0 + C p_e) P/P_0, and the flow of a tube follows P^2."""
    viscosity, fraction, times = 4e-4, 0.1, np.linspace(0.05, 8.0, 160)

    def stiffness(p: np.ndarray) -> np.ndarray:
        volume = REST_VOLUME + COMPLIANCE * followed(p, fraction)
        opening = COMPLIANCE * followed_slope(p, fraction)
        return np.asarray((volume + opening * (AMBIENT + p)) / AMBIENT)

    def flow(before: np.ndarray, after: np.ndarray) -> np.ndarray:
        squares = (AMBIENT + before) ** 2 - (AMBIENT + after) ** 2
        return np.asarray(squares / (2 * AMBIENT * resistance(viscosity)))

    expected = Network(chain(4), stiffness, flow).follow(pulse, np.full(4, pulse(0.0)), times)
    scene = leg(
        "bellows.count=4",
        f"fluid={{name: thick gas, viscosity: {viscosity}, density: 1.2, gas_constant: 287.05}}",
        outputs(times),
        only("gas_compressibility", "collapse"),
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert worst(pressure, expected) <= 1e-5
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8
    assert found.pressure.min() < -6e4
    assert found.volume.min() > fraction * REST_VOLUME
