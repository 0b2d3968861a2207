"""What pressure answers to where the plungers are."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

import numpy as np

from viscodesign.pump.drive import Drive

AMBIENT = 101_325.0
"""Absolute [Pa]: the standard atmosphere."""


class Plant(ABC):
    """P plungers and what they press into."""

    @abstractmethod
    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        """Gauge pressures (P,) [Pa] after a while with the plungers moving to these places.

        ``positions`` (P,): plungers pushed in from home [m]. ``seconds`` may be 0, which asks
        for the pressures at the start.
        """


class ClosedGas(Plant):
    """Each barrel and its dead volume closed, filled with gas that keeps its temperature.

    p V = const (Boyle), at ambient pressure with the plunger at home. Where the barrel is
    pressed empty the dead volume alone is left, and where that is nothing, a little.
    """

    def __init__(self, drives: Sequence[Drive], ambient: float = AMBIENT) -> None:
        self.ambient = ambient
        self._areas = np.array([drive.area for drive in drives])
        filled = np.array([drive.filled_at_home for drive in drives])
        dead = np.array([drive.pump.dead_volume for drive in drives])
        self._volumes = self._areas * filled + dead
        self._least = np.maximum(dead, 1e-3 * self._volumes)

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        left = np.maximum(self._volumes - self._areas * positions, self._least)
        pressures: np.ndarray = self.ambient * (self._volumes / left - 1.0)
        return pressures
