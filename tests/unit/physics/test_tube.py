"""Tubes: friction, losses at their ends, inertance and soft walls, at their limits."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from viscodesign.physics import tube


def test_slow_flow_is_laminar() -> None:
    assert tube.friction_multiplier(np.array([0.0, 1e-9, 1.0, 100.0])) == pytest.approx(
        np.ones(4), abs=1e-9
    )
    assert tube.friction_multiplier(np.array([1000.0, 2000.0])) == pytest.approx(
        np.ones(2), abs=3e-3
    )


@pytest.mark.parametrize("reynolds", [1e4, 1e5, 1e6])
def test_fast_flow_matches_a_smooth_pipe(reynolds: float) -> None:
    """Prandtl and Karman: 1/sqrt(f) = 2 log10(Re sqrt(f)) - 0.8, to a few percent."""
    root = 0.1
    for _ in range(100):
        root = 1 / (2 * math.log10(reynolds * root) - 0.8)
    found = float(tube.friction_multiplier(reynolds)) * 64 / reynolds
    assert found == pytest.approx(root**2, rel=0.03)


def test_friction_matches_blasius_at_moderate_reynolds_numbers() -> None:
    found = float(tube.friction_multiplier(2e4)) * 64 / 2e4
    assert found == pytest.approx(0.316 * 2e4**-0.25, rel=0.03)


def test_friction_never_decreases() -> None:
    reynolds = np.geomspace(1e-3, 1e7, 2000)
    found = tube.friction_multiplier(reynolds)
    assert np.all(np.isfinite(found))
    assert np.all(np.diff(found) >= -1e-12)


@pytest.mark.parametrize("reynolds", [0.0, 1e-6, 0.999, 1.0, 7.0, 2300.0, 1e7])
def test_numbers_and_symbols_agree_in_value_and_slope(reynolds: float) -> None:
    """Also where logarithms of small numbers would overflow."""
    re = ca.SX.sym("re")
    law = tube.friction_multiplier(re, ca)
    value, slope = ca.Function("law", [re], [law, ca.jacobian(law, re)])(reynolds)
    assert float(value) == pytest.approx(float(tube.friction_multiplier(reynolds)), rel=1e-12)
    assert math.isfinite(float(slope))
    assert float(slope) >= -1e-12


def test_end_losses_are_dynamic_pressures() -> None:
    density, radius, flow = 1000.0, 1e-3, 2e-6
    speed = flow / (math.pi * radius**2)
    found = tube.local_loss_coefficient(density, 1.5, radius) * flow**2
    assert found == pytest.approx(1.5 * density * speed**2 / 2)
    assert tube.local_loss_coefficient(density, 0.0, radius) == 0.0


def test_inertance_includes_the_factor_of_the_parabolic_profile() -> None:
    density, length, radius = 998.0, 0.5, 1e-3
    area = math.pi * radius**2
    across = np.linspace(0.0, 1.0, 100_001)
    profile = 2 * (1 - across**2)
    momentum = np.trapezoid(profile**2 * 2 * across, across)
    assert momentum == pytest.approx(4 / 3, rel=1e-8)
    mass = density * tube.inner_volume(length, radius)
    assert tube.fluid_inertance(density, length, radius) == pytest.approx(momentum * mass / area**2)


def test_inertance_over_resistance_is_the_profile_time() -> None:
    """(4/3) rho r^2/(8 mu), whatever the length."""
    density, viscosity, radius = 998.0, 1e-3, 1e-3
    for length in (0.01, 1.0):
        ratio = tube.fluid_inertance(density, length, radius) / tube.hydraulic_resistance(
            viscosity, length, radius
        )
        assert ratio == pytest.approx(density * radius**2 / (6 * viscosity))


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_a_thin_wall_matches_hoop_stress(poisson: float) -> None:
    modulus, length, radius = 1e6, 0.1, 1e-3
    for thickness, close in ((1e-5, 0.02), (1e-7, 2e-4)):
        hoop = 2 * math.pi * radius**3 * length * (1 - poisson**2) / (modulus * thickness)
        found = tube.wall_compliance(modulus, poisson, thickness, length, radius)
        assert found == pytest.approx(hoop, rel=close)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_an_infinitely_thick_wall_matches_a_hole_in_a_block(poisson: float) -> None:
    """The radius of a hole grows by p r (1 + nu)/E."""
    modulus, length, radius = 1e6, 0.1, 1e-3
    hole = 2 * math.pi * radius**2 * length * (1 + poisson) / modulus
    found = tube.wall_compliance(modulus, poisson, 1e3, length, radius)
    assert found == pytest.approx(hole, rel=1e-9)


@given(thickness=st.floats(1e-6, 1e-2), more=st.floats(1.01, 3.0), poisson=st.floats(0.0, 0.5))
def test_thicker_and_stiffer_walls_are_less_compliant(
    thickness: float, more: float, poisson: float
) -> None:
    plain = tube.wall_compliance(1e6, poisson, thickness, 0.1, 1e-3)
    assert 0.0 < tube.wall_compliance(1e6, poisson, more * thickness, 0.1, 1e-3) < plain
    assert tube.wall_compliance(more * 1e6, poisson, thickness, 0.1, 1e-3) == pytest.approx(
        plain / more
    )


def test_reynolds_number_and_speed_agree() -> None:
    flow, radius = np.array([[-1e-6, 2e-6]]), np.array([1e-3, 2e-3])
    speed = tube.mean_speed(flow, radius)
    found = tube.reynolds_number(flow, 1.2, 1.8e-5, radius)
    assert found == pytest.approx(1.2 * speed * 2 * radius / 1.8e-5)
    assert np.all(found > 0.0)
