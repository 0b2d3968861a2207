"""Keys of formulas: what counts as structure, and what does not."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import casadi as ca
import numpy as np
import pytest

from viscodesign.model.scene_number import PARAMETER_VALUE, SCENE_NUMBER
from viscodesign.model.structure import structure_of, without_numbers


@dataclass(frozen=True)
class Spring:
    """A number that a parameter carries, one that nothing carries, and an expression."""

    stiffness: float | None = field(metadata=SCENE_NUMBER)
    value: float = field(metadata=PARAMETER_VALUE)
    exponent: float
    force: ca.SX


def spring(slope: float = 2.0) -> Spring:
    return Spring(3.0, 0.0, 1.4, slope * ca.SX.sym("x"))


@pytest.mark.parametrize("change", [{"stiffness": 5.0}, {"value": 7.0}])
def test_a_number_that_a_parameter_carries_is_no_structure(change: dict[str, float]) -> None:
    assert structure_of(spring()) == structure_of(replace(spring(), **change))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "change", [{"stiffness": 0.0}, {"stiffness": None}, {"exponent": 1.0}, {"force": ca.SX(1)}]
)
def test_all_else_is(change: dict[str, object]) -> None:
    assert structure_of(spring()) != structure_of(replace(spring(), **change))  # type: ignore[arg-type]


def test_expressions_count_by_what_they_compute() -> None:
    assert structure_of(spring()) == structure_of(spring())
    assert structure_of(spring()) != structure_of(spring(3.0))
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    assert structure_of([x, y, x - y]) != structure_of([x, y, y - x])
    assert structure_of(ca.SX(2, 1)) != structure_of(ca.SX.zeros(2, 1))


def test_functions_arrays_and_objects_count() -> None:
    def one() -> None: ...
    def two() -> None: ...

    assert structure_of(one) != structure_of(two)
    assert structure_of(np.zeros(2)) != structure_of(np.zeros(3))
    assert structure_of({"a": 1}) != structure_of({"b": 1})
    assert structure_of([spring(), 1]) != structure_of([spring(), 1.0])


def test_numbers_are_blinded_wherever_they_stand() -> None:
    blind = without_numbers({"springs": (spring(), replace(spring(), stiffness=0.0))})
    first, second = blind["springs"]
    assert np.isnan(first.stiffness)
    assert second.stiffness == 0.0
    assert first.exponent == 1.4
