"""Functions of the equations by tape and by CasADi."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from viscodesign.model.taped_function import TapedFunction, TapeWithPatterns
from viscodesign.native.machine import SWITCH

X, Y = ca.SX.sym("x", 2), ca.SX.sym("y")
PLAIN = ca.Function(
    "plain",
    [X, Y],
    [X * ca.sin(Y), ca.jacobian(ca.vertcat(X[0] ** 2, X[1] * Y), X)],
    ["x", "y"],
    ["value", "slopes"],
)
WITH_ERROR_FUNCTION = ca.Function("special", [X, Y], [X * ca.erf(Y)], ["x", "y"], ["value"])


def never() -> ca.Function:
    raise AssertionError("CasADi's form was asked for")


def taped(function: ca.Function, make: Callable[[], ca.Function] = never) -> TapedFunction:
    return TapedFunction(TapeWithPatterns.of(function), make)


def test_results_have_casadis_patterns_and_names() -> None:
    function = taped(PLAIN)
    value, slopes = function(np.array([2.0, 3.0]), 0.5)
    expected = PLAIN(np.array([2.0, 3.0]), 0.5)
    assert function.names == ("value", "slopes")
    assert function.sizes == (2, 2)
    assert slopes.sparsity() == expected[1].sparsity()
    assert np.array_equal(value.full(), expected[0].full())
    assert np.array_equal(slopes.full(), expected[1].full())


@pytest.mark.parametrize("function", [PLAIN, WITH_ERROR_FUNCTION])
def test_without_native_code_casadi_answers_the_same(
    function: ca.Function, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [np.random.default_rng(1).normal(size=(70, 2)), np.array([0.3])]
    by_tape = taped(function, lambda: function).rows(rows, 70)
    monkeypatch.setenv(SWITCH, "off")
    by_casadi = taped(function, lambda: function).rows(rows, 70)
    for one, other in zip(by_tape, by_casadi, strict=True):
        assert np.array_equal(one, other)
    (first, *_) = taped(function, lambda: function)(rows[0][4], rows[1])
    assert np.array_equal(np.array(first).ravel(), by_tape[0][4])
