"""What a pump is to play: positions of its servos against time."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class Profile:
    """T instants, P pumps (one for each inlet); piecewise linear between instants."""

    inlets: tuple[str, ...]
    servos: tuple[int, ...]  # id of each inlet's servo
    time: np.ndarray  # (T,) from 0, ascending [s]
    counts: np.ndarray  # (T, P) servo positions, not rounded
    pressure: np.ndarray  # (T, P) gauge pressure that the model expects at each inlet [Pa]

    @property
    def duration(self) -> float:
        """[s]"""
        return float(self.time[-1])

    def at(self, moment: float) -> np.ndarray:
        """Counts (P,) at a moment; held before the start and after the end."""
        return np.array([np.interp(moment, self.time, column) for column in self.counts.T])
