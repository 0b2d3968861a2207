"""Directions that others add up to."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.compiled.branch import ProblemNumbers
from viscodesign.compiled.directions import MOST, independent

NUMBERS = ProblemNumbers(
    np.array([3e-9, 2e6, 0.0, 7.0]), np.array([[0.0, 40.0]]), np.zeros(2), np.array([0.0, 8.0])
)


def units(count: int) -> np.ndarray:
    """Sizes (count, p) of rates of the parameters by keys of units far apart."""
    sizes = np.where(NUMBERS.parameters, NUMBERS.parameters, 1.0)
    return np.outer(10.0 ** np.linspace(-9, 9, count), sizes)


def directions(*rows: list[float]) -> ProblemNumbers:
    """Rates of the parameters, in these sizes."""
    others = (np.zeros((len(rows), *part.shape)) for part in NUMBERS[1:])
    return ProblemNumbers(np.array(rows) * units(len(rows)), *others)


def test_what_others_add_up_to_is_left_out_and_found_again() -> None:
    dots = directions([1, 0, 0, 0], [0, 1, 2, 0], [3, 1, 2, 0], [0, 0, 0, 0], [-2, 0, 0, 0])
    own, parts = independent(dots, NUMBERS)
    assert len(own) == 2
    assert parts is not None
    again = parts @ dots.parameters[own]
    assert again / units(5) == pytest.approx(dots.parameters / units(5), abs=1e-14)


def test_a_small_rate_of_a_number_that_is_zero_makes_a_direction() -> None:
    dots = directions([1, 0, 0, 1], [1, 0, 1e-9, 1])
    own, parts = independent(dots, NUMBERS)
    assert (own.tolist(), parts) == ([0, 1], None)


def test_directions_that_move_nothing_leave_one() -> None:
    own, parts = independent(directions([0] * 4, [0] * 4), NUMBERS)
    assert len(own) == 1
    assert parts is not None
    assert not parts.any()


def test_of_many_directions_none_is_compared() -> None:
    own, parts = independent(directions(*[[1, 0, 0, 0]] * (MOST + 1)), NUMBERS)
    assert (len(own), parts) == (MOST + 1, None)
