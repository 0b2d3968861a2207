"""Gas laws against their limits, their own derivatives and each other."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.integrate import quad

from viscodesign.physics import gas

AMBIENT = 101325.0
PRESSURES = np.array([-0.95, -0.5, -1e-3, 0.0, 1e-3, 0.3, 2.0]) * AMBIENT
EXPONENTS = [1.0, 1.2, 1.4, 5 / 3]


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_density_follows_the_gas_law(exponent: float) -> None:
    ratio = gas.density_ratio(PRESSURES, AMBIENT, exponent)
    assert ratio**exponent == pytest.approx(1 + PRESSURES / AMBIENT, rel=1e-13)


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize("pressure", [-0.9 * AMBIENT, -100.0, 100.0, AMBIENT])
def test_integrals_match_quadrature_of_the_density(exponent: float, pressure: float) -> None:
    def density(p: float) -> float:
        return float(gas.density_ratio(p, AMBIENT, exponent))

    driven = quad(density, 0.0, pressure, epsabs=0.0, epsrel=1e-11)[0]
    assert gas.density_integral(pressure, AMBIENT, exponent) == pytest.approx(driven, rel=1e-9)
    work = quad(lambda p: 1 / density(p), 0.0, pressure, epsabs=0.0, epsrel=1e-11)[0]
    assert gas.specific_work(pressure, AMBIENT, exponent) == pytest.approx(work, rel=1e-9)


@pytest.mark.parametrize(
    "law", [gas.density_ratio, gas.density_integral, lambda p, a, n: gas.specific_work(p, a, n, np)]
)
def test_the_isothermal_law_is_the_limit_of_the_polytropic(law: Callable[..., np.ndarray]) -> None:
    """The exponent 1 has its own formulas; those of its neighbours must tend to them."""
    exact = law(PRESSURES, AMBIENT, 1.0)
    for near in (1e-3, 1e-5):
        apart = np.max(np.abs(law(PRESSURES, AMBIENT, 1 + near) - exact))
        assert 0.0 < apart <= 3 * near * np.max(np.abs(exact))


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_a_stiff_gas_behaves_like_a_liquid(exponent: float) -> None:
    """Against a large ambient pressure nothing yields."""
    assert gas.density_ratio(1e3, 1e12, exponent) == pytest.approx(1.0, abs=1e-8)
    assert gas.density_integral(1e3, 1e12, exponent) == pytest.approx(1e3, rel=1e-6)
    assert gas.specific_work(1e3, 1e12, exponent) == pytest.approx(1e3, rel=1e-6)


@example(low=1.0, high=2.0, exponent=1.0000000000000002)
@given(low=st.floats(-0.99, 5.0), high=st.floats(-0.99, 5.0), exponent=st.floats(1.0, 5 / 3))
def test_all_functions_increase_with_pressure(low: float, high: float, exponent: float) -> None:
    if high - low < 1e-6:
        return
    laws = (gas.density_ratio, gas.density_integral, gas.specific_work)
    for law in laws:
        assert law(low * AMBIENT, AMBIENT, exponent) < law(high * AMBIENT, AMBIENT, exponent)


def test_compliance_is_the_derivative_of_the_stored_volume() -> None:
    """By differences of the density at another pressure than the ambient one."""
    volume, pressure, exponent = 2e-6, -3e4, 1.4
    step = 1.0
    upper, lower = (gas.density_ratio(pressure + s, AMBIENT, exponent) for s in (step, -step))
    here = gas.density_ratio(pressure, AMBIENT, exponent)
    by_differences = volume * (upper - lower) / (2 * step) / here
    found = gas.gas_compliance(volume, AMBIENT + pressure, exponent)
    assert found == pytest.approx(by_differences, rel=1e-8)


def test_density_is_constant_below_the_minimum_pressure() -> None:
    """An input may ask for less than nothing; the gas keeps a density, continuously."""
    edge = -AMBIENT * (1 - gas.MIN_PRESSURE_RATIO)
    for exponent in (1.0, 1.4):
        thin = gas.density_ratio(edge, AMBIENT, exponent)
        assert thin == pytest.approx(gas.MIN_PRESSURE_RATIO ** (1 / exponent))
        assert gas.density_ratio(-2 * AMBIENT, AMBIENT, exponent) == pytest.approx(thin)
        for law, slope in ((gas.density_integral, thin), (gas.specific_work, 1 / thin)):
            below = law(edge - 100.0, AMBIENT, exponent)
            assert law(edge, AMBIENT, exponent) - below == pytest.approx(100 * slope)
