"""Every operation of CasADi's scalars gives natively what CasADi gives."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from scipy.special import erfinv

from viscodesign.native import kernels, machine
from viscodesign.native.ir_operations import ARITHMETIC, COMPARISONS, INTRINSICS, LIBRARY
from viscodesign.native.kernels import compile_kernels
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.native.vector_math import NONE

UNARY: dict[str, Callable[[ca.SX], ca.SX]] = {
    "neg": lambda x: -x,
    "sq": lambda x: x**2,
    "twice": lambda x: 2 * x,
    "inv": lambda x: 1 / x,
    "not": ca.logic_not,
    "constant power": lambda x: x**2.7,
    **{
        name: getattr(ca, name)
        for name in [
            "sin",
            "cos",
            "tan",
            "asin",
            "acos",
            "atan",
            "sinh",
            "cosh",
            "tanh",
            "asinh",
            "acosh",
            "atanh",
            "exp",
            "log",
            "log1p",
            "expm1",
            "sqrt",
            "fabs",
            "floor",
            "ceil",
            "sign",
            "erf",
        ]
    },
}
BINARY: dict[str, Callable[[ca.SX, ca.SX], ca.SX]] = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "pow": lambda x, y: x**y,
    "lt": lambda x, y: x < y,
    "le": lambda x, y: x <= y,
    "eq": lambda x, y: x == y,
    "ne": lambda x, y: x != y,
    "and": ca.logic_and,
    "or": ca.logic_or,
    "if_else_zero": lambda x, y: ca.if_else(x, y, 0),
    "if_else": lambda x, y: ca.if_else(x > y, x, y),
    **{
        name: getattr(ca, name)
        for name in ["atan2", "fmin", "fmax", "hypot", "fmod", "remainder", "copysign"]
    },
}
SPECIAL = [0.0, -0.0, 1.0, -1.0, 0.5, np.inf, -np.inf, np.nan, 1e300, 1e-300, 3.0]


def natively(function: ca.Function, local: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    """Values (nr, W) of a kernel for local values (nl, W) and numbers (np, W)."""
    lanes = local.shape[1]
    compiled = compile_kernels([function], "test", lanes)
    out = np.full((function.numel_out(0), lanes), 7.0)
    call = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 3)(compiled.address(0))
    given = [np.ascontiguousarray(array) for array in (local, numbers, out)]
    call(*[array.ctypes.data for array in given])
    return given[2]


def interpreted(function: ca.Function, local: np.ndarray, numbers: np.ndarray) -> np.ndarray:
    columns = [function(local[:, k], numbers[:, k]) for k in range(local.shape[1])]
    return np.hstack([np.array(column) for column in columns])


def pairs(count: int) -> np.ndarray:
    """Random arguments (2, count), with all pairs of special values."""
    rng = np.random.default_rng(1)
    ordinary = rng.standard_normal((2, count)) * 10.0 ** rng.integers(-3, 3, (2, count))
    inside = rng.uniform(-1, 1, (2, count))
    special = np.array([[x, y] for x in SPECIAL for y in SPECIAL]).T
    return np.hstack([ordinary, inside, special])


def assert_same(function: ca.Function, given: np.ndarray, lanes: int, bound: float = 1e-14) -> None:
    count = given.shape[1] - given.shape[1] % lanes
    for k in range(0, count, lanes):
        some = given[:, k : k + lanes]
        found, wanted = (f(function, some[:1], some[1:]) for f in (natively, interpreted))
        np.testing.assert_allclose(found, wanted, rtol=bound, atol=0, equal_nan=True)


@pytest.fixture(params=["as here", "in fours", "one by one"])
def vectors(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Functions of the C library for eight, four or one number at once, as far as it has them."""
    this = machine.this_machine()
    kinds = {
        "as here": this.vector_math,
        "in fours": replace(this.vector_math, letter="d", width=4),
        "one by one": NONE,
    }
    if request.param == "in fours" and this.vector_math == NONE:
        pytest.skip("no such functions here")
    other = replace(this, vector_math=kinds[request.param])
    monkeypatch.setattr(kernels, "this_machine", lambda: other)


@pytest.mark.usefixtures("vectors")
@pytest.mark.parametrize("lanes", [8, 1])
def test_unary_operations(lanes: int) -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    function = ca.Function("f", [x, y], [ca.vertcat(*[f(x) for f in UNARY.values()])])
    assert_same(function, pairs(200 if lanes > 1 else 20), lanes)


@pytest.mark.usefixtures("vectors")
@pytest.mark.parametrize("lanes", [8, 1])
def test_binary_operations(lanes: int) -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    function = ca.Function("f", [x, y], [ca.vertcat(*[f(x, y) for f in BINARY.values()])])
    assert_same(function, pairs(200 if lanes > 1 else 20), lanes)


def test_the_inverse_error_function() -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    function = ca.Function("f", [x, y], [ca.erfinv(x)])
    given = np.array([[*np.linspace(-0.999, 0.999, 64), -2, -1, 0, 1, 2, np.nan, 0.7, -0.7]])
    found = np.hstack(
        [natively(function, given[:, k : k + 8], given[:, k : k + 8]) for k in range(0, 72, 8)]
    )
    np.testing.assert_allclose(found, erfinv(given), rtol=1e-12)
    # CasADi's own is not accurate to more.
    np.testing.assert_allclose(found, interpreted(function, given, given), rtol=1e-5)


def test_every_operation_is_tested() -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    names = {value: name[3:] for name, value in vars(ca).items() if name.startswith("OP_")}
    tested = set()
    for expression in [*(f(x) for f in UNARY.values()), *(f(x, y) for f in BINARY.values())]:
        f = ca.Function("f", [x, y], [expression])
        tested |= {names[f.instruction_id(k)] for k in range(f.n_instructions())}
    assert tested >= {*ARITHMETIC, *INTRINSICS, *LIBRARY, *COMPARISONS} - {"CONSTPOW"}


def test_long_formulas_with_shared_and_constant_parts() -> None:
    local, numbers = ca.SX.sym("l", 5), ca.SX.sym("n", 3)
    value, outs = local[0], [ca.SX(3.5), local[1], numbers[2]]
    for k in range(400):
        value = ca.sin(value) * numbers[k % 3] + local[k % 5] / (2 + ca.cos(local[(k + 1) % 5]))
        outs.append(value)
    function = ca.Function("f", [local, numbers], [ca.vertcat(*outs)])
    rng = np.random.default_rng(2)
    given, own = rng.uniform(0, 1, (5, 8)), rng.uniform(0, 0.2, (3, 8))
    found = natively(function, given, own)
    np.testing.assert_allclose(found, interpreted(function, given, own), rtol=1e-13)


def test_lanes_are_independent() -> None:
    local, numbers = ca.SX.sym("l", 2), ca.SX.sym("n", 1)
    function = ca.Function("f", [local, numbers], [ca.vertcat(local[0] / local[1] * numbers)])
    given = np.vstack([np.arange(8.0), [1, 1, 0, 1, np.nan, 1, 1, 1]])
    found = natively(function, given, np.ones((1, 8)))
    assert np.isinf(found[0, 2])
    assert np.isnan(found[0, 4])
    assert np.isfinite(np.delete(found[0], [2, 4])).all()


def test_empty_inputs() -> None:
    local, numbers = ca.SX.sym("l", 2), ca.SX.sym("n", 0)
    function = ca.Function("f", [local, numbers], [ca.vertcat(local[1], ca.SX(2))])
    found = natively(function, np.arange(16.0).reshape(2, 8), np.zeros((0, 8)))
    np.testing.assert_array_equal(found, [np.arange(8.0, 16.0), np.full(8, 2.0)])


def test_what_has_no_native_form_says_so() -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    with pytest.raises(NativeUnavailable, match="printme"):
        compile_kernels([ca.Function("f", [x, y], [x.printme(y)])], "", 8)
    with pytest.raises(ValueError, match="dense columns"):
        compile_kernels([ca.Function("f", [x], [x])], "", 8)
