"""The part of a run that is its loop: the last full period, or all of it."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property

NODE_SHARE = 1e-9
"""Distance from an output time, of the interval, at which a time counts as that output time."""
WHOLE_PERIOD_REL_TOL = 1e-9
"""Part of a period that a run may lack and still contain it."""


@dataclass(frozen=True)
class LoopPart:
    """The last full period of a run, or all of it where there is none."""

    time: np.ndarray
    """(T,) output times [s], increasing."""
    start: float
    """Where the loop begins [s]; it ends at the last output time."""
    is_period: bool
    """Whether it is one period; otherwise the whole run."""

    @classmethod
    def of(cls, time: np.ndarray, period: float | None) -> LoopPart:
        """That of a run with output times (T,), T > 0, and this period [s], if it has one."""
        first, last = float(time[0]), float(time[-1])
        if period is None or last - period < first - WHOLE_PERIOD_REL_TOL * period or last == first:
            return cls(time, first, False)
        return cls(time, max(last - period, first), True)

    @property
    def duration(self) -> float:
        """[s]."""
        return float(self.time[-1]) - self.start

    @property
    def intervals(self) -> int:
        """Number of output intervals, rounded; 1 for a period that is shorter than they are."""
        inside = int(np.sum(self.time > self.start))
        first = len(self.time) - inside
        if first == 0:
            return inside
        gap = self.time[first] - self.time[first - 1]
        return max(1, inside - 1 + round(float((self.time[first] - self.start) / gap)))

    @cached_property
    def path(self) -> SampledTimes:
        """Its start and every output time after that."""
        after = self.time[self.time > self.start]
        return self._sampled(np.append(self.start, after), np.append(1.0, np.zeros(len(after))))

    def even(self, intervals: int) -> SampledTimes:
        """Times at equal distances, from its start to its end."""
        shares = np.arange(intervals + 1) / intervals
        return self._sampled(self.start + self.duration * shares, 1 - shares)

    def _sampled(self, at: np.ndarray, moves_with_start: np.ndarray) -> SampledTimes:
        return SampledTimes(self.time, at, -moves_with_start if self.is_period else 0 * at)


@dataclass(frozen=True)
class SampledTimes:
    """Times within a run; between output times everything is linear."""

    time: np.ndarray
    """(T,) output times [s]."""
    at: np.ndarray
    """(m,) [s]."""
    rates: np.ndarray
    """(m,) change of ``at`` with the period."""

    @cached_property
    def _cells(self) -> np.ndarray:
        """Row (m,) before each time; the last but one at the end."""
        last = max(len(self.time) - 2, 0)
        return np.clip(np.searchsorted(self.time, self.at, side="right") - 1, 0, last)

    @cached_property
    def _shares(self) -> np.ndarray:
        """(m,) of the way to the next row."""
        if len(self.time) < 2:
            return np.zeros(len(self.at))
        before, after = self.time[self._cells], self.time[self._cells + 1]
        return np.asarray((self.at - before) / (after - before))

    def values(self, rows: np.ndarray) -> np.ndarray:
        """(m, ...) from values (T, ...) at the output times."""
        if len(rows) < 2:
            return np.asarray(rows[self._cells])
        share = self._shares.reshape(-1, *(1,) * (rows.ndim - 1))
        return np.asarray((1 - share) * rows[self._cells] + share * rows[self._cells + 1])

    def pulled_back(self, gradient: np.ndarray) -> np.ndarray:
        """Gradient (T, ...) at the output times from that (m, ...) of `values`."""
        found = np.zeros((len(self.time), *gradient.shape[1:]))
        share = self._shares.reshape(-1, *(1,) * (gradient.ndim - 1))
        np.add.at(found, self._cells, (1 - share) * gradient)
        if len(self.time) > 1:
            np.add.at(found, self._cells + 1, share * gradient)
        return found

    def change_with_period(self, rows: np.ndarray, *, later: bool = False) -> np.ndarray:
        """Derivative (m, ...) of `values` with the period, the rows fixed.

        At an output time, where the polyline has a corner, the mean of both sides, or that of the
        ``later`` one, to which the vertices of a path belong.
        """
        if len(rows) < 2:
            return np.zeros((len(self.at), *rows.shape[1:]))
        steps = np.diff(self.time).reshape(-1, *(1,) * (rows.ndim - 1))
        slopes = np.diff(rows, axis=0) / steps
        last = len(slopes) - 1
        right = self._cells + (self._shares > 1 - NODE_SHARE)
        left = right if later else self._cells - (self._shares < NODE_SHARE)
        mean = (slopes[np.clip(left, 0, last)] + slopes[np.clip(right, 0, last)]) / 2
        return np.asarray(self.rates.reshape(-1, *(1,) * (rows.ndim - 1)) * mean)
