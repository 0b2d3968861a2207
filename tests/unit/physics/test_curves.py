"""Cubics through points against scipy's, which has the same slopes."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.interpolate import PchipInterpolator

from viscodesign.physics.curves import PiecewiseCubic

X = np.array([-2e4, -5e3, 0.0, 1e4, 3e4, 6e4])
Y = np.array([-5e-5, -2e-5, 0.0, 1.5e-4, 2e-4, 3e-4])
CURVE = PiecewiseCubic.monotone(X, Y)
INSIDE = np.linspace(X[0], X[-1], 301)


def test_the_curve_is_pchip_between_the_points() -> None:
    expected = PchipInterpolator(X, Y)(INSIDE)
    assert CURVE(INSIDE) == pytest.approx(expected, rel=1e-10, abs=1e-12 * np.ptp(Y))
    assert CURVE(X) == pytest.approx(Y, abs=1e-12 * np.ptp(Y))


def test_the_curve_is_linear_beyond_the_points() -> None:
    slopes = PchipInterpolator(X, Y).derivative()
    for end, beyond in (
        (X[0], X[0] - np.array([1.0, 1e3, 1e6])),
        (X[-1], X[-1] + np.array([1e3, 1e6])),
    ):
        level = Y[0] if end == X[0] else Y[-1]
        straight = level + slopes(end) * (beyond - end)
        assert CURVE(beyond) == pytest.approx(straight, rel=1e-7)


@pytest.mark.parametrize("end", [X[0] - 1e4, X[0], 0.0, 7e3, X[-1], X[-1] + 2e4])
def test_the_integral_matches_quadrature(end: float) -> None:
    expected = quad(lambda p: float(CURVE(p)), X[0], end, points=None, limit=200, epsabs=1e-12)[0]
    assert CURVE.integral(end) == pytest.approx(expected, rel=1e-8, abs=1e-9)


def test_the_slope_is_continuous() -> None:
    p = ca.SX.sym("p")
    slope = ca.Function("slope", [p], [ca.jacobian(CURVE(p, ca), p)])
    for knot in X:
        below, above = (float(slope(knot + side)) for side in (-1e-3, 1e-3))
        assert below == pytest.approx(above, rel=1e-5)


@pytest.mark.parametrize("pressure", [-5e4, -1e4, 0.0, 123.0, 5e4, 1e5])
def test_numbers_and_symbols_agree(pressure: float) -> None:
    p = ca.SX.sym("p")
    function = ca.Function("both", [p], [CURVE(p, ca), CURVE.integral(p, ca)])
    found = [float(v) for v in function(pressure)]
    assert found == pytest.approx([CURVE(pressure), CURVE.integral(pressure)], rel=1e-12)


rising = st.lists(st.floats(0.2, 2.0), min_size=2, max_size=12)


@given(steps=rising, seed=st.integers(0, 100))
@settings(deadline=None, max_examples=50)
def test_increasing_points_give_an_increasing_curve(steps: list[float], seed: int) -> None:
    x = np.concatenate([[0.0], np.cumsum(steps)])
    random = np.random.default_rng(seed)
    y = np.concatenate([[0.0], np.cumsum(random.uniform(0.0, 5.0, len(steps)))])
    fine = np.linspace(x[0] - 1, x[-1] + 1, 400)
    values = PiecewiseCubic.monotone(x, y)(fine)
    noise = 1e-9 * max(1.0, float(np.ptp(y)))
    assert np.all(np.diff(values) >= -noise)
    between = (fine >= x[0]) & (fine <= x[-1])
    assert y[0] - noise <= np.min(values[between])
    assert np.max(values[between]) <= y[-1] + noise


def test_points_on_a_line_give_a_line() -> None:
    """Points of one line leave nothing but value and slope, so a run pays for no row."""
    line = PiecewiseCubic.monotone(X, 3e-9 * X)
    assert line._kinks() == []
    far = np.array([-1e6, -1.0, 7.0, 1e7])
    assert line(far) == pytest.approx(3e-9 * far, rel=1e-12, abs=1e-18)
    assert len(CURVE._kinks()) == len(X)


def test_two_points_give_a_line() -> None:
    line = PiecewiseCubic.monotone(np.array([1.0, 3.0]), np.array([2.0, 6.0]))
    assert line(np.array([0.0, 2.0, 10.0])) == pytest.approx([0.0, 4.0, 20.0])


def test_zeroed_and_scaled() -> None:
    raised = PiecewiseCubic.monotone(X, Y + 1e-3)
    zero = raised.zeroed()
    assert zero(0.0) == pytest.approx(0.0, abs=1e-18)
    assert zero(INSIDE) == pytest.approx(CURVE(INSIDE), abs=1e-12)
    tripled = CURVE.scaled(3.0)
    assert tripled(INSIDE) == pytest.approx(3 * CURVE(INSIDE), rel=1e-12, abs=1e-18)
    assert tripled.integral(2e4) == pytest.approx(3 * CURVE.integral(2e4), rel=1e-12)
    # Zero at zero even where zero is no row.
    shifted = PiecewiseCubic.monotone(X + 500.0, Y).zeroed()
    assert shifted(0.0) == pytest.approx(0.0, abs=1e-18)
