"""Variances of the tip from many solutions: what numbers do together as well as alone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from viscodesign.results.sensitivity_study import SampledVariance

SAMPLE_SIZE = 128
"""Size of each of two samples, a power of two; a study takes so many solutions times k + 2."""
SMALLEST_SHARE = 1e-6
"""Part of the normal distribution that is cut off at either end."""

TipAt = Callable[[np.ndarray], np.ndarray]
"""The tip (n, 2) [m] for rows of numbers (n, k); NaN where a solution fails."""


def sampled_variance(
    tip_at: TipAt, values: np.ndarray, deviations: np.ndarray, slopes: np.ndarray, seed: int
) -> SampledVariance:
    """Standard deviations and Sobol indices of the tip at one time, numbers normal, independent.

    ``values``, ``deviations``: (k,) mean and standard deviation of the numbers; ``slopes``: (2, k)
    derivatives of the tip, which stand in where a solution fails. Two Sobol samples by Saltelli's
    scheme, in `scipy.stats.sobol_indices`.
    """
    from scipy.stats import norm, qmc, sobol_indices

    count = len(values)
    shares = qmc.Sobol(2 * count, seed=np.random.default_rng(seed)).random(SAMPLE_SIZE)
    drawn = norm.ppf(np.clip(shares, SMALLEST_SHARE, 1.0 - SMALLEST_SHARE))
    one, other = drawn[:, :count], drawn[:, count:]
    mixed = np.repeat(one[None], count, axis=0)
    for k in range(count):
        mixed[k, :, k] = other[:, k]
    rows = np.concatenate([one, other, *mixed])
    tips = tip_at(values + deviations * rows)
    failed = np.isnan(tips).any(axis=1)
    tips[failed] = tips[~failed].mean(axis=0) + (deviations * rows[failed]) @ slopes.T
    parts = tips.reshape(count + 2, SAMPLE_SIZE, 2).transpose(0, 2, 1)
    found = sobol_indices(func={"f_A": parts[0], "f_B": parts[1], "f_AB": parts[2:]}, n=SAMPLE_SIZE)
    return SampledVariance(
        size=SAMPLE_SIZE,
        solutions=len(rows),
        failed=int(failed.sum()),
        deviation_m=np.std(np.concatenate([parts[0], parts[1]], axis=1), axis=1),
        first_order=np.reshape(found.first_order, (2, count)),
        total_order=np.reshape(found.total_order, (2, count)),
    )
