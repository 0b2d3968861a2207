"""Exact response of linear filters to a drive that is straight between its samples.

A filter may have several channels, driven apart: the axes of its drive between the first, which
counts filters, and the last, which counts samples.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Sequence
from enum import Enum
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.angles import MAX_ANGLE
from viscodesign.native.loops import native_loops
from viscodesign.native.machine import this_machine
from viscodesign.native.source.filters import NEARLY_ZERO
from viscodesign.native.unavailable import NativeUnavailable


class FilterStart(Enum):
    """Where filters start, by the words of `run.start`."""

    EQUILIBRIUM = "equilibrium"
    """Settled under the first drive."""
    REST = "rest"
    """At zero."""
    PERIODIC = "periodic"
    """Where they end: the time is a whole number of periods of the drive."""


def first_order(
    rate: np.ndarray, time: np.ndarray, drive: np.ndarray, start: np.ndarray
) -> np.ndarray:
    """y' = rate y + drive at every sample (M, ..., T).

    ``rate`` (M,) [1/s] may be complex; ``drive`` (M, ..., T) is real; ``time`` (T,) ascending,
    equal times are a jump; ``start`` (M, ...). Exact for a drive that is linear between samples.
    """
    if not np.iscomplexobj(rate):
        with contextlib.suppress(NativeUnavailable):
            return _by_loop("follow", [rate], time, drive, np.array(start, dtype=float))
    channels = math.prod(drive.shape[1:-1])
    sampled = np.moveaxis(drive.reshape(len(rate), channels, len(time)), -1, 0)
    growth, level, ramp = (c[..., None] for c in _over_steps(rate, np.diff(time)))
    gain = level * sampled[:-1] + ramp * np.diff(sampled, axis=0)
    found = _joined(growth, gain, start.reshape(len(rate), channels))
    return np.moveaxis(found, 0, -1).reshape(drive.shape)


def _by_loop(
    loop: str,
    numbers: Sequence[np.ndarray],
    time: np.ndarray,
    drive: np.ndarray,
    state: np.ndarray,
) -> np.ndarray:
    """By a loop of `native.source.filters`, by what it needs of each filter: real (M, ..., T).

    ``state`` (M, ...) becomes the end. Raises `NativeUnavailable`.
    """
    this_machine()  # code that was made before may have been switched off
    loops, step = native_loops(), np.diff(time)
    found, room = np.empty(drive.shape), np.empty(6 * len(step))
    given = (step, *numbers, drive, state, room, found)
    reals = [np.ascontiguousarray(values).view(float).reshape(-1) for values in given]
    loops(loop, len(step), len(drive), math.prod(drive.shape[1:-1]), *reals)
    return found


def _over_steps(rate: np.ndarray, step: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What is left of a value after steps (n,), and what a level and a ramp of the drive add.

    Each (n, M), the last two [s].
    """
    kinds, place = np.unique(step, return_inverse=True)
    z = kinds[:, None] * rate
    small = np.abs(z) < NEARLY_ZERO
    growth = np.exp(z)
    inverse = 1 / np.where(small, 1.0, z)
    level = (growth - 1) * inverse
    ramp = (level - 1) * inverse
    if small.any():
        level[small], ramp[small] = _series(z[small], 1), _series(z[small], 2)
    level, ramp = level * kinds[:, None], ramp * kinds[:, None]
    return growth[place], level[place], ramp[place]


def _joined(growth: np.ndarray, gain: np.ndarray, start: np.ndarray) -> np.ndarray:
    """The recursion y_k+1 = growth_k y_k + gain_k (T, M, C), all parts of the time side by side.

    ``growth`` (T - 1, M, 1). Each part begins at zero; what it begins with is added afterwards.
    """
    count = len(gain)
    length = math.isqrt(count) + 1
    parts = -(-count // length)
    kind = np.result_type(growth, gain, start)
    grown, gained = (_filled(values, parts, length, kind) for values in (growth, gain))
    for k in range(1, length):
        gained[k] += grown[k] * gained[k - 1]
        grown[k] *= grown[k - 1]
    begins = np.empty((parts, *start.shape), dtype=kind)
    begins[0] = start
    for k in range(1, parts):
        begins[k] = grown[-1, k - 1] * begins[k - 1] + gained[-1, k - 1]
    gained += grown * begins
    found = np.empty((count + 1, *start.shape), dtype=kind)
    found[0] = start
    found[1:] = gained.swapaxes(0, 1).reshape(parts * length, *start.shape)[:count]
    return found


def _filled(values: np.ndarray, parts: int, length: int, kind: np.dtype[Any]) -> np.ndarray:
    """Values (T, ...) as steps of parts (length, parts, ...), the last ones filled with zeros."""
    found = np.zeros((parts * length, *values.shape[1:]), dtype=kind)
    found[: len(values)] = values
    return np.ascontiguousarray(found.reshape(parts, length, *values.shape[1:]).swapaxes(0, 1))


def _series(z: np.ndarray, order: int) -> np.ndarray:
    """(exp z - 1)/z for order 1, (exp z - 1 - z)/z^2 for order 2, near zero."""
    found = np.zeros_like(z)
    for k in range(5, -1, -1):
        found = found * z + 1 / math.factorial(k + order)
    return found


def second_order(
    delay: np.ndarray, rate: np.ndarray, time: np.ndarray, drive: np.ndarray, start: FilterStart
) -> np.ndarray:
    """delay y'' + y' + rate y = drive at every sample (M, ..., T), real.

    ``delay`` (M,) [s] > 0, ``rate`` (M,) [1/s]. A rate of zero stays at zero.
    """
    filters = _SecondOrder(delay, rate, time, drive, start)
    swings, far = filters.square < 0.0, filters.largest_turn > MAX_ANGLE
    found = np.zeros(drive.shape)
    for own, response in (
        (swings & ~far, _swinging),
        (swings & far, _swinging_far),
        (~swings, _creeping),
    ):
        own &= rate > 0.0
        if own.all():
            return response(filters)
        if own.any():
            found[own] = response(filters.some(own))
    return found


@dataclass(frozen=True, eq=False)
class _SecondOrder:
    """Filters and what drives them (see `second_order`)."""

    delay: np.ndarray
    rate: np.ndarray
    time: np.ndarray
    drive: np.ndarray
    start: FilterStart

    @property
    def square(self) -> np.ndarray:
        """Square of the poles' distance from the middle, relative to the middle (M,) [1]."""
        return np.asarray(1 - 4 * self.delay * self.rate)

    @property
    def turning(self) -> tuple[np.ndarray, np.ndarray]:
        """One of two complex poles (M,), and what its imaginary part is to be multiplied by."""
        root = np.maximum(np.sqrt(np.maximum(-self.square, 0.0)), MIN_ROOT)
        return (1j * root - 1) / (2 * self.delay), 2 / root

    @property
    def largest_turn(self) -> np.ndarray:
        """Angle by which each swings in the longest step (M,) [rad]."""
        longest = np.max(np.diff(self.time), initial=0.0)
        return np.asarray(longest * self.turning[0].imag)

    def some(self, own: np.ndarray) -> _SecondOrder:
        """Some of the filters."""
        numbers = self.delay[own], self.rate[own], self.time, self.drive[own]
        return _SecondOrder(*numbers, self.start)

    def of_pole(self, pole: np.ndarray) -> np.ndarray:
        """The response of first order with one pole of each (M, ..., T)."""
        return _from_start(pole, self.time, self.drive, self.start)


def _swinging(filters: _SecondOrder) -> np.ndarray:
    """Those with a pair of complex poles, of which one tells the other."""
    pole, scale = filters.turning
    drive, time = filters.drive, filters.time

    def ended(state: np.ndarray) -> np.ndarray:
        _by_loop("follow_turning", [pole, scale], time, drive, state)
        return state

    try:
        state = start_of(filters.start, _held(pole, drive), pole, time, drive, ended)
        return _by_loop("follow_turning", [pole, scale], time, drive, state)
    except NativeUnavailable:
        return _swinging_far(filters)


def _swinging_far(filters: _SecondOrder) -> np.ndarray:
    """The same by arrays, also where they turn by more than the loop takes."""
    pole, scale = filters.turning
    found = filters.of_pole(pole)
    return np.asarray(found.imag * _wide(scale, found))


def _creeping(filters: _SecondOrder) -> np.ndarray:
    """Those with two real poles."""
    delay = filters.delay
    root = np.maximum(np.sqrt(filters.square), MIN_ROOT)
    fast = (-1 - root) / (2 * delay)
    # The slow root by Vieta: the difference would lose its digits.
    slow = filters.rate / (delay * fast)
    late, early = (filters.of_pole(pole) for pole in (slow, fast))
    return np.asarray((late - early) * _wide(1 / (delay * (slow - fast)), late))


MIN_ROOT = 1e-6
"""Distance at which equal poles are held apart, relative to their size."""


def _wide(values: np.ndarray, others: np.ndarray) -> np.ndarray:
    """One value per filter (M,), for all that ``others`` (M, ...) has of it."""
    return values.reshape(-1, *[1] * (others.ndim - 1))


def _from_start(
    pole: np.ndarray, time: np.ndarray, drive: np.ndarray, start: FilterStart
) -> np.ndarray:
    """One pole's filter."""
    own = (pole, time, drive)
    return first_order(*own, start_of(start, _held(pole, drive), *own))


def _held(pole: np.ndarray, drive: np.ndarray) -> np.ndarray:
    """Values (M, ...) in equilibrium with the first drive."""
    return np.asarray(drive[..., 0] * _wide(-1 / pole, drive[..., 0]))


def start_of(
    start: FilterStart,
    settled: np.ndarray,
    rate: np.ndarray,
    time: np.ndarray,
    drive: np.ndarray,
    ended: Callable[[np.ndarray], np.ndarray] | None = None,
) -> np.ndarray:
    """Values (M, ...) at which filters start; ``settled``: in equilibrium.

    ``ended``: where they end that start somewhere, if not by `first_order`.
    """
    if start is FilterStart.EQUILIBRIUM:
        return settled
    nothing = np.zeros_like(settled)
    if start is FilterStart.REST:
        return nothing
    # What is left of the start in the end, and what the drive has added to it.
    lost = _wide(-np.expm1(rate * (time[-1] - time[0])), settled)
    added = ended(nothing) if ended else first_order(rate, time, drive, nothing)[..., -1]
    return np.where(lost != 0, added / np.where(lost != 0, lost, 1.0), 0.0)
