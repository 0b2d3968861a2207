"""Places that no tip of an actuator can be at: millimetres that were taken for metres."""

from __future__ import annotations

import numpy as np

MAX_LENGTHS = 10.0
"""Distance from the clamp, in lengths of the actuator, that none of them reaches: elastomers of
bellows stretch by some ten percent."""


def far_words(points: np.ndarray, length: float) -> str:
    """What is wrong with places x, z (n, 2) [m] that are far beyond an actuator's length [m].

    NaN where a place is not known. Empty where all may be right.
    """
    far = np.nan_to_num(np.linalg.norm(points, axis=1)).max(initial=0.0)
    if far <= MAX_LENGTHS * length:
        return ""
    return (
        f"{1e3 * far:.4g} mm from the clamp is {far / length:.3g} times the actuator's length of "
        f"{1e3 * length:.4g} mm; are these metres?"
    )
