"""Noise of measured channels, by how badly neighbours predict each other."""

from __future__ import annotations

import numpy as np

from viscodesign.scene.tables.noise import prediction_errors

ORDERS = (1, 2, 3)
"""Rows on each side from which a row is predicted."""
NORMAL_MAD = 0.6745
"""Median of the absolute values of a normal distribution, in standard deviations."""
GROSS_PREDICTION = 5.0
"""Standard deviations from which a prediction error is gross."""
MIN_NEIGHBOURS = 4
MIN_REL = 1e-6
"""Noise of what has none, relative to its range: digits, at least."""


def noise_level(time: np.ndarray, values: np.ndarray) -> float:
    """Standard deviation of the noise in rows (T,), some of which may be NaN; above 0.

    The smallest of several orders: a signal that moves is not noise. Gross errors do not count,
    as long as they are few.
    """
    known = ~np.isnan(values)
    t, value = time[known], values[known]
    levels = []
    for order in ORDERS:
        errors = prediction_errors(t, value, order) if len(t) > 2 * order + 2 else np.zeros(0)
        if len(errors):
            levels.append(float(np.median(np.abs(errors))) / NORMAL_MAD)
    least = MIN_REL * float(np.ptp(value)) or MIN_REL
    return max(min(levels, default=0.0), least)


def white_level(time: np.ndarray, residuals: np.ndarray) -> float:
    """Standard deviation of what neighbours in residuals (T, c) do not share; above 0.

    Of noise it is that of the residuals, of a pattern it is less. By mean squares, which few rows
    tell better than medians do; gross errors are left out.
    """
    errors = []
    for column in residuals.T:
        known = np.isfinite(column)
        if known.sum() > MIN_NEIGHBOURS:
            errors.append(prediction_errors(time[known], column[known], 1))
    every = np.abs(np.concatenate([np.zeros(0), *errors]))
    if not len(every):
        return np.inf
    level = float(np.median(every)) / NORMAL_MAD
    plain = every[every <= GROSS_PREDICTION * level]
    return max(float(np.sqrt(np.mean(plain**2))), MIN_REL)


def shared_level(time: np.ndarray, channels: list[np.ndarray]) -> float:
    """The same of several channels that one instrument measures, each (T,)."""
    return float(np.median([noise_level(time, values) for values in channels]))
