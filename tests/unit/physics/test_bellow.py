"""The law of meeting walls: identity above, a floor below, smooth between."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from viscodesign.physics import bellow

FLOOR, FADE = -3e4, 3e3
REST, COMPLIANCE, AMBIENT = 2e-6, 6e-11, 101325.0
START = FLOOR + FADE


def effective(pressure: float | np.ndarray) -> np.ndarray:
    return np.asarray(bellow.effective_pressure(pressure, FLOOR, FADE, np))


def integral(pressure: float) -> float:
    return float(bellow.effective_pressure_integral(pressure, FLOOR, FADE, np))


@given(st.floats(START, 1e6))
def test_the_effective_pressure_is_exact_above_the_transition(pressure: float) -> None:
    assert float(effective(pressure)) == pressure


@given(
    pressure=st.floats(-AMBIENT, START),
    fraction=st.floats(0.02, 0.9),
    soft=st.floats(3e-11, 3e-10),
)
def test_the_minimum_volume_is_not_reached_before_a_vacuum(
    pressure: float, fraction: float, soft: float
) -> None:
    """The walls that have met still give way, but not by that much."""
    floor, fade = bellow.collapse_pressures(REST, soft, fraction, AMBIENT)
    give = bellow.residual_compliance(REST, soft, fraction, AMBIENT)
    found = float(bellow.effective_pressure(pressure, floor, fade, np, give))
    assert found >= pressure * (1 + 1e-12)
    plain = -(1 - fraction) * REST / soft
    assert found >= min(plain, START) * (1 + 1e-12) or floor < -AMBIENT


def test_walls_that_have_met_keep_a_hundredth_of_the_compliance() -> None:
    far = np.array([-1e7, -2e7])
    slope = np.diff(effective(far)) / np.diff(far)
    assert slope == pytest.approx(bellow.RESIDUAL_COMPLIANCE, rel=1e-2)


def test_the_effective_pressure_matches_its_formula() -> None:
    pressure = np.linspace(FLOOR - 5 * FADE, START - 1.0, 40)
    u = (FADE - (pressure - FLOOR)) / FADE
    expected = FLOOR + FADE * (1 - bellow.RESIDUAL_COMPLIANCE * u**3) / (1 + u + u**2)
    assert effective(pressure) == pytest.approx(expected, rel=1e-12)


def test_the_effective_pressure_increases_everywhere() -> None:
    pressure = np.linspace(FLOOR - 20 * FADE, START + FADE, 2001)
    assert np.all(np.diff(effective(pressure)) > 0.0)


def test_the_transition_is_twice_differentiable() -> None:
    """Differences shrink with the step on both sides alike."""
    p = ca.SX.sym("p")
    law = bellow.effective_pressure(p, FLOOR, FADE, ca)
    slope = ca.jacobian(law, p)
    values = ca.Function("values", [p], [law, slope, ca.jacobian(slope, p)])
    near = FADE * 1e-7
    below, above = (np.array(values(START + side)).ravel() for side in (-near, near))
    assert below[0] == pytest.approx(above[0], abs=3 * near)
    assert above[1:] == pytest.approx([1.0, 0.0])
    assert below[1] == pytest.approx(1.0, abs=1e-10)
    assert abs(below[2]) * FADE <= 1e-5
    # The third derivative is the first that jumps.
    third = ca.Function("third", [p], [ca.jacobian(ca.jacobian(slope, p), p)])
    assert abs(float(third(START - near))) * FADE**2 > 1.0


@pytest.mark.parametrize("pressure", [START + 1e4, START, START - 100, FLOOR, FLOOR - 2e4, -2e5])
def test_the_integral_matches_quadrature(pressure: float) -> None:
    by_parts = quad(lambda p: float(effective(p)), START, pressure, epsabs=1e-6, limit=200)[0]
    assert integral(pressure) == pytest.approx(by_parts, rel=1e-9, abs=1e-3)


def test_numbers_and_symbols_agree() -> None:
    p = ca.SX.sym("p")
    both = [
        bellow.effective_pressure(p, FLOOR, FADE, ca),
        bellow.effective_pressure_integral(p, FLOOR, FADE, ca),
    ]
    function = ca.Function("both", [p], both)
    for pressure in (-1e5, FLOOR, START - 10, 0.0, 1e5):
        found = [float(v) for v in function(pressure)]
        expected = [float(effective(pressure)), integral(pressure)]
        assert found == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("fraction", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("ambient", [0.0, AMBIENT])
def test_the_walls_meet_slightly_above_the_minimum_volume(fraction: float, ambient: float) -> None:
    """Where the linear law has the fraction left, and what gives way down to the vacuum."""
    floor, fade = bellow.collapse_pressures(REST, COMPLIANCE, fraction, ambient)
    give = bellow.residual_compliance(REST, COMPLIANCE, fraction, ambient)
    plain = -(1 - fraction) * REST / COMPLIANCE
    assert floor == pytest.approx(plain + give / (1 - give) * max(ambient + plain, 0.0))
    assert fade == pytest.approx(min(fraction, (1 - fraction) / 2) * REST / COMPLIANCE)


@pytest.mark.parametrize("fraction", [0.0, 0.1, 0.5, 0.9])
@pytest.mark.parametrize("compliance", [1e-13, 1e-11, 1e-9])
def test_walls_do_not_touch_at_rest(fraction: float, compliance: float) -> None:
    floor, fade = bellow.collapse_pressures(REST, compliance, fraction, 101325.0)
    give = bellow.residual_compliance(REST, compliance, fraction, 101325.0)
    assert floor + fade < 0.0
    assert 0.0 < give <= bellow.RESIDUAL_COMPLIANCE
    assert float(bellow.effective_pressure(0.0, floor, fade, np, give)) == 0.0


def test_without_a_minimum_volume_the_walls_meet_in_a_small_range() -> None:
    floor, fade = bellow.collapse_pressures(REST, COMPLIANCE, 0.0, 0.0)
    assert floor == pytest.approx(-REST / COMPLIANCE)
    assert fade == pytest.approx(bellow.FADE_WITHOUT_FLOOR * REST / COMPLIANCE)


def test_a_held_section_has_less_compliance() -> None:
    assert bellow.blocked_compliance(6e-11, 0.0, 1e-6, 100.0) == 6e-11
    assert bellow.blocked_compliance(6e-11, 1e-9, 1e-6, 2.0) == pytest.approx(6e-11 - 4e-15)
    assert bellow.blocked_compliance(6e-11, 1e-3, 1e-6, 2.0) < 0.0
