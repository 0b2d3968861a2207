"""Means over a motion, by which a linear network stands for one that is not linear."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class Means:
    """What stands for one network's motion: a first guess for others."""

    compliance: np.ndarray
    """Of every bellow (B,) [m3/Pa]."""
    multiplier: np.ndarray
    """Loss of every tube over that of slow laminar flow (Q,) [1]."""
    thinness: np.ndarray
    """Mean density of the fluid in all tubes over that in each (Q,) [1]."""
