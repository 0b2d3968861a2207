"""Responses of modes to polynomials, against their closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.solve.numerics.exponential_weights import cell_points, weights

COUNTS = [6, 12]
RATES = [0.0, 1e-9, 0.3, 7.0, 15.9, 16.1, 90.0, 127.9, 128.1, 1e4, 1e10]
COMPLEX = [2 + 3j, 5 + 40j, 1 + 127j, 130 + 500j, 1e-3 + 1e5j]


def exact(z: complex, degree: int, end: float) -> complex:
    """Integral of exp(-z (end - s)) s^degree over [0, end]."""
    if abs(z) * end < 6.0:
        powers = (z * end) ** np.arange(60) / np.array([math.factorial(k) for k in range(60)])
        return complex(
            np.exp(-z * end)
            * end ** (degree + 1)
            * np.sum(powers / np.arange(degree + 1, degree + 61))
        )
    found = (1 - np.exp(-z * end)) / z
    for k in range(1, degree + 1):
        found = (end**k - k * found) / z
    return complex(found)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("z", [*RATES, *COMPLEX])
def test_responses_to_powers_are_exact(z: complex, count: int) -> None:
    points = cell_points(count)
    found = weights(np.array([[z]]), points)
    for degree in (0, 1, 3, 5):
        values = points.theta[:-1] ** degree
        for place in (0, count // 2, count):
            end = points.theta[place]
            expected = exact(z, degree, end)
            # The size of the response to one, of which a power is a part.
            size = max(abs(exact(z, 0, end)), abs(expected))
            assert abs(found.response[0, 0, place] @ values - expected) <= 2e-13 * size
            assert found.decay[0, 0, place] == pytest.approx(
                np.exp(-z * end), rel=1e-12, abs=1e-300
            )


def test_a_steady_input_keeps_a_steady_mode() -> None:
    """Two digits better than any other polynomial: nothing moves where nothing should."""
    points, z = cell_points(12), np.array([RATES[2:]])
    found = weights(z, points)
    after = found.decay[..., -1] / z + found.response[..., -1, :].sum(axis=-1)
    assert np.max(np.abs(after * z - 1)) <= 2e-15


def test_many_lengths_at_once_are_each_by_itself() -> None:
    points, z = cell_points(8), np.geomspace(1e-3, 1e6, 24).reshape(4, 6)
    found = weights(z, points)
    for k, row in enumerate(z):
        alone = weights(row[None], points)
        assert np.allclose(found.response[k], alone.response[0], rtol=1e-13, atol=0.0)
