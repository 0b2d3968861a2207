"""The cosine of two curves against quadrature, its derivatives against differences."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.results.shifted_product import ShiftedProduct

STEP = 1e-5


def curves(count: int, is_cyclic: bool) -> tuple[np.ndarray, np.ndarray]:
    """A late and an early curve (count,) whose product is positive."""
    rng = np.random.default_rng(3)
    late, early = 1 + rng.random((2, count))
    if not is_cyclic:
        late[0] = early[0] = 0.0
    return late, early


def shifted(curve: np.ndarray, at: np.ndarray, is_cyclic: bool) -> np.ndarray:
    """Linear between samples 0, 1, ...; cyclic, or zero before the first."""
    count = len(curve)
    if is_cyclic:
        return np.interp(at % count, np.arange(count + 1), np.append(curve, curve[0]))
    return np.interp(at, np.arange(count), curve, left=0.0)


def log_cosine(late: np.ndarray, early: np.ndarray, shift: float, is_cyclic: bool) -> float:
    """By Simpson's rule between all corners."""
    end = len(late) if is_cyclic else len(late) - 1
    corners = np.unique(np.concatenate((np.arange(end + 1), (np.arange(end) + shift) % end)))
    corners = np.unique(np.append(corners, min(shift, end)))
    low, high = corners[:-1], corners[1:]
    middle = (low + high) / 2
    inside = 1e-12 * (high - low)

    def integral(values: np.ndarray) -> float:
        first, mean, last = values
        return float(np.sum((high - low) * (first + 4 * mean + last) / 6))

    at = np.stack((low + inside, middle, high - inside))
    b = shifted(early, at - shift, is_cyclic)
    product = integral(shifted(late, at, is_cyclic) * b)
    return math.log(product) - math.log(integral(b * b)) / 2


@pytest.mark.parametrize("is_cyclic", [True, False])
@pytest.mark.parametrize("shift", [0, 2, 5])
@pytest.mark.parametrize("fraction", [0.0, 0.3, 1.0])
def test_it_is_the_integral(is_cyclic: bool, shift: int, fraction: float) -> None:
    late, early = curves(9, is_cyclic)
    found = ShiftedProduct(late, early, shift, is_cyclic).log_cosine(fraction)
    wanted = log_cosine(late, early, shift + fraction, is_cyclic)
    assert found == pytest.approx(wanted, abs=1e-10)


@pytest.mark.parametrize("is_cyclic", [True, False])
@pytest.mark.parametrize("shift", [0, 3])
def test_derivatives_with_the_shift(is_cyclic: bool, shift: int) -> None:
    product = ShiftedProduct(*curves(9, is_cyclic), shift, is_cyclic)
    low, high = 0.4 - STEP, 0.4 + STEP
    slope = (product.log_cosine(high) - product.log_cosine(low)) / (2 * STEP)
    assert product.slope(0.4) == pytest.approx(slope, rel=1e-8, abs=1e-8)
    curvature = (product.slope(high) - product.slope(low)) / (2 * STEP)
    assert product.curvature(0.4) == pytest.approx(curvature, rel=1e-8, abs=1e-8)


@pytest.mark.parametrize("is_cyclic", [True, False])
@pytest.mark.parametrize("shift", [0, 3])
def test_gradients_with_every_sample(is_cyclic: bool, shift: int) -> None:
    late, early = curves(9, is_cyclic)
    found = ShiftedProduct(late, early, shift, is_cyclic).slope_gradients(0.4)

    def slope(change: np.ndarray, of_late: bool) -> float:
        pair = (late + change, early) if of_late else (late, early + change)
        return ShiftedProduct(*pair, shift, is_cyclic).slope(0.4)

    for k in range(9):
        step = STEP * np.eye(9)[k]
        for gradient, of_late in zip(found, (True, False), strict=True):
            difference = (slope(step, of_late) - slope(-step, of_late)) / (2 * STEP)
            assert gradient[k] == pytest.approx(difference, rel=1e-7, abs=1e-9), (k, of_late)


@pytest.mark.parametrize("is_cyclic", [True, False])
def test_one_interval_joins_the_next_smoothly(is_cyclic: bool) -> None:
    pair = curves(9, is_cyclic)
    before, after = (ShiftedProduct(*pair, shift, is_cyclic) for shift in (2, 3))
    assert before.log_cosine(1.0) == pytest.approx(after.log_cosine(0.0), abs=1e-13)
    assert before.slope(1.0) == pytest.approx(after.slope(0.0), abs=1e-13)
