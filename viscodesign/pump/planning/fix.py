"""Numbers of a scene or its pump that may be changed to make a limit pass."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class Fix:
    """A number that is changed, and as far as to where."""

    key: str  # of a `Variation`
    far: float
    words: str
    unit: str = ""  # in which a spec states it
    si: float = 1.0  # of that unit
    whole: Callable[[Any], range] | None = None
    """Values of a key that counts, of a pump's section; each is tried, the nearest first."""
    cures: tuple[str, ...] = ()
    """Limits that have to pass together where it counts."""


LOWER = Fix("pressure", 0.005, "every pressure of the input times {:.3g}")
HIGHER = replace(LOWER, far=100.0)
SLOWER = Fix("time", 1000.0, "everything slower by a factor of {:.3g}")
RAMPS = Fix("ramp", 1000.0, "every jump of the pressure as a ramp of {:.3g} s")
CAP = Fix("pump.max_pressure", 1e7, "a cap of {:.4g} kPa gauge", "kPa gauge", 1e3)
Steps = Sequence[tuple[Fix, Sequence[str]]]
"""Changes one upon the other, each with the limits that it is to satisfy."""
