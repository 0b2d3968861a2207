"""Exact response of linear filters to a drive that is straight between its samples."""

from __future__ import annotations

import math
from enum import Enum
from typing import Any

import numpy as np


class FilterStart(Enum):
    """Where filters start, by the words of `run.start`."""

    EQUILIBRIUM = "equilibrium"
    """Settled under the first drive."""
    REST = "rest"
    """At zero."""
    PERIODIC = "periodic"
    """Where they end: the time is a whole number of periods of the drive."""


NEARLY_ZERO = 1e-2
"""Rate times step below which exponentials are taken by their series."""

FEW = 4
"""Filters up to which joining steps is faster than taking them one by one."""


def first_order(
    rate: np.ndarray, time: np.ndarray, drive: np.ndarray, start: np.ndarray
) -> np.ndarray:
    """y' = rate y + drive at every sample (T, M).

    ``rate`` (M,) may be complex [1/s], or one for all (1,); ``time`` (T,) ascending, equal times
    are a jump; ``drive`` (T, M); ``start`` (M,). Exact for a drive that is linear between samples.
    """
    step = np.diff(time)[:, None]
    z = rate[None, :] * step
    small = np.abs(z) < NEARLY_ZERO
    safe = np.where(small, 1.0, z)
    growth = np.exp(z)
    level, ramp = (growth - 1) / safe, (growth - 1 - z) / (safe * safe)
    if small.any():
        level[small], ramp[small] = _series(z[small], 1), _series(z[small], 2)
    gain = level * step * drive[:-1] + ramp * step * np.diff(drive, axis=0)
    joined = _doubling if gain.shape[1] <= FEW else _in_parts
    return joined(growth, gain, start)


def _in_parts(growth: np.ndarray, gain: np.ndarray, start: np.ndarray) -> np.ndarray:
    """The recursion y_k+1 = growth_k y_k + gain_k (T, M), with all parts of the time side by side.

    Each part begins at zero; what it begins with is added afterwards.
    """
    count, width = gain.shape
    length = math.isqrt(count) + 1
    parts = -(-count // length)
    kind = np.result_type(growth, gain, start)
    grown, gained = (_filled(values, parts, length, kind) for values in (growth, gain))
    for k in range(1, length):
        gained[:, k] += grown[:, k] * gained[:, k - 1]
        grown[:, k] *= grown[:, k - 1]
    begins = np.empty((parts, 1, width), dtype=kind)
    begins[0] = start
    for k in range(1, parts):
        begins[k] = grown[k - 1, -1] * begins[k - 1] + gained[k - 1, -1]
    found = gained + grown * begins
    return np.concatenate([begins[0], found.reshape(-1, width)[:count]])


def _filled(values: np.ndarray, parts: int, length: int, kind: np.dtype[Any]) -> np.ndarray:
    """Values (T, M) in parts (parts, length, M), the last of them filled up with zeros."""
    found = np.zeros((parts * length, values.shape[1]), dtype=kind)
    found[: len(values)] = values
    return found.reshape(parts, length, -1)


def _series(z: np.ndarray, order: int) -> np.ndarray:
    """(exp z - 1)/z for order 1, (exp z - 1 - z)/z^2 for order 2, near zero."""
    found = np.zeros_like(z)
    for k in range(5, -1, -1):
        found = found * z + 1 / math.factorial(k + order)
    return found


def _doubling(growth: np.ndarray, gain: np.ndarray, start: np.ndarray) -> np.ndarray:
    """The same recursion for few filters: steps are joined to ever longer ones."""
    growth, gain = growth.copy(), gain.astype(np.result_type(growth, gain))
    reach = 1
    while reach < len(gain):
        gain[reach:] += growth[reach:] * gain[:-reach].copy()
        growth[reach:] = growth[reach:] * growth[:-reach].copy()
        reach *= 2
    return np.concatenate([start[None, :] + 0 * gain[:1], gain + growth * start])


def second_order(
    delay: np.ndarray, rate: np.ndarray, time: np.ndarray, drive: np.ndarray, start: FilterStart
) -> np.ndarray:
    """delay y'' + y' + rate y = drive at every sample (T, M), real.

    ``delay`` (M,) [s] > 0, ``rate`` (M,) [1/s], or one for all (1,). A rate of zero stays
    at zero.
    """
    square = 1 - 4 * delay * rate
    root = np.sqrt(square) if np.all(square > 0.0) else np.sqrt(square + 0j)
    root = np.where(np.abs(root) < 1e-6, 1e-6, root)
    fast, slow = (-1 - root) / (2 * delay), (-1 + root) / (2 * delay)
    # The slow root by Vieta: the difference would lose its digits.
    slow = np.where(np.abs(fast) > 0, rate / (delay * fast), slow)
    late = _from_start(slow, time, drive, start)
    # Of a pair of complex poles one tells the other.
    ringing = bool(np.all(square < 0.0))
    early = np.conj(late) if ringing else _from_start(fast, time, drive, start)
    found = np.real((late - early) / (delay * (slow - fast)))
    return np.where(rate > 0.0, found, 0.0)


def _from_start(
    pole: np.ndarray, time: np.ndarray, drive: np.ndarray, start: FilterStart
) -> np.ndarray:
    """One pole's filter."""
    held = np.where(np.abs(pole) > 0, -drive[0] / np.where(pole == 0, 1, pole), 0.0)
    return first_order(pole, time, drive, start_of(start, held, pole, time, drive))


def start_of(
    start: FilterStart,
    settled: np.ndarray,
    rate: np.ndarray,
    time: np.ndarray,
    drive: np.ndarray,
) -> np.ndarray:
    """Values (M,) at which filters of `first_order` start; ``settled`` (M,): in equilibrium."""
    if start is FilterStart.EQUILIBRIUM:
        return settled
    if start is FilterStart.REST:
        return np.asarray(0 * settled)
    # What is left of the start in the end, and what the drive has added to it.
    lost = -np.expm1(rate * (time[-1] - time[0]))
    added = first_order(rate, time, drive, 0 * settled)[-1]
    return np.where(rate != 0, added / np.where(rate != 0, lost, 1.0), 0.0)
