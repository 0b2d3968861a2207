"""By how much one motion is later than another, such as by a clock that was started late."""

from __future__ import annotations

import numpy as np

from viscodesign.comparison.interpolation import motion_curve
from viscodesign.results.run_comparison import ComparedMotion, TimeShift

SHIFT_TIMES = 400
"""Times at which two motions are compared for one shift."""
TRIED = 201
"""Shifts at equal distances, before the best of them is refined."""
MIN_OVERLAP = 0.5
"""Part of the shorter motion that a shift has to leave in common."""
REFINEMENTS = 3


def time_shift(first: ComparedMotion, other: ComparedMotion) -> TimeShift | None:
    """The shift with the smallest root mean square distance; None where there is no choice."""
    spans = [float(np.ptp(m.time)) for m in (first, other)]
    if min(spans) <= 0.0 or min(len(first.time), len(other.time)) < 3:
        return None
    least = MIN_OVERLAP * min(spans)
    low, high = other.time[0] - first.time[-1] + least, other.time[-1] - first.time[0] - least
    curves = [motion_curve(m.time, m.tip) for m in (first, other)]
    ends = [(m.time[0], m.time[-1]) for m in (first, other)]

    def distance(shift: float) -> float:
        """Distance of the second motion, moved back by a shift, over the time that both then
        have [m]."""
        start = max(ends[0][0], ends[1][0] - shift)
        end = min(ends[0][1], ends[1][1] - shift)
        at = np.linspace(start, end, SHIFT_TIMES)
        apart = curves[1](at + shift) - curves[0](at)
        return float(np.sqrt(np.mean(np.sum(apart**2, axis=1))))

    best, rms = 0.0, np.inf
    for _ in range(1 + REFINEMENTS):
        shifts = np.linspace(low, high, TRIED)
        found = [distance(float(shift)) for shift in shifts]
        k = int(np.argmin(found))
        if found[k] < rms:
            best, rms = float(shifts[k]), found[k]
        low, high = (float(shifts[min(max(k + j, 0), TRIED - 1)]) for j in (-1, 1))
    return TimeShift(best, float(rms))
