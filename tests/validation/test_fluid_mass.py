"""The mass of the fluid: its weight, its head, and what it adds to the inertia."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import LEG_EI, LEG_LENGTH, LEG_MASS_PER_LENGTH, STILL, leg
from tests.validation.rc_network import COMPLIANCE, REST_VOLUME, outputs, two_columns
from tests.validation.ringing import fitted_frequencies, rayleigh_frequencies
from viscodesign import simulate

DENSITY = 1000.0
LIQUID = f"fluid={{name: plain liquid, viscosity: 1e-3, density: {DENSITY}}}"
FLUID_PER_LENGTH = 16 * REST_VOLUME * DENSITY / LEG_LENGTH
"""Of 16 bellows [kg/m], more than the body's own."""
MASS = LEG_MASS_PER_LENGTH + FLUID_PER_LENGTH


@pytest.mark.parametrize("fluid", [True, False])
def test_horizontal_leg_sags_under_the_weight_of_body_and_fluid(fluid: bool) -> None:
    """m g l^4/(8 EI) and m g l^3/(6 EI): a uniform load on a cantilever, small deflection."""
    gravity = 1e-2
    mass = MASS if fluid else LEG_MASS_PER_LENGTH
    found = simulate(
        leg(
            STILL,
            LIQUID,
            f"loads.gravity={{acceleration: {gravity}, tilt: 90 deg}}",
            "run={duration: 0.1 s}",
            f"effects={{gravity: on, fluid_mass: {'on' if fluid else 'off'}, others: off}}",
            "accuracy=1e-6",
        ),
        verify=False,
    )
    load = mass * gravity * LEG_LENGTH**3 / LEG_EI
    assert found.tip[-1, 0] == pytest.approx(load * LEG_LENGTH / 8, rel=1e-4)
    assert found.tip[-1, 2] == pytest.approx(load / 6, rel=1e-4)


@pytest.mark.parametrize("tilt", [0.0, 60.0])
@pytest.mark.parametrize("distribution", ["on", "off"])
def test_pressure_at_rest_grows_downwards(tilt: float, distribution: str) -> None:
    """rho g times the depth of a section's middle below the clamp, in a leg too stiff to move."""
    found = simulate(
        leg(
            STILL,
            LIQUID,
            "actuator.youngs_modulus=1e12",
            f"loads.gravity={{tilt: {tilt} deg}}",
            "run={duration: 0.1 s}",
            f"effects={{gravity: on, fluid_mass: on, pressure_distribution: {distribution}, "
            "others: off}",
            "accuracy=1e-6",
        ),
        verify=False,
    )
    assert found.status == "complete", found.failure
    middles = (np.arange(8) + 0.5) / 8 * LEG_LENGTH
    head = DENSITY * 9.80665 * np.cos(np.radians(tilt)) * middles
    # At rest from the start: the head is in equilibrium with the inlet at the clamp.
    for row in (0, -1):
        assert found.pressure[row] == pytest.approx(np.tile(head, 2), abs=2e-4 * head.max())


@pytest.mark.parametrize("pressure", [0.0, 2e4, -2e4])
def test_fluid_lowers_the_frequency(pressure: float) -> None:
    """A pascal more on the left lets the leg ring: with the mass that its bellows then hold.

    Equal pressures stretch it. Curvature, stiffness and mass are per reference length; a
    stretch lengthens the arms of forces and moves the axis farther, so that with the
    slope y' of the axis EI y'''' = -stretch^2 m y_tt.
    """
    held = 16 * (REST_VOLUME + COMPLIANCE * pressure) * DENSITY / LEG_LENGTH
    stretch = 1 + 8 * 0.047 * 2 * pressure / 1.8e6 / LEG_LENGTH
    unit = np.sqrt(LEG_EI / (LEG_MASS_PER_LENGTH + held)) / LEG_LENGTH**2 / stretch
    exact = rayleigh_frequencies(1e-7, 4)
    times = np.linspace(0.0, 3 * 2 * np.pi / exact[0] / unit, 301)[1:]
    found = simulate(
        leg(
            *two_columns(16, pressure, pressure),
            f"gauge_pressure={pressure!r}",
            "inputs={left: {kind: step, value: 1}, right: {kind: constant, value: 0}}",
            LIQUID,
            "actuator.damping_time=0",
            outputs(times),
            "effects={inertia: on, fluid_mass: on, others: off}",
            "accuracy=5e-5",
        ),
        verify=False,
        tolerance=1e-9,
    )
    assert found.status == "complete", found.failure
    tip = found.tip[:, 0]
    # It rings like an undamped mode, between zero and twice the steady deflection.
    steady = 10.266 * 8 / 1.8e6 * LEG_LENGTH / 2 * stretch
    assert tip.max() == pytest.approx(2 * steady, rel=0.2)
    assert abs(tip.min()) <= 0.2 * steady
    rung = fitted_frequencies(times, tip, exact * unit) / unit
    assert rung[:2] == pytest.approx(exact[:2], rel=1e-4)
