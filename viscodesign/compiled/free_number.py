"""One number of a scene that may change, and the range in which it may."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from viscodesign.errors import Fault
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import KeyPath


@dataclass(frozen=True)
class Bounds:
    """The range of a field in the spec's model."""

    low: float = -math.inf
    high: float = math.inf
    excludes_low: bool = False
    excludes_high: bool = False

    @classmethod
    def of(cls, notes: Iterable[Any]) -> Bounds:
        """From a field's annotations."""
        found: dict[str, Any] = {}
        for note in notes:
            for name, end in (("gt", "low"), ("ge", "low"), ("lt", "high"), ("le", "high")):
                limit = getattr(note, name, None)
                if limit is not None:
                    found |= {end: float(limit), f"excludes_{end}": name in ("gt", "lt")}
        return cls(**found)

    def contain(self, value: float) -> bool:
        """Whether a value is allowed."""
        above = value > self.low if self.excludes_low else value >= self.low
        below = value < self.high if self.excludes_high else value <= self.high
        return above and below

    def __str__(self) -> str:
        low = f"{'above' if self.excludes_low else 'at least'} {self.low:g}"
        high = f"{'below' if self.excludes_high else 'at most'} {self.high:g}"
        ends = (low, self.low), (high, self.high)
        return " and ".join(text for text, limit in ends if math.isfinite(limit))


ABOVE_ZERO = Bounds(low=0.0, excludes_low=True)


@dataclass(frozen=True)
class FreeNumber:
    """One number of a scene that may change."""

    name: str
    """Its key."""
    path: KeyPath
    """Where it stands in the scene, by keys of the spec."""
    value: float
    """In the scene [SI]."""
    unit: str
    bounds: Bounds

    def fault(self, value: float) -> Fault | None:
        """What is wrong with a value."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        if not math.isfinite(value):
            return Fault(f"must be a finite number; got {value}", self.name)
        if not self.bounds.contain(value):
            return Fault(f"must be {self.bounds}{unit}; got {value:g}{unit}", self.name)
        return None
