"""All instructions of a function, read at once, are those that CasADi tells one by one."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest

from tests.unit.native.test_tape import OPERATIONS, X, Y
from viscodesign.native import instructions as read_at_once
from viscodesign.native.instructions import FIELDS, instructions

MANY = ca.Function(
    "f",
    [X, Y],
    [
        ca.vertcat(*OPERATIONS.values()),
        1e-300 * X + math.pi * Y - 2.5,
        ca.sin(ca.erf(ca.hypot(X, Y))),
    ],
)


def told(function: ca.Function) -> np.ndarray:
    return read_at_once._told(function, range(function.n_instructions()))


@pytest.mark.parametrize("compared", [1, 100, 10_000])
def test_they_are_those_that_casadi_tells(compared: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(read_at_once, "COMPARED", compared)
    found = read_at_once._from_serialised(MANY)
    assert found is not None
    assert np.array_equal(found, told(MANY))


@pytest.mark.parametrize("content", ["", "aa", "ponm" * 1000])
def test_another_serialised_form_is_not_needed(
    content: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(read_at_once, "FEW", 0)
    monkeypatch.setattr(ca.Function, "serialize", lambda self: content)
    assert read_at_once._from_serialised(MANY) is None
    assert np.array_equal(instructions(MANY), told(MANY))


def test_one_field_that_differs_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(read_at_once, "COMPARED", MANY.n_instructions())
    right = read_at_once._bytes_of(MANY.serialize())
    at = right.find(told(MANY)[:1].tobytes())
    for k in range(0, FIELDS * MANY.n_instructions(), 7):
        row, field = divmod(k, FIELDS)
        if field == FIELDS - 1 and not read_at_once._LAST[told(MANY)[row, 0]]:
            continue
        wrong = bytearray(right)
        wrong[at + 4 * k] ^= 1
        monkeypatch.setattr(read_at_once, "_bytes_of", lambda _, wrong=wrong: bytes(wrong))
        assert read_at_once._from_serialised(MANY) is None


def test_a_function_without_instructions() -> None:
    assert instructions(ca.Function("f", [], [])).shape == (0, FIELDS)
