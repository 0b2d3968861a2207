"""Smoothing of measured rows: without their white noise, or without all above a cut-off."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class SmoothingRule:
    """How noise is taken out."""

    widest_rows: float = 1000.0
    """Widest time, in rows, over which a curve is smoothed; at most a quarter of the rows."""
    factor: float = 4.0
    """By which the stiffness falls where a curve is too smooth."""
    margin: float = 0.8
    """Standard deviations beyond those that noise alone reaches."""
    jump_margin: float = 1.3
    ends: float = 2.5
    """Standard deviations at the two ends, where a run may start in equilibrium, ..."""
    end_rows: int = 8
    """... of the mean of so many rows or more."""
    finish: float = 4.0
    """By which the stiffness falls in the end: the stiffest curve that fits is a little stiff."""
    most_rounds: int = 60
    rows_per_cut_off: float = 64.0
    """Rows averaged into fewer before a cut-off; at 64 the average takes 0.04 % off there."""


RULE = SmoothingRule()


def without_noise(time: np.ndarray, value: np.ndarray, noise: float, bound: float) -> np.ndarray:
    """Rows (n,) without white noise of a standard deviation, jumps kept.

    A smoothing spline that starts stiff and gets softer wherever the mean of what it takes out,
    over 1, 2, 4, ... rows, is more than noise alone explains and more than ``bound``. Source:
    P. L. Davies and M. Meise, Approximating data with weighted smoothing splines, Journal of
    Nonparametric Statistics 20 (2008).
    """
    rows, step = len(time), float(np.median(np.diff(time)))
    cuts = _jumps(time, value, noise)
    widest = min(RULE.widest_rows, rows / 4) * step
    stiffness = np.full(rows, (widest / (2 * math.pi)) ** 4 / step)
    smooth = spline(time, value, stiffness, cuts)
    for _ in range(RULE.most_rounds):
        too_stiff = _beyond_noise(value - smooth, noise, bound)
        if not too_stiff.any():
            return spline(time, value, stiffness / RULE.finish, cuts)
        stiffness[too_stiff] /= RULE.factor
        smooth = spline(time, value, stiffness, cuts)
    return smooth


def below_cut_off(
    time: np.ndarray, value: np.ndarray, period: float
) -> tuple[np.ndarray, np.ndarray]:
    """Times and values without all that is faster than a period [s], at times that follow the rest.

    A smoothing spline, without delay: it passes a sine of this period with 1/sqrt(2) of its
    amplitude, one of frequency f with 1 / (1 + 0.41 (f period)^4). Jumps are smoothed too.
    """
    width = min(period, time[-1] - time[0]) / RULE.rows_per_cut_off
    time, value = _averaged(time, value, width)
    if len(time) < 3:
        return time, value
    spacing = np.gradient(time)
    stiffness = (math.sqrt(2) - 1) * (period / (2 * math.pi)) ** 4 / spacing
    return time, spline(time, value, stiffness, np.zeros(len(time) - 1, dtype=bool))


def spline(
    time: np.ndarray, value: np.ndarray, stiffness: np.ndarray, cuts: np.ndarray
) -> np.ndarray:
    """Values (n,) at the rows of the natural cubic spline z that minimises

    ``sum (value - z)^2 / stiffness + integral z''^2``; nothing is coupled across ``cuts`` (n - 1,).
    By the banded system of C. H. Reinsch, Smoothing by spline functions, Numerische Mathematik 10
    (1967).
    """
    from scipy.linalg import solveh_banded

    gap = np.where(cuts, 1.0, np.diff(time))
    bends = ~(cuts[:-1] | cuts[1:])
    left, right = bends / gap[:-1], bends / gap[1:]
    middle = -left - right
    bands = np.zeros((3, len(time) - 2))
    bands[0] = np.where(bends, (gap[:-1] + gap[1:]) / 3, 1.0)
    bands[0] += left**2 * stiffness[:-2] + middle**2 * stiffness[1:-1] + right**2 * stiffness[2:]
    bands[1, :-1] = gap[1:-1] / 6 * (bends[:-1] & bends[1:])
    bands[1, :-1] += middle[:-1] * left[1:] * stiffness[1:-2]
    bands[1, :-1] += right[:-1] * middle[1:] * stiffness[2:-1]
    bands[2, :-2] = right[:-2] * left[2:] * stiffness[2:-2]
    bend = left * value[:-2] + middle * value[1:-1] + right * value[2:]
    curvature = solveh_banded(bands, bend, lower=True, overwrite_ab=True, check_finite=False)
    force = np.zeros(len(time))
    force[:-2] += left * curvature
    force[1:-1] += middle * curvature
    force[2:] += right * curvature
    return np.asarray(value - stiffness * force)


def _beyond_noise(residual: np.ndarray, noise: float, bound: float) -> np.ndarray:
    """Rows (n,) in a block whose mean residual is larger than that of noise and than a bound."""
    rows, size = len(residual), 1
    sums = np.concatenate([[0.0], np.cumsum(residual)])
    marks = np.zeros(rows + 1, dtype=int)
    while size <= rows // 2:
        limit = _reached_by_noise(rows / size, RULE.margin) * noise * math.sqrt(size) + bound * size
        for first in {0, size // 2}:
            begins = np.arange(first, rows - size + 1, size)
            over = begins[np.abs(sums[begins + size] - sums[begins]) > limit]
            np.add.at(marks, over, 1)
            np.add.at(marks, over + size, -1)
        ends = RULE.ends * noise * math.sqrt(size) + bound * size
        for start in (0, rows - size) if size >= RULE.end_rows else ():
            is_over = abs(sums[start + size] - sums[start]) > ends
            marks[start] += is_over
            marks[start + size] -= is_over
        size *= 2
    return np.asarray(np.cumsum(marks[:-1]) > 0)


def _reached_by_noise(blocks: float, margin: float) -> float:
    """Standard deviations that the largest of many means of noise hardly reaches."""
    return math.sqrt(2 * math.log(math.e * blocks)) + margin


def _jumps(time: np.ndarray, value: np.ndarray, noise: float) -> np.ndarray:
    """Gaps (n - 1,) between rows in which the signal jumps: those of no time, and steep ones.

    A steep gap rises by more than the slopes beside it and noise explain, and is the steepest of
    three.
    """
    gap = np.diff(time)
    excess = np.zeros(len(gap))
    inner = np.minimum(np.minimum(gap[:-2], gap[1:-1]), gap[2:]) > 0.0
    before, own, behind = gap[:-2][inner], gap[1:-1][inner], gap[2:][inner]
    rise = np.diff(value)
    share = own / (2 * before), own / (2 * behind)
    apart = rise[1:-1][inner] - share[0] * rise[:-2][inner] - share[1] * rise[2:][inner]
    spread = share[0] ** 2 + (1 + share[0]) ** 2 + (1 + share[1]) ** 2 + share[1] ** 2
    excess[1:-1][inner] = np.abs(apart) / (noise * np.sqrt(spread))
    is_peak = excess > _reached_by_noise(len(time), RULE.jump_margin)
    is_peak[1:] &= excess[1:] >= excess[:-1]
    is_peak[:-1] &= excess[:-1] >= excess[1:]
    return np.asarray(is_peak | (gap == 0.0))


def _averaged(time: np.ndarray, value: np.ndarray, width: float) -> tuple[np.ndarray, np.ndarray]:
    """Means of the rows in every interval of a width [s], the first and the last time kept."""
    place = np.floor((time - time[0]) / width)
    starts = np.flatnonzero(np.append(True, np.diff(place) > 0))
    count = np.diff(np.append(starts, len(time)))
    times = np.add.reduceat(time, starts) / count
    times[0], times[-1] = time[0], time[-1]
    return times, np.add.reduceat(value, starts) / count
