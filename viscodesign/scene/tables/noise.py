"""White noise in measured rows: its standard deviation, found without a model of the signal."""

from __future__ import annotations

import itertools

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class NoiseRule:
    """What counts as white noise."""

    fewest_rows: int = 60
    orders: tuple[int, ...] = (1, 2, 3, 4)
    """Rows on each side from which a row is predicted."""
    level_rel_tol: float = 0.1
    """Difference of the levels by two orders that counts as none, and for few rows..."""
    level_rows: float = 2.0
    """...this over the root of their number more."""
    outlier: float = 4.0
    """Standard deviations from which a residual is a jump of the signal, no noise."""
    most_correlation: float = 6.0
    """Largest correlation of residuals that share no row, times the root of their number."""
    lags: int = 40
    least_rel: float = 1e-3
    """Share of the range below which noise changes neither t_i nor the cost of a run much."""
    most_rel: float = 0.05
    """Share of the range above which rows that vary at random are a signal of their own."""
    step: float = 1.5
    """Standard deviations of the smallest step between values, above which these are rounded."""
    blocks: int = 16
    block_rows: int = 4096
    """Rows of a block: of a long table, blocks in equal distances stand for all."""


RULE = NoiseRule()


def white_noise(time: np.ndarray, value: np.ndarray) -> float:
    """Standard deviation of the white noise in rows (n,); 0 where there is none, or no rows to say.

    Each row is predicted by a polynomial through its neighbours. The residual of a smooth signal
    falls with the order of the polynomial; that of white noise has the same size in all orders, and
    no correlation between residuals without a common row. Jumps are few, so medians ignore them.
    After T. Gasser, L. Sroka, C. Jennen-Steinmetz, Residual variance and residual pattern in
    nonlinear regression, Biometrika 73 (1986), for the prediction by two neighbours.
    """
    size = float(np.ptp(value))
    if len(time) < RULE.fewest_rows or size == 0.0:
        return 0.0
    found = [_level(time, value, order) for order in RULE.orders]
    tolerance = RULE.level_rel_tol + RULE.level_rows / np.sqrt(len(time))
    for (level, correlation), (finer, _) in itertools.pairwise(found):
        is_white = finer > 0.0 and abs(level / finer - 1) < tolerance
        if is_white and correlation < RULE.most_correlation:
            is_noise = RULE.least_rel * size <= level <= RULE.most_rel * size
            return level if is_noise and not _is_rounded(value, level) else 0.0
    return 0.0


def _is_rounded(value: np.ndarray, level: float) -> bool:
    """Whether the values are so coarse that rounding, or stairs, make up what varies."""
    return float(np.min(np.diff(np.unique(value)))) > RULE.step * level


def _level(time: np.ndarray, value: np.ndarray, order: int) -> tuple[float, float]:
    """Standard deviation of noise by residuals of an order, and their largest correlation."""
    parts = [prediction_errors(time[b], value[b], order) for b in _blocks(len(time))]
    residuals = np.concatenate(parts)
    if not len(residuals):
        return 0.0, 0.0
    level = float(np.median(np.abs(residuals))) / 0.6745  # of a normal distribution
    if not level > 0.0:
        return 0.0, 0.0
    plain = np.where(np.abs(residuals) < RULE.outlier * level, residuals, 0.0)
    variance, first = float(np.mean(plain**2)), 2 * order + 1
    last = min(first + RULE.lags, len(plain) // 3)
    shared = [abs(float(np.mean(plain[k:] * plain[:-k]))) for k in range(first, last)]
    return level, max(shared, default=0.0) / variance * np.sqrt(len(plain))


def _blocks(rows: int) -> list[slice]:
    size, count = RULE.block_rows, RULE.blocks
    if rows <= size * count:
        return [slice(0, rows)]
    return [slice(k, k + size) for k in np.linspace(0, rows - size, count).astype(int)]


def prediction_errors(time: np.ndarray, value: np.ndarray, order: int) -> np.ndarray:
    """Errors of predicting each row by ``order`` rows on each side, with the variance of a row.

    Rows beside a jump have none.
    """
    centre = np.arange(order, len(time) - order)
    spans = time[centre + order] - time[centre - order]
    steps = np.lib.stride_tricks.sliding_window_view(np.diff(time), 2 * order)
    centre = centre[np.min(steps, axis=1) > 1e-6 * spans]
    others = [k for k in range(-order, order + 1) if k]
    apart = {k: time[centre + k] - time[centre] for k in others}
    error, variance = value[centre].astype(float), np.ones(len(centre))
    for k in others:
        weight = np.ones(len(centre))
        for other in others:
            if other != k:
                weight = weight * apart[other] / (apart[other] - apart[k])
        error -= weight * value[centre + k]
        variance += weight**2
    return np.asarray(error / np.sqrt(variance))
