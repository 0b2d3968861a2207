"""Formulas by NumPy give what CasADi's virtual machine gives."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from viscodesign.solve.numerics.by_numpy import NumpyFunction


def test_every_operation_equals_casadi() -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y", 2)
    a, b = y[0], y[1]
    results = [
        x + a - b * x / a,
        ca.vertcat(ca.exp(-x), ca.log(a), ca.sqrt(a), x**3, a**b, 2 * x, 1 / a, -x),
        ca.vertcat(ca.sin(x), ca.cos(x), ca.tan(x), ca.tanh(x), ca.sinh(x), ca.cosh(x)),
        ca.vertcat(ca.fabs(x), ca.sign(x), ca.floor(x), ca.ceil(x), ca.fmin(x, a), ca.fmax(x, b)),
        ca.vertcat(ca.if_else(x > a, b, ca.log1p(a)), ca.expm1(x), ca.atan2(x, b), ca.fmod(a, b)),
        ca.if_else(ca.logic_and(x <= 1, ca.logic_not(a == b)), x, a != b),
    ]
    function = ca.Function("all", [x, y], results)
    rng = np.random.default_rng(3)
    at, own = rng.uniform(-2, 2, 7), rng.uniform(0.5, 2, (2, 7))
    found = NumpyFunction(function)([[at], own], 7)
    expected = np.vstack([np.array(v) for v in function.call([at[None, :], own])])
    assert found == pytest.approx(expected, rel=1e-14)


def test_numbers_serve_all_and_zeros_by_structure_are_left_out() -> None:
    x, p = ca.SX.sym("x"), ca.SX.sym("p")
    sparse = ca.SX(ca.Sparsity.triplet(3, 1, [2], [0]), x * p)
    found = NumpyFunction(ca.Function("one", [x, p], [sparse, p]))([[np.arange(3.0)], [2.0]], 3)
    assert np.array_equal(found, [[0.0, 2.0, 4.0], [2.0, 2.0, 2.0]])


def test_an_unknown_operation_is_refused() -> None:
    x = ca.SX.sym("x")
    with pytest.raises(NotImplementedError):
        NumpyFunction(ca.Function("erf", [x], [ca.erf(x)]))
