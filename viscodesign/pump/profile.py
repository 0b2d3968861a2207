"""What a pump is to play: targets of its axes against time."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property

AROUND = 0.1  # An axis may be this much earlier or later than its path [s]

Playback = Literal["none", "once", "loop"]
"""What a board does by itself with a profile once it has it."""


@dataclass(frozen=True)
class Profile:
    """T instants, P pumps (one for each inlet); piecewise linear between instants."""

    inlets: tuple[str, ...]
    axes: tuple[int, ...]  # id of each inlet's axis
    time: np.ndarray  # (T,) from 0, ascending [s]
    steps: np.ndarray  # (T, P) targets of the axes, not rounded [steps]
    pressure: np.ndarray  # (T, P) gauge pressure that the model expects at each inlet [Pa]
    begins: float = 0.0
    """Before this the axes are on their way, and no pressure is expected [s]."""

    @property
    def duration(self) -> float:
        """[s]"""
        return float(self.time[-1])

    def at(self, moment: float) -> np.ndarray:
        """Targets (P,) [steps] at a moment; held before the start and after the end."""
        return np.array([np.interp(moment, self.time, column) for column in self.steps.T])

    def expected_pressure(self, moment: float) -> tuple[float | None, ...]:
        """(P,) gauge pressure that the model expects [Pa]; None on the way to the profile."""
        if moment < self.begins:
            return (None,) * len(self.inlets)
        return tuple(float(np.interp(moment, self.time, p)) for p in self.pressure.T)

    def paces(self, moment: float) -> dict[int, float]:
        """By axis, the highest speed about a moment [steps/s]."""
        first = max(int(np.searchsorted(self.time, moment - AROUND, "right")) - 1, 0)
        last = int(np.searchsorted(self.time, moment + AROUND, "left"))
        highest = self._speeds[first:last].max(axis=0, initial=0.0)
        return dict(zip(self.axes, highest.tolist(), strict=True))

    @cached_property
    def _speeds(self) -> np.ndarray:
        """(T - 1, P) between two instants each [steps/s]."""
        rise: np.ndarray = np.abs(np.diff(self.steps, axis=0))
        return rise / np.diff(self.time)[:, None]

    @cached_property
    def top_speed(self) -> float:
        """Speed of its steepest part [steps/s]."""
        return float(self._speeds.max(initial=0.0))

    def reach(self, seconds: float) -> int:
        """Largest step in a time, rounded up and one more for rounding [steps]."""
        return math.ceil(self.top_speed * seconds) + 1
