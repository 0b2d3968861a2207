"""How far one motion is from another: at the same time, and at the same phase."""

from __future__ import annotations

import numpy as np

from viscodesign.comparison.coefficient_bands import band_along
from viscodesign.comparison.interpolation import (
    SAME_TIME_SHARE,
    has_times,
    interpolation_error,
    merged_times,
    positions,
)
from viscodesign.comparison.time_shift import time_shift
from viscodesign.errors import UsageError
from viscodesign.results.loop_part import LoopPart
from viscodesign.results.run_comparison import ComparedMotion, PhaseDifference, TipDifference

MIN_PHASES = 360
"""Phases of a period at which motions are compared, or more where they have more rows."""


def tip_difference_of(first: ComparedMotion, other: ComparedMotion) -> TipDifference:
    """A motion against the first. Raises `UsageError` where they have no time in common."""
    time = merged_times(first.time, other.time)
    if not len(time):
        raise UsageError(
            f"{other.label} and {first.label} have no time in common: {_span(other)}, "
            f"{_span(first)}. Compare motions that overlap, or shift the times of a table"
        )
    apart = positions(other.time, other.tip, time) - positions(first.time, first.tip, time)
    distance = np.hypot(*apart.T)
    near = SAME_TIME_SHARE * max(np.ptp(first.time), np.ptp(other.time))
    phase = phase_difference(first, other)
    ends = ((m.time[0] - time[0], m.time[-1] - time[-1]) for m in (first, other))
    return TipDifference(
        label=other.title,
        first=first.title,
        time=time,
        distance=distance,
        rms_m=_rms_over_time(time, distance),
        interpolation_m=sum(_interpolation_error(m, time) for m in (first, other)),
        own_error_m=other.stated_error_m,
        first_error_m=first.stated_error_m,
        is_part=any(abs(gap) > near for pair in ends for gap in pair),
        phase=phase,
        shift=time_shift(first, other) if phase is None else None,
        band=band_along(first, other, time, apart),
        outside=tuple(f"{m.title} ({', '.join(m.outside)})" for m in (first, other) if m.outside),
        has_clock="table" in (first.origin, other.origin),
    )


def _span(motion: ComparedMotion) -> str:
    return f"{motion.label} is from {motion.time[0]:.4g} to {motion.time[-1]:.4g} s"


def _rms_over_time(time: np.ndarray, distance: np.ndarray) -> float:
    """Root mean square over time, by the trapezoidal rule; of one time its value."""
    span = time[-1] - time[0]
    mean = np.trapezoid(distance**2, time) / span if span > 0 else np.mean(distance**2)
    return float(np.sqrt(mean))


def _interpolation_error(motion: ComparedMotion, at: np.ndarray) -> float:
    """Estimate how far interpolation moves a motion that was not given at all these times [m]."""
    if has_times(motion.time, at):
        return 0.0
    first, last = np.searchsorted(motion.time, (at[0], at[-1]))
    rows = slice(max(first - 2, 0), last + 3)
    return interpolation_error(motion.time[rows], motion.tip[rows])


def phase_difference(first: ComparedMotion, other: ComparedMotion) -> PhaseDifference | None:
    """Two motions over one period each; None where one has no whole period."""
    if first.period is None or other.period is None:
        return None
    loops = [LoopPart.of(m.time, m.period) for m in (first, other)]
    if not all(loop.is_period for loop in loops):
        return None
    count = max(MIN_PHASES, *(loop.intervals for loop in loops))
    phase = np.arange(count) / count
    one, two = (_at_phases(m, phase) for m in (first, other))
    shift, squared = _best_shift(one, two)
    return PhaseDifference(
        phase=phase,
        distance=np.hypot(*(two - one).T),
        shift=shift,
        shift_s=shift * first.period,
        shifted_rms_m=float(np.sqrt(max(squared, 0.0))),
    )


def _at_phases(motion: ComparedMotion, phase: np.ndarray) -> np.ndarray:
    """Tip (m, 2) at phases (m,) of the last full period."""
    period, end = motion.period or 1.0, float(motion.time[-1])
    at = end - np.mod(end - phase * period, period)
    return positions(motion.time, motion.tip, at)


def _best_shift(one: np.ndarray, two: np.ndarray) -> tuple[float, float]:
    """By which part of a period the second (m, 2) is late, and what mean square then remains.

    Of shifts by whole phases, then of a parabola through the best and its neighbours.
    """
    spectra = np.fft.rfft(one, axis=0).conj() * np.fft.rfft(two, axis=0)
    correlation = np.fft.irfft(spectra.sum(axis=1), n=len(one)) / len(one)
    squares = np.mean(np.sum(one**2 + two**2, axis=1)) - 2 * correlation
    k = int(np.argmin(squares))
    before, best, after = (float(squares[(k + j) % len(one)]) for j in (-1, 0, 1))
    bend = before - 2 * best + after
    step = (before - after) / (2 * bend) if bend > 0 else 0.0
    shift = (k + step) / len(one)
    return (shift + 0.5) % 1.0 - 0.5, best - (before - after) * step / 4
