"""Arrays as text: the bytes of their numbers, little-endian, in base64."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

STEPS = 65535
"""Steps of a coordinate in 16 bit: 2 um of a leg of 0.1 m, less than a pixel."""


def packed(values: np.ndarray, kind: str = "f4") -> dict[str, Any]:
    """An array with its type (`f8`, `f4` or `u2`) and shape."""
    raw = np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()
    return {
        "type": kind,
        "shape": list(values.shape),
        "bytes": base64.b64encode(raw).decode("ascii"),
    }


def packed_coordinates(values: np.ndarray) -> dict[str, Any]:
    """Coordinates to a 65535th of their range; those that are not finite as the lowest."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    step = (high - low) / STEPS or 1.0
    counts = np.rint(np.nan_to_num((values - low) / step, posinf=0.0, neginf=0.0))
    return {**packed(counts, "u2"), "low": low, "step": step}
