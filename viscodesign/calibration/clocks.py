"""Clocks that run late: a first guess, and whether the data call for one at all."""

from __future__ import annotations

import numpy as np

from viscodesign.calibration.run_model import RunModel

MAX_GUESSES = 401
LONGEST = 0.25
"""Longest clock offset that is tried, as a part of the recording."""
BETTER_START_SHARE = 0.9
"""A search begins from a shift whose misfit is below this part of the misfit without one."""
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
    shifts = np.linspace(-longest, longest, MAX_GUESSES)
    places = np.flatnonzero(model.is_late)
    measured = model.measured[:, places] / levels[places]
    motions = model.at_shifts(free, own, shifts)
    misfits = np.array([_misfit(measured, rows[:, places] / levels[places]) for rows in motions])
    best, none = int(np.argmin(misfits)), MAX_GUESSES // 2
    is_clear = misfits[best] < BETTER_START_SHARE * misfits[none]
    return float(shifts[best]) if is_clear else 0.0


def _misfit(measured: np.ndarray, expected: np.ndarray) -> float:
    """Sum of absolute residuals after a level and a multiple for each channel (T, c)."""
    known = np.isfinite(measured)
    count = np.maximum(known.sum(axis=0), 1)
    given, motion = (_about_means(own, known, count) for own in (measured, expected))
    squares = np.sum(motion**2, axis=0)
    # A channel that does not move has a level alone.
    multiples = np.sum(motion * given, axis=0) / np.where(squares > 0.0, squares, 1.0)
    return float(np.abs(given - multiples * motion).sum())


def _about_means(rows: np.ndarray, known: np.ndarray, count: np.ndarray) -> np.ndarray:
    """Rows (T, c) without the means of those that are known; 0 where they are not."""
    filled = np.where(known, rows, 0.0)
    return np.where(known, filled - np.sum(filled, axis=0) / count, 0.0)


def is_late(lateness: float, deviation: float) -> bool:
    """Whether a clock is late beyond doubt."""
    return abs(lateness) > CERTAIN * deviation
