"""Rates of sampled quantities by cubic splines, without the packages that fit any spline."""

from __future__ import annotations

import numpy as np


def spline_rates(time: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Slopes (n, m), at their samples, of cubic splines through ``values`` (n, m).

    ``time`` (n,) ascending, n > 1. At both ends two intervals share one cubic ("not a knot"); two
    samples make a line, three a parabola. What `scipy.interpolate.CubicSpline` gives, whose
    import takes longer than many a run. Source: C. de Boor, A Practical Guide to Splines,
    chapter IV.
    """
    step = np.diff(time)
    chord = np.diff(values, axis=0) / step[:, None]
    if len(time) == 2:
        return np.repeat(chord, 2, axis=0)
    if len(time) == 3:
        bend = np.diff(chord, axis=0) / step.sum()
        middle = chord[:1] + step[0] * bend
        return np.concatenate([chord[:1] - step[0] * bend, middle, chord[1:] + step[1] * bend])
    from scipy.linalg import solve_banded

    bands = np.zeros((3, len(time)))
    right = np.empty(values.shape)
    bands[0, 2:], bands[2, :-2] = step[:-1], step[1:]
    bands[1, 1:-1] = 2 * (step[:-1] + step[1:])
    right[1:-1] = 3 * (step[1:, None] * chord[:-1] + step[:-1, None] * chord[1:])
    bands[1, 0], bands[0, 1], right[0] = _end(step, chord)
    bands[1, -1], bands[2, -2], right[-1] = _end(step[::-1], chord[::-1])
    return np.asarray(solve_banded((1, 1), bands, right))


def _end(step: np.ndarray, chord: np.ndarray) -> tuple[float, float, np.ndarray]:
    """The first row of the slopes' equations: its two entries and its right side (m,)."""
    first, second = float(step[0]), float(step[1])
    both = first + second
    pull = (first + 2 * both) * second * chord[0] + first**2 * chord[1]
    return second, both, pull / both
