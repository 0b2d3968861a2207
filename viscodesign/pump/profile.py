"""What a pump is to play: targets of its axes against time."""

from __future__ import annotations

from typing import Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass

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

    @property
    def duration(self) -> float:
        """[s]"""
        return float(self.time[-1])

    def at(self, moment: float) -> np.ndarray:
        """Targets (P,) [steps] at a moment; held before the start and after the end."""
        return np.array([np.interp(moment, self.time, column) for column in self.steps.T])
