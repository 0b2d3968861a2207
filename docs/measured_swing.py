"""A beam that is let go and swings into rest: what is compared of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from fitted import fitted

REST_FROM = 3.0
"""Time from which a beam is at rest [s]."""
COMPARED = 1.5
"""Time in which motions are compared [s]."""
SHIFTS = np.arange(-0.03, 0.0301, 0.001)
"""Shifts of a clock that are tried [s]: the time of the release is known to some frames."""
CROSSINGS = 5
"""Passages through the place of rest that tell the period."""


@dataclass(frozen=True, eq=False)
class Swing:
    """A tip over time."""

    time: np.ndarray
    """(T,) [s]"""
    tip: np.ndarray
    """(T, 2): x (down), z (along the beam) [m]."""

    @property
    def static(self) -> float:
        """How far down it comes to rest [m]."""
        return float(self.tip[self.time >= REST_FROM, 0].mean())

    @property
    def lowest(self) -> float:
        """How far down it swings first [m]: of the parabola through the lowest three rows."""
        k = int(np.argmax(self.tip[:, 0]))
        return _vertex(self.tip[k - 1 : k + 2, 0])

    @property
    def period(self) -> float:
        """Mean period of the first swings, by passages through the place of rest [s]."""
        times = self._crossings()
        return float(2 * np.polyfit(np.arange(len(times)), times, 1)[0])

    @property
    def decrement(self) -> float:
        """Logarithm of the first overshoot over the next one to the same side [1]."""
        off = self.tip[:, 0] - self.static
        times = self._crossings()
        first = off[self.time < times[1]].max()
        second = off[(self.time > times[2] - 1e-9) & (self.time < times[3])].max()
        return float(np.log(first / second))

    @property
    def early_middle(self) -> float:
        """Middle of the third and fourth swings [m]: of a damped cosine through their rows."""
        begin, period = 2 * self.period, self.period
        known = (self.time >= begin) & (self.time < begin + 2 * period)
        time, x = self.time[known] - begin, self.tip[known, 0]
        size = float(np.ptp(x)) / 2

        def left(unknowns: np.ndarray) -> np.ndarray:
            middle, cosine, sine, rate, decay = unknowns
            phase = 2 * np.pi * rate * time / period
            wave = cosine * np.cos(phase) + sine * np.sin(phase)
            return np.asarray(middle + np.exp(-decay * time / period) * wave - x / size)

        middle = x.mean() / size
        start = np.array([middle, 0.7, 0.7, 1.0, self.decrement])
        low, high = [middle - 1, -3, -3, 0.8, -1], [middle + 1, 3, 3, 1.25, 3]
        return float(fitted(left, start, low, high)[0]) * size

    def _crossings(self) -> np.ndarray:
        off = self.tip[:, 0] - self.static
        k = np.flatnonzero(off[:-1] * off[1:] < 0.0)[:CROSSINGS]
        step = np.diff(self.time)[k]
        return np.asarray(self.time[k] + step * off[k] / (off[k] - off[k + 1]))

    def distances(self, other: Swing, shift: float) -> np.ndarray:
        """Distances of the tips at this swing's times, the other one by ``shift`` later [m]."""
        known = (self.time <= COMPARED) & np.isfinite(self.tip).all(axis=1)
        times = self.time[known] - shift
        theirs = [np.interp(times, other.time, column) for column in other.tip.T]
        return np.asarray(self.tip[known] - np.column_stack(theirs))

    def rms(self, other: Swing) -> tuple[float, float]:
        """Root mean square distance [m] with the clock that fits best, and its shift [s]."""
        found = [np.sqrt(np.mean(np.sum(self.distances(other, s) ** 2, axis=1))) for s in SHIFTS]
        best = int(np.argmin(found))
        return float(found[best]), float(SHIFTS[best])


def _vertex(values: np.ndarray) -> float:
    """Largest value of the parabola through three equidistant ones."""
    slope, bend = (values[2] - values[0]) / 2, values[2] - 2 * values[1] + values[0]
    return float(values[1] - (slope**2 / (2 * bend) if bend < 0.0 else 0.0))
