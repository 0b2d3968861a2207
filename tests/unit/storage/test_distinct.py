"""Sorted values without repetition."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.storage.distinct import distinct


@pytest.mark.parametrize("values", [[], [2.0], [3, 1, 3, 2, 1], [[1.0, 0.5], [0.5, -0.0]]])
def test_is_what_numpy_has(values: list[float]) -> None:
    found, expected = distinct(values), np.unique(values)
    assert found.dtype == expected.dtype
    assert np.array_equal(found, expected)
