"""Bounds on a motion, and where a run leaves them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice


@dataclass(frozen=True)
class MotionBlock:
    """Consecutive outputs of a run: T times, B bellows, Q tubes, S sections."""

    time: np.ndarray
    pressure: np.ndarray
    """(T, B) gauge [Pa]."""
    volume: np.ndarray
    """(T, B) [m3]."""
    flow: np.ndarray
    """(T, Q) [m3/s]."""
    tube_pressure: np.ndarray
    """(T, Q) lower gauge pressure of each tube's ends [Pa]."""
    section_stretch: np.ndarray
    """(T, S) smallest total stretch of each section [1]."""
    section_turn: np.ndarray
    """(T, S) angle that each section turns [rad]."""


class Peak:
    """The largest of values that come block by block, with its time and its column."""

    def __init__(self) -> None:
        self.value = -np.inf
        self.time_s = 0.0
        self.column = 0
        self.columns = np.zeros(0)
        """The largest of every column (n,)."""

    def update(self, time: np.ndarray, values: np.ndarray) -> None:
        """Add rows (T, n) at times (T,)."""
        if not values.size:
            return
        row, column = np.unravel_index(int(np.argmax(values)), values.shape)
        if values[row, column] > self.value:
            self.value = float(values[row, column])
            self.time_s, self.column = float(time[row]), int(column)
        highest = values.max(axis=0)
        self.columns = np.maximum(self.columns, highest) if self.columns.size else highest


@dataclass(frozen=True)
class Limit:
    """A bound of the model's validity, and the warning of a run that exceeds it."""

    values: Callable[[MotionBlock], np.ndarray]
    """Quantity of the motion that the bound is for (T, n)."""
    bound: float
    notice: Callable[[Peak], Notice]
    """The warning, for the worst place and time of the run."""
    inclusive: bool = False
    """Whether the bound itself is too much."""

    def is_exceeded(self, peak: Peak) -> bool:
        """Whether a run with this peak is beyond the bound."""
        return peak.value >= self.bound if self.inclusive else peak.value > self.bound


def limit_notices(limits: Iterable[Limit], blocks: Iterable[MotionBlock]) -> Iterator[Notice]:
    """A warning for every limit that a run exceeds, once, at its worst place and time."""
    peaks = [(limit, Peak()) for limit in limits]
    for block in blocks:
        for limit, peak in peaks if block.time.size else ():
            peak.update(block.time, limit.values(block))
    for limit, peak in peaks:
        if limit.is_exceeded(peak):
            yield limit.notice(peak)
