"""A free key of a spec and its bounds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from viscodesign.errors import Fault, SpecError, described
from viscodesign.exploration.key_values import read_values
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class FreeRange:
    """A key of the spec, and between which bounds its numbers are sought [SI]."""

    key: str
    low: float
    high: float


def bounds(key: str, unit: str, given: Any) -> tuple[float, float]:
    """Two bounds [unit], the lower one first. Raises `SpecError`."""
    found = read_values(key, unit, given)
    pair: Sequence[float] = (found.low, found.high) if found.is_range else found.listed
    if len(pair) != 2:
        message = f"expected two bounds, [low, high]; got {described(given)}"
        raise SpecError([Fault(message, key)])
    low, high = map(float, pair)
    if not low < high:
        wrong = "reversed" if low > high else "equal"
        hint = "write the smaller one first" if low > high else "leave the key out to keep it fixed"
        raise SpecError([Fault(f"the bounds {given} are {wrong}; {hint}", key)])
    return low, high
