"""Least squares: known optima, bounds, gross residuals, holes, interruption."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.errors import SpecError
from viscodesign.interrupt import StopRequest
from viscodesign.studies.least_squares import (
    BestSoFar,
    NumberRanges,
    SearchLimits,
    least_squares,
)

TIMES = np.linspace(0.0, 4.0, 41)
TRUTH = np.array([3.0, 0.02])


class Decay:
    """a exp(-t / (100 b)) against data: one number of order one, one far below."""

    def __init__(self, data: np.ndarray, hole: float = 1e9) -> None:
        self.data, self.hole, self.jacobians = data, hole, 0

    @staticmethod
    def model(values: np.ndarray) -> np.ndarray:
        found: np.ndarray = values[0] * np.exp(-TIMES / (100 * values[1]))
        return found

    def __call__(self, values: np.ndarray) -> np.ndarray:
        if values[0] > self.hole:
            raise SpecError.plain("no solution")
        return np.subtract(self.model(values), self.data)

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        self.jacobians += 1
        shape = np.exp(-TIMES / (100 * values[1]))
        return np.column_stack([shape, values[0] * shape * TIMES / (100 * values[1] ** 2)])


RANGES = NumberRanges.of([0.5, 1e-4], [20.0, 1.0])
START = [np.array([10.0, 0.5])]


def test_exact_data_give_the_numbers_back() -> None:
    own = Decay(Decay.model(TRUTH))
    found = least_squares(own, RANGES, START)
    assert found.values == pytest.approx(TRUTH, rel=1e-6)
    assert found.status == "converged"
    assert found.evaluations < 25
    assert own.jacobians < 25


def test_shares_and_values_are_inverse_and_slopes_are_derivatives() -> None:
    ranges = NumberRanges.of([0.5, 1e-4, -3.0], [20.0, 1.0, 2.0])
    assert ranges.is_log.tolist() == [True, True, False]
    shares, step = np.array([0.3, 0.7, 0.2]), 1e-6
    values = ranges.values(shares)
    assert ranges.shares(values) == pytest.approx(shares, rel=1e-12)
    slopes = (ranges.values(shares + step) - ranges.values(shares - step)) / (2 * step)
    assert ranges.slopes(values) == pytest.approx(slopes, rel=1e-8)


def test_an_optimum_outside_is_found_at_the_bound_and_named() -> None:
    found = least_squares(
        Decay(Decay.model(TRUTH)), NumberRanges.of([0.5, 1e-4], [2.0, 1.0]), START
    )
    assert found.values[0] == pytest.approx(2.0, rel=1e-3)
    assert found.values[0] <= 2.0
    assert found.at_high.tolist() == [True, False]


def test_a_robust_loss_forgives_gross_residuals() -> None:
    data = Decay.model(TRUTH)
    data[::9] += 5.0
    plain = least_squares(Decay(data), RANGES, START)
    robust = least_squares(Decay(data), RANGES, START, loss="cauchy", loss_scale=0.01)
    assert abs(plain.values[0] - 3.0) > 0.1
    assert robust.values == pytest.approx(TRUTH, rel=1e-3)


def test_holes_without_a_solution_are_stepped_around() -> None:
    found = least_squares(Decay(Decay.model(TRUTH), hole=3.5), RANGES, [np.array([1.0, 0.5])])
    assert found.values == pytest.approx(TRUTH, rel=1e-6)
    with pytest.raises(SpecError, match="no solution"):
        least_squares(Decay(Decay.model(TRUTH), hole=0.0), RANGES, RANGES.starts(START[0], 3))


class Waves:
    """A cosine with many minima, of which the one at 0.7 is the lowest."""

    def __call__(self, values: np.ndarray) -> np.ndarray:
        return np.array([values[0] - 0.7, 0.5 * np.sin(20 * (values[0] - 0.7))])

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        return np.array([[1.0], [10 * np.cos(20 * (values[0] - 0.7))]])


def test_several_starts_leave_a_local_minimum_and_a_seed_repeats_them() -> None:
    ranges, own = NumberRanges.of([-3.0], [3.0]), np.array([-2.4])
    alone = least_squares(Waves(), ranges, [own])
    many = least_squares(Waves(), ranges, ranges.starts(own, 30, seed=3), descents=3)
    assert abs(alone.values[0] - 0.7) > 1.0
    assert many.values == pytest.approx([0.7], abs=1e-6)
    again = least_squares(Waves(), ranges, ranges.starts(own, 30, seed=3), descents=3)
    assert np.array_equal(again.values, many.values)
    assert [o.cost for o in many.optima] == sorted(o.cost for o in many.optima)


def test_a_request_to_stop_keeps_the_best_so_far() -> None:
    stop, told = StopRequest(), list[BestSoFar]()

    def report(best: BestSoFar) -> None:
        told.append(best)
        if len(told) == 4:
            stop.ask()

    limits = SearchLimits(stop=stop, report=report)
    found = least_squares(Decay(Decay.model(TRUTH)), RANGES, START, limits=limits)
    assert found.status == "interrupted"
    assert found.evaluations == 4
    assert found.cost == told[-1].cost


def test_what_is_good_enough_ends_the_search() -> None:
    found = least_squares(
        Decay(Decay.model(TRUTH)), RANGES, START, limits=SearchLimits(met_cost=1e-3)
    )
    assert found.status == "met"
    assert found.cost <= 1e-3
