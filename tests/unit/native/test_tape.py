"""Tapes give what CasADi gives, to the last bit."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest

from viscodesign.native.loops import PythonLoops, native_loops
from viscodesign.native.source.tape import WIDTH
from viscodesign.native.tape import OperationTape, tape_of

X, Y = ca.SX.sym("x"), ca.SX.sym("y")
OPERATIONS = {
    "add": X + Y, "sub": X - Y, "mul": X * Y, "div": X / Y, "neg": -X, "sq": X**2, "twice": 2 * X,
    "inv": 1 / X, "sqrt": ca.sqrt(X), "fabs": ca.fabs(X), "exp": ca.exp(X), "log": ca.log(X),
    "pow": X**Y, "constpow": X**2.5, "sin": ca.sin(X), "cos": ca.cos(X), "tan": ca.tan(X),
    "asin": ca.asin(X), "acos": ca.acos(X), "atan": ca.atan(X), "atan2": ca.atan2(X, Y),
    "sinh": ca.sinh(X), "cosh": ca.cosh(X), "tanh": ca.tanh(X), "lt": X < Y, "le": X <= Y,
    "eq": X == Y, "ne": X != Y, "not": ca.logic_not(X), "and": ca.logic_and(X, Y),
    "or": ca.logic_or(X, Y), "if": ca.if_else(X > 0, Y, ca.sin(X)), "fmin": ca.fmin(X, Y),
    "fmax": ca.fmax(X, Y), "sign": ca.sign(X), "log1p": ca.log1p(X), "expm1": ca.expm1(X),
}  # fmt: skip
SPECIAL = (0.0, -0.0, 1.0, -1.0, 0.5, 1e-300, 1e300, math.inf, -math.inf, math.nan)


def numbers(count: int) -> np.ndarray:
    """Rows (count, 2) of random numbers."""
    return np.random.default_rng(3).normal(size=(count, 2)) * [1.0, 2.0]


def tape(function: ca.Function) -> OperationTape:
    found = tape_of(function)
    assert found is not None
    return found


def by_casadi(function: ca.Function, *rows: np.ndarray) -> np.ndarray:
    """The first result (m, size), one row after the other."""
    return np.array([
        np.array(function.call([ca.DM(v) for v in row])[0].nonzeros())
        for row in zip(*rows, strict=True)
    ])  # fmt: skip


@pytest.mark.parametrize("name", OPERATIONS)
def test_every_operation_is_casadis(name: str) -> None:
    function = ca.Function("f", [X, Y], [OPERATIONS[name]])
    special = np.array([(a, b) for a in SPECIAL for b in SPECIAL])
    rows = np.concatenate([numbers(50), special])
    (found,) = tape(function)([rows[:, :1], rows[:, 1:]], len(rows))
    expected = by_casadi(function, rows[:, :1], rows[:, 1:])
    assert np.array_equal(found, expected, equal_nan=True)


@pytest.mark.parametrize("rows", [1, 2, WIDTH - 1, WIDTH, WIDTH + 1, 3 * WIDTH + 5])
def test_any_number_of_rows(rows: int) -> None:
    both = ca.vertcat(X, Y)
    function = ca.Function("f", [both], [ca.vertcat(X * Y, ca.sin(X), Y), X - Y], ["a"], ["b", "c"])
    given = numbers(rows)
    found = tape(function)
    assert (found.names, found.sizes) == (("b", "c"), (3, 1))
    b, c = found([given], rows)
    assert np.array_equal(b, by_casadi(function, given))
    assert np.array_equal(c[:, 0], given[:, 0] - given[:, 1])


def test_arguments_that_all_rows_share() -> None:
    function = ca.Function("f", [X, ca.vertcat(Y, ca.SX.sym("z"))], [X * Y])
    given = numbers(70)[:, :1]
    (found,) = tape(function)([given, np.array([3.0, 7.0])], 70)
    assert np.array_equal(found, 3.0 * given)


def test_arguments_of_a_wrong_size_are_refused() -> None:
    function = ca.Function("f", [X, Y], [X * Y])
    with pytest.raises(ValueError, match="belong"):
        tape(function)([np.zeros((3, 1)), np.zeros((4, 1))], 3)


def test_results_without_zeros_by_structure() -> None:
    jacobian = ca.jacobian(ca.vertcat(X**2, ca.sin(Y)), ca.vertcat(X, Y))
    function = ca.Function("f", [X, Y], [jacobian])
    rows = numbers(40)
    (found,) = tape(function)([rows[:, :1], rows[:, 1:]], 40)
    assert np.array_equal(found, by_casadi(function, rows[:, :1], rows[:, 1:]))
    assert found.shape == (40, 2)


def test_functions_of_more_than_plain_operations_have_no_tape() -> None:
    assert tape_of(ca.Function("f", [X], [ca.erf(X)])) is None
    x = ca.MX.sym("x")
    assert tape_of(ca.Function("f", [x], [ca.sin(x)])) is None


def test_loops_in_python_give_the_same() -> None:
    chosen = [OPERATIONS[name] for name in ("mul", "if", "fmin", "sign", "atan2", "tanh", "and")]
    function = ca.Function("f", [X, Y], [ca.vertcat(*chosen)])
    rows = numbers(WIDTH + 3)
    given = [rows[:, :1], rows[:, 1:]]
    (native,) = tape(function)(given, len(rows), native_loops())
    (twin,) = tape(function)(given, len(rows), PythonLoops())
    assert np.array_equal(native, twin)
