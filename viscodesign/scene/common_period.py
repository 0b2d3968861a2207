"""The period that all inputs of a scene have in common."""

from __future__ import annotations

import math
from collections.abc import Iterable

from viscodesign.scene.inputs.base import Input

PERIOD_REL_TOL = 1e-9
"""Difference of two periods that counts as none."""
MOST_PERIODS = 24
"""Periods of the slowest input within which all others have to meet."""


def common_period(inputs: Iterable[Input]) -> float | None:
    """The shortest time [s] after which all inputs repeat together; None where there is none.

    An input that never changes repeats with every period.
    """
    moving = [found for found in inputs if math.isfinite(found.swing_time())]
    periods = [found.period for found in moving]
    known = [period for period in periods if period is not None]
    if not known or len(known) < len(periods):
        return None
    longest = max(known)
    for count in range(1, MOST_PERIODS + 1):
        if all(_is_whole(count * longest / period) for period in known):
            return count * longest
    return None


def _is_whole(turns: float) -> bool:
    return abs(turns - round(turns)) <= PERIOD_REL_TOL * turns
