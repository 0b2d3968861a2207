"""Rates by splines, against the library whose import they spare."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from viscodesign.postprocess.spline_rates import spline_rates


@pytest.mark.parametrize("count", [2, 3, 4, 5, 60])
def test_they_are_those_of_the_library(count: int) -> None:
    random = np.random.default_rng(count)
    time = np.cumsum(random.uniform(0.01, 1.0, count))
    values = random.normal(size=(count, 3))
    expected = CubicSpline(time, values, axis=0)(time, 1)
    found = spline_rates(time, values)
    assert np.allclose(found, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max())
