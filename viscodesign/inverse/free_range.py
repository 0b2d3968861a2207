"""A free key of a spec and its bounds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from viscodesign.checks.written_numbers import written
from viscodesign.errors import Fault, SpecError, described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.studies.key_values import read_values

FAR = 100.0
"""Ratio to the spec's own number from which one without a unit is that of another unit."""
PREFIXES = {"m": 1e-3, "k": 1e3, "u": 1e-6, "M": 1e6}
"""Of units that are left out, the likeliest first."""
PREFIXED_UNITS = ("m", "Pa", "s", "Pa*s", "Pa/s")


@dataclass(frozen=True)
class FreeRange:
    """A key of the spec, and between which bounds its numbers are sought [SI]."""

    key: str
    low: float
    high: float


def bounds(key: str, unit: str, given: Any, own: float = 0.0) -> tuple[float, float]:
    """Two bounds [unit], the lower one first. Raises `SpecError`.

    ``own``: the size that the spec has [unit], or 0. A bare number is SI; one that is as far from
    it as the next prefix was hardly meant so.
    """
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
    if found.is_bare and _is_far(low, high, abs(own)):
        message = (
            f"{low:g} and {high:g} have no unit and are {written(low, unit)} and "
            f"{written(high, unit)}, far from the spec's {written(abs(own), unit)}; write each "
            f"with its unit, such as {_example(low, high, abs(own), unit)}"
        )
        raise SpecError([Fault(message, key)])
    return low, high


def _is_far(low: float, high: float, own: float) -> bool:
    """Whether all sizes between two bounds are another order than the spec's own."""
    largest = max(abs(low), abs(high))
    least = 0.0 if low <= 0.0 <= high else min(abs(low), abs(high))
    return own > 0.0 and (largest * FAR < own or least > own * FAR)


def _example(low: float, high: float, own: float, unit: str) -> str:
    """The bounds with the prefix that was probably meant; else as they were read."""
    for prefix, factor in PREFIXES.items() if unit in PREFIXED_UNITS else ():
        if not _is_far(low * factor, high * factor, own):
            return f"[{low:g} {prefix}{unit}, {high:g} {prefix}{unit}]"
    return f"[{low:g} {unit}, {high:g} {unit}]"
