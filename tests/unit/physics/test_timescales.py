"""Characteristic times of networks."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.physics.timescales import slowest_network_time


def test_a_pair_of_bellows_behind_one_tube() -> None:
    conductance = np.array([[2.0, -1.0], [-1.0, 1.0]])
    slowest = (3 - np.sqrt(5)) / 2
    found = slowest_network_time(conductance, np.ones(2), sealed=False)
    assert found == pytest.approx(1 / slowest, rel=1e-12)


def test_a_rate_below_rounding_error_gives_a_long_positive_time() -> None:
    conductance = np.array([[1e20, -1e20], [-1e20, 1e20]])
    found = slowest_network_time(conductance, np.ones(2), sealed=False)
    assert 1e-6 < found < np.inf
