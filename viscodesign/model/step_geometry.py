"""How an iteration moves from one vector of unknowns to the next: along straight lines."""

from __future__ import annotations

import numpy as np


class StepGeometry:
    """Straight steps. A discretisation of the rod may know better ones."""

    def step(self, y: np.ndarray, step: np.ndarray) -> np.ndarray:
        """Unknowns (n,) after a step (n,) from ``y`` (n,)."""
        return np.asarray(y + step)

    def extrapolate(self, before: np.ndarray, now: np.ndarray, ratio: float) -> np.ndarray:
        """Unknowns (n,) expected after ``before`` and ``now``, ``ratio`` of their distance on."""
        return np.asarray(now + ratio * (now - before))


STRAIGHT = StepGeometry()
