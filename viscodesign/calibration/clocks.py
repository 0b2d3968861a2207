"""Clocks that run late: a first guess, and whether the data call for one at all."""

from __future__ import annotations

import numpy as np

from viscodesign.calibration.run_model import RunModel

MOST_GUESSES = 401
LONGEST = 0.25
"""Of a recording, the latest that is tried."""
CLEARLY_BETTER = 0.9
"""Of the misfit without a shift, that with one from which a search begins."""
CERTAIN = 4.0
"""Standard deviations from which a clock counts as late."""


def guessed_lateness(model: RunModel, free: np.ndarray, levels: np.ndarray) -> float:
    """How late a run's clock is [s], by the motion of the spec's numbers ``free``.

    That motion has other sizes than the measured one, but moves at the same times: for each shift
    a level and a multiple of every channel are fitted.
    """
    time = model.recording.time
    own = model.own_values
    longest = LONGEST * float(time[-1] - time[0])
    shifts = np.linspace(-longest, longest, MOST_GUESSES)
    places = np.flatnonzero(model.is_late)
    measured = model.measured[:, places] / levels[places]
    motions = model.at_shifts(free, own, shifts)
    misfits = np.array([_misfit(measured, rows[:, places] / levels[places]) for rows in motions])
    best, none = int(np.argmin(misfits)), MOST_GUESSES // 2
    is_clear = misfits[best] < CLEARLY_BETTER * misfits[none]
    return float(shifts[best]) if is_clear else 0.0


def _misfit(measured: np.ndarray, expected: np.ndarray) -> float:
    """Mean absolute residual after a level and a multiple for each channel (T, c)."""
    known = np.isfinite(measured)
    total = 0.0
    for k in range(measured.shape[1]):
        rows = known[:, k]
        basis = np.column_stack([np.ones(int(rows.sum())), expected[rows, k]])
        values = measured[rows, k]
        solution, *_ = np.linalg.lstsq(basis, values, rcond=None)
        total += float(np.abs(values - basis @ solution).sum())
    return total


def is_late(lateness: float, deviation: float) -> bool:
    """Whether a clock is late beyond doubt."""
    return abs(lateness) > CERTAIN * deviation
