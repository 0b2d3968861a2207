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
MAX_LAGS = 0.25
"""Longest lag, as a part of the rows."""


@dataclass(frozen=True)
class GroupExcess:
    """How much a model leaves of channels that share their noise."""

    run: int
    channels: list[int]
    mean_square: float
    """Mean square of the residuals over that of the noise by which neighbours differ."""
    by_chance: float
    """Up to which it may be chance."""
    noise: np.ndarray
    """(c,) Standard deviation by which neighbours differ, in the channels' units."""


@dataclass(frozen=True)
class Pattern:
    """How the residuals of all groups of channels differ from noise."""

    chi2_per_dof: float
    """Mean square of residuals over that of the noise by which neighbours differ."""
    widening: list[np.ndarray]
    """(C,) a run: by which noise has to be taken larger, so that intervals hold nonetheless."""
    channels: tuple[str, ...]
    """Headers, of one channel a group, whose residuals follow a pattern."""
    groups: tuple[GroupExcess, ...]


def pattern_of(misfit: Misfit, values: np.ndarray) -> Pattern:
    """The pattern of the residuals at these values."""
    squares, count, widening = 0.0, 0, []
    named: list[str] = []
    groups: list[GroupExcess] = []
    runs = zip(
        misfit.models,
        misfit.deviations(values),
        misfit.levels,
        misfit.kept,
        strict=True,
    )
    for run, (model, apart, levels, kept) in enumerate(runs):
        factor = np.ones(len(levels))
        for group in noise_groups(model):
            own = np.where(kept[:, group], apart[:, group] / levels[group], np.nan)
            samples = int(np.isfinite(own).sum())
            white = white_level(model.recording.time, own)
            excess = float(np.nanmean(own**2)) / white**2
            squares, count = squares + samples * excess, count + samples
            by_chance = PATTERN + PATTERN_BY_CHANCE / math.sqrt(samples)
            groups.append(GroupExcess(run, group, excess, by_chance, white * levels[group]))
            if excess > by_chance:
                factor[group] = math.sqrt(max(1.0, _correlation_time(own)))
                named.append(model.channels[group[-1]].header)
        widening.append(factor)
    return Pattern(squares / count, widening, tuple(named), tuple(groups))


def _correlation_time(residuals: np.ndarray) -> float:
    """Rows (T, c) that count as one independent row: 1 + 2 times the sum of correlations."""
    filled = np.where(np.isfinite(residuals), residuals, 0.0)
    variance, total = float(np.mean(filled**2)), 1.0
    for lag in range(1, int(MAX_LAGS * len(filled)) + 1):
        correlation = float(np.mean(filled[lag:] * filled[:-lag])) / variance
        if correlation < UNCORRELATED:
            break
        total += 2 * correlation
    return total
