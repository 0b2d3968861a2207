"""Numbers that fit best where derivatives are differences: the search of the package serves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from viscodesign.studies.least_squares import NumberRanges, least_squares

STEP = 1e-4
"""Of a difference, relative to the range."""


@dataclass(frozen=True, eq=False)
class _Differenced:
    """Residuals of numbers (f,), and their derivatives by central differences."""

    residuals: Callable[[np.ndarray], np.ndarray]
    steps: np.ndarray

    def __call__(self, values: np.ndarray) -> np.ndarray:
        return self.residuals(values)

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        """(m, f)"""
        columns = []
        for k, step in enumerate(self.steps):
            moved = np.eye(len(values))[k] * step
            ends = self.residuals(values + moved), self.residuals(values - moved)
            columns.append((ends[0] - ends[1]) / (2 * step))
        return np.column_stack(columns)


def fitted(
    residuals: Callable[[np.ndarray], np.ndarray],
    start: Sequence[float] | np.ndarray,
    low: Sequence[float],
    high: Sequence[float],
) -> np.ndarray:
    """The numbers (f,) between bounds with the least sum of squared residuals."""
    ranges = NumberRanges.of(low, high)
    steps = STEP * (ranges.high - ranges.low)
    return least_squares(
        _Differenced(residuals, steps), ranges, [np.asarray(start, dtype=float)], scaling="slopes"
    ).values
