"""Bursts count by how long they last, however they are sampled."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.postprocess.sustained import Sustained


def test_a_level_is_approached_with_its_lag_in_any_blocks() -> None:
    time = np.array([0.0, 0.1, 0.15, 0.6, 2.0])
    level = np.full((5, 2), [3.0, -1.0])
    expected = (1 - np.exp(-time / 0.4))[:, None] * level
    lag = Sustained(0.4)
    found = [lag.update(time[rows], level[rows]) for rows in (slice(2), slice(2, 5))]
    assert np.concatenate(found) == pytest.approx(expected)


def test_a_short_burst_is_seen_by_its_duration() -> None:
    time = np.array([0.0, 1.0, 1.001, 2.0])
    burst = np.array([[0.0], [0.0], [10.0], [0.0]])
    found = Sustained(0.5).update(time, burst)
    assert found.max() == pytest.approx(10.0 * 0.001 / 0.5, rel=2e-3)


def test_without_a_lag_all_is_seen_but_the_first() -> None:
    values = np.array([[5.0], [1.0], [2.0]])
    assert Sustained(0.0).update(np.arange(3.0), values).ravel().tolist() == [0.0, 1.0, 2.0]
