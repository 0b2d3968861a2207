"""What lasts, against its lag step by step."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.postprocess.sustained import Sustained


@pytest.mark.parametrize("lag", [0.0, 0.3])
def test_a_lag_in_blocks_is_that_step_by_step(lag: float) -> None:
    random = np.random.default_rng(5)
    time, values = np.cumsum(random.uniform(0.0, 0.2, 50)), random.uniform(0, 1, (50, 3))
    blocks, sustained = [], Sustained(lag)
    for rows in (slice(0, 7), slice(7, 8), slice(8, 50)):
        blocks.append(sustained.update(time[rows], values[rows]))
    value, expected = np.zeros(3), [np.zeros(3)]
    for k in range(1, 50):
        kept = np.exp(-(time[k] - time[k - 1]) / lag) if lag else 0.0
        value = values[k] + (value - values[k]) * kept
        expected.append(value)
    np.testing.assert_allclose(np.concatenate(blocks), expected, atol=1e-12)
