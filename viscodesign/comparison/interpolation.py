"""A motion between its output times, and how well that is known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.interpolate import CubicHermiteSpline

Curve = Callable[[np.ndarray], np.ndarray]
SAME_TIME_SHARE = 1e-9
"""Times nearer than this, of the whole span, are one."""
MIN_SMOOTH_ROWS = 4
"""Rows below which a motion is a polyline, and no error can be estimated."""


def motion_curve(time: np.ndarray, tip: np.ndarray) -> Curve:
    """Tip (m, 2) at times (m,) within those of a motion (T,), (T, 2) [m].

    A cubic in each interval, with the slopes of central differences: third order where the
    motion is smooth, and a corner is felt in the intervals beside it alone.
    """
    if len(time) == 1:
        return lambda at: np.repeat(tip, len(at), axis=0)
    if len(time) < MIN_SMOOTH_ROWS:
        return lambda at: np.column_stack([np.interp(at, time, values) for values in tip.T])
    cubic = CubicHermiteSpline(time, tip, np.gradient(tip, time, axis=0))
    return lambda at: np.asarray(cubic(np.clip(at, time[0], time[-1])))


def positions(time: np.ndarray, tip: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Tip (m, 2) of a motion at times ``at`` (m,); see `motion_curve`."""
    return motion_curve(time, tip)(at)


def interpolation_error(time: np.ndarray, tip: np.ndarray) -> float:
    """Estimated largest error of `positions` between the rows of a motion [m].

    Every second row is left out and interpolated: the error of intervals twice as long, which is
    several times too large where the motion is smooth, and less so at its corners.
    """
    if len(time) < 2 * MIN_SMOOTH_ROWS:
        return float(np.hypot(*np.diff(tip, axis=0).T).max(initial=0.0)) / 2
    errors = []
    for first in (0, 1):
        kept, left = slice(first, None, 2), slice(first + 1, None, 2)
        inside = time[left] <= time[kept][-1]
        found = positions(time[kept], tip[kept], time[left][inside])
        errors.append(np.hypot(*(found - tip[left][inside]).T).max(initial=0.0))
    return float(max(errors))


def merged_times(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The times of both within the span that both have; empty where there is none."""
    low, high = max(one[0], other[0]), min(one[-1], other[-1])
    near = SAME_TIME_SHARE * max(one[-1] - one[0], other[-1] - other[0])
    if low > high + near:
        return np.zeros(0)
    every = np.union1d(one, other)
    inside = every[(every >= low - near) & (every <= high + near)]
    apart = np.append(True, np.diff(inside) > near)
    return np.asarray(inside[apart])


def has_times(time: np.ndarray, at: np.ndarray) -> bool:
    """Whether all times ``at`` (m,) are output times (T,), so that nothing is interpolated."""
    near = SAME_TIME_SHARE * (time[-1] - time[0])
    right = np.clip(np.searchsorted(time, at), 0, len(time) - 1)
    left = np.maximum(right - 1, 0)
    return bool(np.all(np.minimum(abs(time[right] - at), abs(time[left] - at)) <= near))
