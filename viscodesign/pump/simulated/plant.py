"""What a simulated pump presses into."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

AMBIENT = 101_325.0  # absolute [Pa]: the standard atmosphere


class Plant(ABC):
    """What P axes press into."""

    @abstractmethod
    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        """Gauge pressures (P,) [Pa] after a while with the axes moving to these places.

        ``positions`` (P,) in SI: a plunger's pushed in from home [m], or what a regulator sets
        [Pa gauge]; ``seconds`` 0 asks for the start.
        """


class NoPressure(Plant):
    """Plungers that press into nothing: a closed barrel would load them unlike the actuator."""

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        return np.asarray(np.zeros_like(positions))
