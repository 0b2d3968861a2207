"""Numbers that carry formulas: arithmetic, decisions, and what they refuse."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
import pytest

from viscodesign.compiled.conditions import MAX_PAIRS, Tape
from viscodesign.compiled.traced import formula_of, free_numbers, matrix_of, value_of
from viscodesign.physics import bellow, tube


def traced(*values: float) -> tuple[Tape, ca.SX, list[Any]]:
    tape = Tape()
    symbols, numbers = free_numbers([f"x{k}" for k in range(len(values))], values, tape)
    return tape, symbols, numbers


def holds(tape: Tape, symbols: ca.SX, values: list[float]) -> bool:
    margins = ca.Function("margins", [symbols], [tape.margins()])(values)
    return bool(np.all(np.asarray(margins) >= 0.0))


OPERATIONS: list[Callable[[Any, Any], Any]] = [
    lambda a, b: a + 2 * b - 3 / a,
    lambda a, b: (a - b) ** 2 + 2**a - -b,
    lambda a, b: abs(b - a) + np.float64(2.0) * a,
    lambda a, b: np.sqrt(a) * np.exp(b) + np.log(a) + np.tanh(b) + np.arctan(a),
    lambda a, b: np.sin(a) + np.cos(b) * np.tan(a),
    lambda a, b: np.minimum(a, b) * np.fmax(a, 5.0) + np.fmin(0.1, b) + np.maximum(a, b),
    lambda a, b: np.sum(np.array([a, 1.0, b]) * np.arange(3.0)) / b,
    lambda a, b: tube.wall_compliance(a, 0.3, b, 2.0, a),
    lambda a, b: bellow.residual_compliance(1e-6 * a, 1e-11 * b, 0.1, 1e5),
]


@pytest.mark.parametrize("operation", OPERATIONS)
def test_values_and_formulas_are_those_of_plain_numbers(operation: Any) -> None:
    tape, symbols, (a, b) = traced(1.3, 0.7)
    found = operation(a, b)
    assert value_of(found) == float(operation(1.3, 0.7))
    formula = ca.Function("formula", [symbols], [formula_of(found)])
    assert float(formula([1.1, 0.9])) == pytest.approx(float(operation(1.1, 0.9)), rel=1e-14)
    assert holds(tape, symbols, [1.1, 0.9])


@pytest.mark.parametrize(
    "needs_a_plain_number",
    [float, math.sqrt, math.sin, int, round, complex, hash, np.float64, lambda a: np.zeros(3)[a]],
)
def test_nothing_turns_one_into_a_plain_number(needs_a_plain_number: Any) -> None:
    _, _, (a,) = traced(2.0)
    with pytest.raises((TypeError, IndexError)):
        needs_a_plain_number(a)


@pytest.mark.parametrize(
    "mixed", [lambda a, x: a * x, lambda a, x: x + a, lambda a, x: a < x, lambda a, x: x == a]
)
def test_formulas_with_other_symbols_cannot_take_one_in(mixed: Any) -> None:
    _, _, (a,) = traced(2.0)
    with pytest.raises((TypeError, NotImplementedError)):
        mixed(a, ca.SX.sym("pressure"))


@pytest.mark.parametrize(
    ("decide", "inside", "outside"),
    [
        (lambda a: a > 1.0, 1.1, 0.9),
        (lambda a: a < 1.0, 1.1, 0.9),
        (lambda a: a <= 3.0, 2.9, 3.1),
        (lambda a: min(a, 3.0), 2.5, 3.5),
        (lambda a: a == 1.0, 1.1, 0.9),
        (lambda a: a or 5.0, 0.1, -0.1),
        (math.floor, 2.9, 3.1),
        (math.floor, 2.1, 1.9),
    ],
)
def test_decisions_hold_up_to_where_they_would_change(
    decide: Any, inside: float, outside: float
) -> None:
    tape, symbols, (a,) = traced(2.0)
    decide(a)
    assert holds(tape, symbols, [inside])
    assert not holds(tape, symbols, [outside])


def test_equal_numbers_must_stay_equal_unless_they_always_are() -> None:
    tape, symbols, (a, b) = traced(2.0, 2.0)
    assert a == b
    assert 3 * a == 3 * a
    assert holds(tape, symbols, [2.5, 2.5])
    assert not holds(tape, symbols, [2.5, 2.6])


def test_sorted_arrays_need_a_linear_count_of_conditions() -> None:
    count = 250
    tape, symbols, (a,) = traced(2.0)
    times = np.array([(37 * k) % count * a for k in range(count)])
    ordered = np.unique(times)
    assert [value_of(t) for t in ordered] == [2.0 * k for k in range(count)]
    assert MAX_PAIRS < tape.margins().numel() < 3 * count
    assert holds(tape, symbols, [0.01])
    assert not holds(tape, symbols, [-0.01])


def test_arrays_of_both_kinds_of_number_become_matrices() -> None:
    _, symbols, (a,) = traced(2.0)
    found = ca.Function("matrix", [symbols], [matrix_of(np.array([[a, 1.0], [0.5, 2 * a]]))])
    np.testing.assert_array_equal(found([3.0]), [[3.0, 1.0], [0.5, 6.0]])
