"""Base of all input kinds: a function of time that is smooth between corners.

Its value is a pressure above the baseline [Pa]; of a syringe, the displaced volume [m3].
"""

from __future__ import annotations

import itertools
import math
from abc import abstractmethod
from collections.abc import Mapping
from functools import singledispatch
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from pydantic import Field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import SpecPart
from viscodesign.storage.distinct import distinct
from viscodesign.units import Time

MIN_SWING_REL = 0.01
"""Swings below this fraction of the range are ignored for t_i."""
MIN_SWING_NOISE = 4.0
"""Swings below so many standard deviations of noise likewise."""
NOISE_LEFT, NOISE_LEFT_MOST = 0.25, 0.005
"""Excess of an extreme: standard deviations of noise, and most parts of a swing."""
STILL_REL_TOL = 1e-9
"""Change of an input relative to its size that counts as none."""
SWING_START, SWING_END = 0.01, 0.99
"""Fractions of a swing between which its time is measured."""


@dataclass(frozen=True)
class Surroundings:
    """What the rest of a spec says that the keys of an input may refer to."""

    folder: Path = Path()
    """Where its files are."""
    ambient: float = 101325.0
    """Absolute [Pa]."""
    baseline: float = 0.0
    """Gauge pressure to which an input is added [Pa]."""
    accuracy: float = 0.005
    """Accuracy of the tip, relative to the length of the actuator."""
    inlet: str = ""
    """Name of the input's inlet."""

    @classmethod
    def of(cls, context: Any, **known: Any) -> Surroundings:
        """With the folder of a validation's context."""
        return cls((context or {}).get("folder", Path()), **known)


class Input(SpecPart):
    """The input of one inlet; a kind is a file with one subclass."""

    name: ClassVar[str]
    coefficients: ClassVar[int]
    """Number of coefficients of an interval between corners."""
    gives_pressure: ClassVar[bool] = True
    """Whether its value is a pressure; otherwise it is the volume displaced by a plunger."""

    transient_time: Time | None = Field(
        None, gt=0, description="Transient time t_i, instead of the profile's own"
    )

    @classmethod
    @abstractmethod
    def expression(cls, t: Any, piece: Any, functions: Any) -> Any:
        """Value inside an interval; ``functions`` is numpy or casadi.

        Every number of the input is one of the coefficients ``piece``: equations then serve all
        inputs of a kind.
        """

    @abstractmethod
    def corners(self, duration: float) -> list[float]:
        """Times in (0, duration) at which a solver must restart, increasing."""

    @abstractmethod
    def pieces(self, edges: np.ndarray) -> np.ndarray:
        """Coefficients (n, coefficients) of the intervals of ``edges`` (n + 1,)."""

    @abstractmethod
    def initial_piece(self) -> np.ndarray:
        """Coefficients (coefficients,) just before t = 0."""

    @abstractmethod
    def values(self, t: np.ndarray) -> np.ndarray:
        """Values (n,) at times (n,); at a jump the value after it."""

    @abstractmethod
    def extremes(self, duration: float) -> tuple[float, float]:
        """Exact minimum and maximum over a run of this duration."""

    @abstractmethod
    def swing_time(self) -> float:
        """Time of the shortest monotone swing of the profile, 1 % to 99 % [s]; inf without one."""

    @classmethod
    def prepared(cls, given: Mapping[str, Any], around: Surroundings) -> Mapping[str, Any]:
        """The keys as given, with what they refer to in the rest of the spec worked in."""
        del around
        return given

    def later(self, delay: float) -> Input | None:
        """The same input, by a delay later [s]; None where no keys of its kind say that.

        What it was before t = 0 then comes first: of a periodic input an earlier period.
        """
        del delay
        return None

    def shared_by(self, count: int) -> Input | None:
        """What each of ``count`` equal actuators has of it, of which all move alike.

        All of a pressure; None where it cannot be shared out.
        """
        return self if self.gives_pressure or count == 1 else None

    def moves_within(self, duration: float) -> bool:
        """Whether its value changes in a run, or at its start."""
        low, high = self.extremes(duration)
        start = float(self.expression(0.0, self.initial_piece(), np))
        size = max(abs(low), abs(high), abs(start))
        return max(high, start) - min(low, start) > STILL_REL_TOL * size

    def swing_time_within(self, duration: float) -> float:
        """Time of the shortest swing of a run [s]; inf where nothing moves within it."""
        return self.swing_time() if self.moves_within(duration) else math.inf

    @property
    def covered(self) -> tuple[float, float] | None:
        """First and last time [s] that rows stand for; None where all times are."""
        return None

    @property
    def period(self) -> float | None:
        """Period [s] of a periodic profile."""
        return None

    def transient(self, duration: float = math.inf) -> float:
        """Transient time t_i: as given in the spec, else from the profile within a run [s]."""
        if self.transient_time is not None:
            return self.transient_time
        return self.swing_time_within(duration) if duration < math.inf else self.swing_time()


class SmoothInput(Input):
    """One expression for all times, whose numbers are the first coefficients of every interval.

    One more coefficient, if there is one, numbers the intervals: a solver restarts at each.
    """

    @abstractmethod
    def numbers(self) -> tuple[float, ...]:
        """The numbers of its expression."""

    def pieces(self, edges: np.ndarray) -> np.ndarray:
        intervals = np.arange(len(edges) - 1, dtype=float)
        numbers = np.tile(self.numbers(), (len(intervals), 1))
        return np.column_stack((numbers, intervals))[:, : self.coefficients]

    def initial_piece(self) -> np.ndarray:
        return np.append(self.numbers(), 0.0)[: self.coefficients]

    def values(self, t: np.ndarray) -> np.ndarray:
        return np.asarray(self.expression(np.asarray(t), self.numbers(), np))


class PiecewiseLinear(Input):
    """Straight lines between vertices; two vertices at one time are a jump."""

    coefficients: ClassVar[int] = 3

    @abstractmethod
    def vertices(self, duration: float) -> np.ndarray:
        """Times and values (n, 2) from 0 to the duration or the last change."""

    @abstractmethod
    def initial(self) -> float:
        """Value just before t = 0."""

    @abstractmethod
    def profile(self) -> list[tuple[float, float]]:
        """Vertices that contain every swing once."""

    @classmethod
    def expression(cls, t: Any, piece: Any, functions: Any) -> Any:
        del functions
        value, slope, reference = piece[0], piece[1], piece[2]
        return value + slope * (t - reference)

    def corners(self, duration: float) -> list[float]:
        time = self.vertices(duration)[:, 0]
        return list(distinct(time[(time > 0.0) & (time < duration)]).tolist())

    def pieces(self, edges: np.ndarray) -> np.ndarray:
        middles = (edges[:-1] + edges[1:]) / 2
        starts, values, slopes = self._lines(edges[-1])
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
        """Lowest and highest value of the vertices before the end, and of the last line up to
        it."""
        points = self.vertices(duration)
        met = points[points[:, 0] < duration, 1]
        starts, values, slopes = self._lines(duration)
        last = max(int(np.searchsorted(starts, duration)) - 1, 0)
        end = float(values[last] + slopes[last] * (duration - starts[last]))
        return float(np.min(met, initial=end)), float(np.max(met, initial=end))

    def _lines(self, duration: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Start, value there and slope of every line; the last line is level."""
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
        return self.shortest_swing(math.inf)

    def swing_time_within(self, duration: float) -> float:
        """Time of the shortest swing that begins in a run [s]; inf where nothing moves."""
        return self.shortest_swing(duration) if self.moves_within(duration) else math.inf

    def shortest_swing(self, until: float) -> float:
        """Time of the shortest swing that begins before a time [s]; inf without one."""
        return shortest_swing(self.profile(), until=until)


@singledispatch
def periods_to_cover(ratio: Any) -> int:
    """Periods that reach beyond the end of a run, which lasts ``ratio`` of them.

    Other kinds of number than `float` register what they answer.
    """
    whole: int = math.floor(ratio)
    return whole + 1


def points_of(vertices: np.ndarray) -> list[tuple[float, float]]:
    """Rows (n, 2) as pairs."""
    return [(float(t), float(p)) for t, p in vertices]


def shortest_swing(
    profile: list[tuple[float, float]], noise: float = 0.0, until: float = math.inf
) -> float:
    """Time of the shortest monotone swing between vertices, 1 % to 99 % of it [s].

    Reversals of less than `MIN_SWING_REL` of the range, or `MIN_SWING_NOISE` times the standard
    deviation of noise that was in the profile, are none. A hold separates two swings, unless they
    are as small. Swings that begin at ``until`` or later do not count.
    """
    values = [p for _, p in profile]
    smallest = max(MIN_SWING_REL * (max(values) - min(values)), MIN_SWING_NOISE * noise)
    times = [
        _swing_time(part, smallest, noise)
        for swing in _between_turns(profile, smallest)
        for part in _between_holds(swing, smallest)
        if part[0][0] < until
    ]
    return min(times, default=math.inf)


Profile = list[tuple[float, float]]


def _between_turns(profile: Profile, smallest: float) -> list[Profile]:
    """Parts between turning points that differ by more than ``smallest``."""
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
    """The parts of a swing between holds; the whole swing if all of them are small."""
    holds = [k for k in range(1, len(swing)) if swing[k][1] == swing[k - 1][1]]
    starts, ends = [0, *holds], [*(k - 1 for k in holds), len(swing) - 1]
    parts = [swing[a : b + 1] for a, b in zip(starts, ends, strict=True)]
    large = [part for part in parts if abs(part[-1][1] - part[0][1]) > smallest]
    return large or [swing]


def _swing_time(swing: Profile, smallest: float, noise: float) -> float:
    """From the last time at 1 % to the first at 99 %; inf for a small swing, 0 at a jump.

    What is left of noise makes the extremes of a hold a little larger than the hold itself.
    """
    height = swing[-1][1] - swing[0][1]
    if abs(height) <= smallest:
        return math.inf
    jumps = (b[0] == a[0] and abs(b[1] - a[1]) > smallest for a, b in itertools.pairwise(swing))
    if any(jumps):
        return 0.0
    part = np.maximum.accumulate([(p - swing[0][1]) / height for _, p in swing])
    times = [t for t, _ in swing]
    excess = min(NOISE_LEFT * noise / abs(height), NOISE_LEFT_MOST)
    first, last = SWING_START + excess, SWING_END - excess
    return float(np.interp(last, part, times) - np.interp(first, part, times))
