"""What an input is: a value against time, smooth between corners.

The value is a pressure above the baseline [Pa]; of a syringe, the volume that its
plunger has pushed out [m3].
"""

from __future__ import annotations

import itertools
import math
from abc import abstractmethod
from typing import Any, ClassVar

import numpy as np
from pydantic import Field

from viscodesign.scene.section import Part
from viscodesign.units import Time

SMALL_SWING = 0.01
"""Swings below this part of the whole range do not count for t_i."""
FIRST, LAST = 0.01, 0.99
"""Parts of a swing between which its time is taken."""


class Input(Part):
    """The drive of one inlet; a kind is a file with one subclass."""

    name: ClassVar[str]
    coefficients: ClassVar[int]
    """Numbers that tell one interval between corners from another."""
    gives_pressure: ClassVar[bool] = True
    """Whether its value is a pressure; if not, it is the volume that a plunger pushes out."""

    transient_time: Time | None = Field(
        None, gt=0, description="t_i, where it is known better than from the profile"
    )

    @abstractmethod
    def expression(self, t: Any, piece: Any, functions: Any) -> Any:
        """Value inside an interval, from numpy's or CasADi's functions."""

    @abstractmethod
    def corners(self, duration: float) -> list[float]:
        """Times in (0, duration) at which a solver must start afresh, ascending."""

    @abstractmethod
    def pieces(self, edges: np.ndarray) -> np.ndarray:
        """Coefficients (n, coefficients) of the intervals of ``edges`` (n + 1,)."""

    @abstractmethod
    def initial_piece(self) -> np.ndarray:
        """Coefficients (coefficients,) just before t = 0."""

    @abstractmethod
    def values(self, t: np.ndarray) -> np.ndarray:
        """Value at times (n,); after a jump its new one."""

    @abstractmethod
    def extremes(self, duration: float) -> tuple[float, float]:
        """Lowest and highest value that a run of this duration meets: exact, never sampled."""

    @abstractmethod
    def swing_time(self) -> float:
        """Shortest monotone swing of the profile, 1 % to 99 % [s]; infinite without one."""

    @property
    def period(self) -> float | None:
        """Length of a cycle [s] of a profile that repeats itself."""
        return None

    def transient(self) -> float:
        """t_i: as the spec states it, else from the profile."""
        return self.swing_time() if self.transient_time is None else self.transient_time


class PiecewiseLinear(Input):
    """Straight lines between vertices; two vertices at one time are a jump."""

    coefficients: ClassVar[int] = 3

    @abstractmethod
    def vertices(self, duration: float) -> np.ndarray:
        """(n, 2): time and value from 0 on, to the duration or the last change."""

    @abstractmethod
    def initial(self) -> float:
        """Value just before t = 0."""

    @abstractmethod
    def profile(self) -> list[tuple[float, float]]:
        """Vertices that show every swing once."""

    def expression(self, t: Any, piece: Any, functions: Any) -> Any:
        del functions
        value, slope, reference = piece[0], piece[1], piece[2]
        return value + slope * (t - reference)

    def corners(self, duration: float) -> list[float]:
        time = self.vertices(duration)[:, 0]
        return [float(t) for t in np.unique(time[(time > 0.0) & (time < duration)])]

    def pieces(self, edges: np.ndarray) -> np.ndarray:
        middles = (edges[:-1] + edges[1:]) / 2
        starts, values, slopes = self._lines(float(edges[-1]))
        index = np.searchsorted(starts, middles, side="right") - 1
        reference = edges[:-1]
        at_start = values[index] + slopes[index] * (reference - starts[index])
        return np.column_stack((at_start, slopes[index], reference))

    def initial_piece(self) -> np.ndarray:
        return np.array([self.initial(), 0.0, 0.0])

    def values(self, t: np.ndarray) -> np.ndarray:
        times = np.asarray(t, dtype=float)
        starts, values, slopes = self._lines(float(np.max(times, initial=0.0)))
        index = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        return np.asarray(values[index] + slopes[index] * (times - starts[index]))

    def extremes(self, duration: float) -> tuple[float, float]:
        """Of the vertices before the end, and of the line that leads up to it."""
        points = self.vertices(duration)
        met = points[points[:, 0] < duration, 1]
        starts, values, slopes = self._lines(duration)
        last = max(int(np.searchsorted(starts, duration)) - 1, 0)
        end = float(values[last] + slopes[last] * (duration - starts[last]))
        return float(np.min(met, initial=end)), float(np.max(met, initial=end))

    def _lines(self, duration: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Start, value there and slope of every line; the last runs on level."""
        points = self.vertices(duration)
        time, value = points[:, 0], points[:, 1]
        step = np.diff(time)
        real = step > 0.0
        slope = np.diff(value)[real] / step[real]
        return (
            np.append(time[:-1][real], time[-1]),
            np.append(value[:-1][real], value[-1]),
            np.append(slope, 0.0),
        )

    def swing_time(self) -> float:
        return shortest_swing(self.profile())


def points_of(vertices: np.ndarray) -> list[tuple[float, float]]:
    """Rows (n, 2) as pairs."""
    return [(float(t), float(p)) for t, p in vertices]


def shortest_swing(profile: list[tuple[float, float]]) -> float:
    """Time of the shortest monotone swing between vertices, 1 % to 99 % of it [s].

    What turns back by less than `SMALL_SWING` of the whole range is noise upon a swing.
    A hold parts two swings, unless they are as small.
    """
    values = [p for _, p in profile]
    smallest = SMALL_SWING * (max(values) - min(values))
    times = [
        _swing_time(part, smallest)
        for swing in _between_turns(profile, smallest)
        for part in _between_holds(swing, smallest)
    ]
    return min(times, default=math.inf)


Profile = list[tuple[float, float]]


def _between_turns(profile: Profile, smallest: float) -> list[Profile]:
    """Parts from one turning point to the next, which lies more than ``smallest`` away."""
    parts: list[Profile] = []
    start = extreme = 0
    for k, (_, value) in enumerate(profile):
        height = profile[extreme][1] - profile[start][1]
        if (value - profile[extreme][1]) * (height or value - profile[start][1]) >= 0:
            extreme = k
        elif abs(value - profile[extreme][1]) > smallest:
            parts.append(profile[start : extreme + 1])
            start, extreme = extreme, k
    return [*parts, profile[start : extreme + 1]]


def _between_holds(swing: Profile, smallest: float) -> list[Profile]:
    """The parts of a swing that holds separate; the whole swing where none of them counts."""
    holds = [k for k in range(1, len(swing)) if swing[k][1] == swing[k - 1][1]]
    starts, ends = [0, *holds], [*(k - 1 for k in holds), len(swing) - 1]
    parts = [swing[a : b + 1] for a, b in zip(starts, ends, strict=True)]
    large = [part for part in parts if abs(part[-1][1] - part[0][1]) > smallest]
    return large or [swing]


def _swing_time(swing: Profile, smallest: float) -> float:
    """From the last time at 1 % to the first at 99 %; none for what is small; 0 at a jump."""
    height = swing[-1][1] - swing[0][1]
    if abs(height) <= smallest:
        return math.inf
    jumps = (b[0] == a[0] and abs(b[1] - a[1]) > smallest for a, b in itertools.pairwise(swing))
    if any(jumps):
        return 0.0
    part = np.maximum.accumulate([(p - swing[0][1]) / height for _, p in swing])
    times = [t for t, _ in swing]
    return float(np.interp(LAST, part, times) - np.interp(FIRST, part, times))
