"""Whether what a model leaves of the data is noise, or follows a pattern."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.calibration.misfit import Misfit, noise_groups
from viscodesign.calibration.noise_level import white_level
from viscodesign.lazy_dataclass import dataclass

PATTERN, PATTERN_BY_CHANCE = 1.2, 5.0
"""Mean square of residuals over that of their noise, from which they follow a pattern; and what is
added for few samples, times the root of their number."""
UNCORRELATED = 0.05
"""Correlation from which rows count as independent."""
MOST_LAGS = 0.25
"""Of the rows."""


@dataclass(frozen=True)
class Pattern:
    """How the residuals of all groups of channels differ from noise."""

    chi2_per_dof: float
    """Mean square of residuals over that of the noise by which neighbours differ."""
    widening: list[np.ndarray]
    """(C,) a run: by which noise has to be taken larger, so that intervals hold nonetheless."""
    channels: tuple[str, ...]
    """Headers, of one channel a group, whose residuals follow a pattern."""


def pattern_of(misfit: Misfit, values: np.ndarray) -> Pattern:
    """The pattern of the residuals at these values."""
    squares, count, widening, named = 0.0, 0, [], []
    runs = zip(
        misfit.models,
        misfit.deviations(values),
        misfit.levels,
        misfit.kept,
        strict=True,
    )
    for model, apart, levels, kept in runs:
        factor = np.ones(len(levels))
        for group in noise_groups(model):
            own = np.where(kept[:, group], apart[:, group] / levels[group], np.nan)
            samples = int(np.isfinite(own).sum())
            excess = float(np.nanmean(own**2)) / white_level(model.recording.time, own) ** 2
            squares, count = squares + samples * excess, count + samples
            if excess > PATTERN + PATTERN_BY_CHANCE / math.sqrt(samples):
                factor[group] = math.sqrt(max(1.0, _correlation_time(own)))
                named.append(model.channels[group[-1]].header)
        widening.append(factor)
    return Pattern(squares / count, widening, tuple(named))


def _correlation_time(residuals: np.ndarray) -> float:
    """Rows (T, c) that count as one independent row: 1 + 2 times the sum of correlations."""
    filled = np.where(np.isfinite(residuals), residuals, 0.0)
    variance, total = float(np.mean(filled**2)), 1.0
    for lag in range(1, int(MOST_LAGS * len(filled)) + 1):
        correlation = float(np.mean(filled[lag:] * filled[:-lag])) / variance
        if correlation < UNCORRELATED:
            break
        total += 2 * correlation
    return total
