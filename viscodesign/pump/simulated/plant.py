"""What a simulated pump presses into."""

from __future__ import annotations

import numpy as np

AMBIENT = 101_325.0  # absolute [Pa]: the standard atmosphere


class Plant:
    """What P axes press into; by itself nothing, which loads no plunger."""

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        """Gauge pressures (P,) [Pa] after a while with the axes moving to these places.

        ``positions`` (P,) in SI: a plunger's pushed in from home [m], or what a regulator sets
        [Pa gauge]; ``seconds`` 0 asks for the start.
        """
        return np.asarray(np.zeros_like(positions))
