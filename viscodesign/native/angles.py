"""Sines and cosines of many angles at once."""

from __future__ import annotations

import numpy as np

from viscodesign.native.loops import native_loops
from viscodesign.native.machine import this_machine
from viscodesign.native.unavailable import NativeUnavailable

MAX_ANGLE = 1e6
"""Angle up to which the loop keeps all digits [rad]."""


def sines_and_cosines(angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of angles [rad] of any shape; natively in a tenth of the time that NumPy takes."""
    if not np.max(np.abs(angle), initial=0.0) <= MAX_ANGLE:
        return np.sin(angle), np.cos(angle)
    try:
        this_machine()  # code that was made before may have been switched off
        loops = native_loops()
    except NativeUnavailable:
        return np.sin(angle), np.cos(angle)
    sine, cosine = np.empty(angle.shape), np.empty(angle.shape)
    flat = (values.reshape(-1) for values in (np.ascontiguousarray(angle, float), sine, cosine))
    loops("sines_and_cosines", angle.size, *flat)
    return sine, cosine
