"""Keys of formulas: what is structure, and what is not."""

from __future__ import annotations

import sys
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from decimal import Decimal
from fractions import Fraction
from functools import partial
from operator import methodcaller

import casadi as ca
import numpy as np
import pytest
from scipy.interpolate import CubicSpline, PchipInterpolator

from viscodesign.model.scene_number import PARAMETER_VALUE, SCENE_NUMBER
from viscodesign.model.structure import _derived, structure_of, without_numbers
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class Spring:
    """A scene number, another number, and an expression."""

    stiffness: float | None = field(metadata=SCENE_NUMBER)
    value: float = field(metadata=PARAMETER_VALUE)
    exponent: float
    force: ca.SX


def spring(slope: float = 2.0) -> Spring:
    return Spring(3.0, 0.0, 1.4, slope * ca.SX.sym("x"))


@pytest.mark.parametrize("change", [{"stiffness": 5.0}, {"value": 7.0}])
def test_scene_numbers_are_not_structure(change: dict[str, float]) -> None:
    assert structure_of(spring()) == structure_of(replace(spring(), **change))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "change", [{"stiffness": 0.0}, {"stiffness": None}, {"exponent": 1.0}, {"force": ca.SX(1)}]
)
def test_all_other_attributes_are_structure(change: dict[str, object]) -> None:
    assert structure_of(spring()) != structure_of(replace(spring(), **change))  # type: ignore[arg-type]


def test_expressions_are_compared_by_content() -> None:
    assert structure_of(spring()) == structure_of(spring())
    assert structure_of(spring()) != structure_of(spring(3.0))
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    assert structure_of([x, y, x - y]) != structure_of([x, y, y - x])
    assert structure_of(ca.SX(2, 1)) != structure_of(ca.SX.zeros(2, 1))


def test_functions_arrays_and_objects_are_structure() -> None:
    def one() -> None: ...
    def two() -> None: ...

    assert structure_of(one) != structure_of(two)
    assert structure_of(np.zeros(2)) != structure_of(np.zeros(3))
    assert structure_of({"a": 1}) != structure_of({"b": 1})
    assert structure_of([spring(), 1]) != structure_of([spring(), 1.0])


def test_scene_numbers_are_replaced_at_any_depth() -> None:
    blind = without_numbers({"springs": (spring(), replace(spring(), stiffness=0.0))})
    first, second = blind["springs"]
    assert np.isnan(first.stiffness)
    assert second.stiffness == 0.0
    assert first.exponent == 1.4


class _Slotted:
    __slots__ = ("value",)

    def __init__(self, value: float) -> None:
        self.value = value


class _Named(dict[str, float]):
    """A dictionary with an attribute."""

    def __init__(self, value: float) -> None:
        super().__init__()
        self.value = value


def _adding(value: float) -> Callable[[float], float]:
    return lambda x: x + value


@pytest.mark.parametrize(
    "make",
    [
        _Slotted, _Named, _adding, np.float32, np.int64, Fraction, Decimal, complex,
        lambda v: partial(pow, v), lambda v: methodcaller("scale", v),
        lambda v: CubicSpline([0.0, 1.0, 2.0], [0.0, v, 1.0]),
        lambda v: PchipInterpolator([0.0, 1.0, 2.0], [0.0, v, 1.0]),
        lambda v: np.array([Fraction(v)], dtype=object), lambda v: [deque([v])],
    ],
)  # fmt: skip
def test_a_number_counts_wherever_it_hides(make: Callable[[int], object]) -> None:
    assert structure_of(make(2)) != structure_of(make(3))


@pytest.mark.parametrize("make", [_Slotted, _Named, _adding, lambda v: partial(pow, v), np.float32])
def test_equal_things_have_equal_keys(make: Callable[[int], object]) -> None:
    assert structure_of(make(2)) == structure_of(make(2))


def test_what_cannot_be_copied_equals_nothing() -> None:
    with open(__file__) as file:
        assert structure_of(file) != structure_of(file)


def test_a_class_may_change_while_it_is_read() -> None:
    """As by a lazy method that another thread writes."""

    class Base:
        added: int

    for number in range(200):
        setattr(Base, f"method_{number}", None)

    class Own(Base):
        @cached_property
        def much(self) -> int:
            return 1

    over = threading.Event()

    def change() -> None:
        while not over.is_set():
            Base.added = 1
            time.sleep(0)
            del Base.added
            time.sleep(0)

    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    other = threading.Thread(target=change)
    other.start()
    try:
        assert {tuple(_derived.__wrapped__(Own)) for _ in range(3000)} == {("much",)}
    finally:
        over.set()
        other.join()
        sys.setswitchinterval(before)
