"""Intervals and products against exact answers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from viscodesign.calibration.combinations import known_products
from viscodesign.calibration.description import worst_sample
from viscodesign.calibration.misfit import Unknown
from viscodesign.calibration.noise_level import noise_level
from viscodesign.calibration.profile_likelihood import Profiles
from viscodesign.calibration.spread import covariance_of, spread_of
from viscodesign.interrupt import StopRequest
from viscodesign.studies.least_squares import NumberRanges


def test_a_resistance_is_known_while_its_factors_are_not() -> None:
    """viscosity length / radius^4 to 1 %, a fourth number to 3 %, a fifth not at all."""
    jacobian = np.zeros((3, 5))
    jacobian[0, :3] = 100 * np.array([1.0, 1.0, -4.0])
    jacobian[1, 3] = 33.0
    jacobian[2, :] = 1e-3
    (found,) = known_products(covariance_of(jacobian), [0, 1, 2, 4])
    assert found.factors == (0, 1, 2)
    assert sorted(map(float, found.powers)) in ([-4.0, 1.0, 1.0], [-1.0, -1.0, 4.0])
    assert found.deviation == pytest.approx(0.01, rel=1e-2)


def test_numbers_that_are_unknown_alone_make_no_product() -> None:
    assert known_products(np.diag([4.0, 9.0, 1e-4]), [0, 1]) == []


class Decay:
    """y = amplitude exp(-rate t) at few times: nothing near linear."""

    def __init__(self, y: np.ndarray) -> None:
        self.times, self.y, self.noise = np.linspace(0.2, 3.0, 6), y, 0.1
        self.unknowns = [Unknown(name, 1.0, "1", True) for name in ("amplitude", "rate")]
        self.pulled: list[int] = []

    def __call__(self, values: np.ndarray) -> np.ndarray:
        return np.asarray((self.y - values[0] * np.exp(-values[1] * self.times)) / self.noise)

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        shape = np.exp(-values[1] * self.times) / self.noise
        return np.column_stack([-shape, values[0] * self.times * shape])

    def sizes(self, values: np.ndarray) -> np.ndarray:
        return values

    def stepped(self, values: np.ndarray, steps: np.ndarray) -> np.ndarray:
        return np.asarray(values * np.exp(np.clip(steps, -2, 2)))


def test_a_profile_ends_where_the_least_squares_rise_by_3_84() -> None:
    """Against a scan of the rate with the amplitude solved for exactly."""
    from scipy.optimize import brentq, least_squares

    chance = np.random.default_rng(2)
    times = np.linspace(0.2, 3.0, 6)
    model: Any = Decay(np.exp(-times) + 0.1 * chance.standard_normal(6))
    best = least_squares(model, [1.0, 1.0], jac=model.jacobian, xtol=1e-14, ftol=1e-14).x

    def rise(rate: float) -> float:
        shape = np.exp(-rate * times)
        amplitude = shape @ model.y / (shape @ shape)
        own, least = model(np.array([amplitude, rate])), model(best)
        return float(own @ own - least @ least) - 1.959964**2

    wanted = brentq(rise, 0.05, best[1]), brentq(rise, best[1], 30.0)
    ranges = NumberRanges.of([1e-3, 1e-3], [1e3, 1e3])
    low, high = Profiles(model, spread_of(model, best), ranges, StopRequest()).ends(1)
    assert not low.is_open
    assert not high.is_open
    assert [low.value, high.value] == pytest.approx(wanted, rel=0.02)
    gaussian = best[1] * np.exp(1.96 * spread_of(model, best).deviations[1])
    assert abs(gaussian / wanted[1] - 1) > 0.04  # where it does differ


def test_noise_is_told_from_motion_gaps_and_gross_samples() -> None:
    chance = np.random.default_rng(1)
    time = np.sort(chance.uniform(0, 5, 400))
    values = np.sin(3 * time) + 0.01 * chance.standard_normal(400)
    values[chance.random(400) < 0.03] += 1.0
    values[chance.random(400) < 0.1] = np.nan
    assert noise_level(time, values) == pytest.approx(0.01, rel=0.15)
    assert noise_level(time, np.full(400, 2.0)) > 0.0


def test_the_worst_sample_is_shared_by_its_neighbours() -> None:
    """A slip of one row is larger, and tells nothing of a model."""
    residuals = np.zeros((9, 2))
    residuals[1, 0] = 99.0
    residuals[4:7, 1] = [3.0, -5.0, 4.0]
    residuals[8, 1] = np.nan
    assert worst_sample(residuals) in [(5, 1), (6, 1)]
    residuals[4:7] = 0.0
    residuals[:2, 0] = [99.0, np.nan]
    assert worst_sample(residuals + 0.1)[0] != 1
