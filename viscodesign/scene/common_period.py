"""The period that all inputs of a scene have in common."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from viscodesign.scene.inputs.base import Input

SAME_PERIOD_REL_TOL = 1e-9
"""Difference of two periods that counts as none."""
MAX_COMMON_PERIODS = 24
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
    for count in range(1, MAX_COMMON_PERIODS + 1):
        if all(_is_whole(count * longest / period) for period in known):
            return count * longest
    return None


def no_period(inputs: Mapping[str, Input]) -> str:
    """Why inputs have no period in common, and what to do; empty where they have one."""
    if common_period(inputs.values()) is not None:
        return ""
    moving = {name: found for name, found in inputs.items() if math.isfinite(found.swing_time())}
    if not moving:
        return "no input changes. Use run.start: equilibrium"
    single = [name for name, found in moving.items() if found.period is None]
    if single:
        kinds = " and ".join(f"'{name}' ({moving[name].name})" for name in single)
        verb = "does" if len(single) == 1 else "do"
        return (
            f"{kinds} {verb} not. Use a periodic kind such as sine, square or trapezoid, or "
            "run.start: equilibrium"
        )
    periods = ", ".join(f"'{name}' {found.period:.6g} s" for name, found in moving.items())
    return (
        f"the periods ({periods}) do not meet within {MAX_COMMON_PERIODS} of the longest. Make "
        "each a simple fraction of the longest, or use run.start: equilibrium"
    )


def _is_whole(turns: float) -> bool:
    return abs(turns - round(turns)) <= SAME_PERIOD_REL_TOL * turns
