"""Single numbers of a spec whose powers and quotients double precision could not carry."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from pydantic.fields import FieldInfo

from viscodesign.errors import Fault
from viscodesign.scene.spec_part import SpecPart

LARGEST_SI = 1e50
"""Largest number in SI units, and largest inverse of one that must be positive: the fifth power is
within double precision. What may be zero may be as small as it likes."""


def extreme_numbers(part: SpecPart, path: str = "") -> Iterator[Fault]:
    """A fault for every number of a part of a spec that is too large, or too close to zero."""
    for name, value, field in part.keyed_fields():
        yield from _below(value, f"{path}{name}", 1 / LARGEST_SI if _is_positive(field) else 0.0)


def _is_positive(field: FieldInfo) -> bool:
    return any(getattr(bound, "gt", None) == 0 for bound in field.metadata)


def _below(value: Any, key: str, least: float) -> Iterator[Fault]:
    if isinstance(value, SpecPart):
        yield from extreme_numbers(value, f"{key}.")
    elif isinstance(value, Mapping):
        for name, own in value.items():
            yield from _below(own, f"{key}.{name}", least)
    elif isinstance(value, tuple) and value and isinstance(value[0], SpecPart):
        for k, own in enumerate(value):
            yield from _below(own, f"{key}[{k}]", least)
    elif isinstance(value, (float, tuple)):
        yield from _beyond(value, key, least)


def _beyond(value: Any, key: str, least: float) -> Iterator[Fault]:
    """A fault for the first number of one or of rows that is out of range."""
    try:
        numbers = np.asarray(value, float).ravel()
    except (TypeError, ValueError):  # words, or rows of several lengths
        return
    sizes = np.abs(numbers)
    outside = numbers[(sizes > LARGEST_SI) | (sizes < least)]
    if outside.size:
        found = float(outside[0])
        bound = f"at most {LARGEST_SI:g}" if abs(found) > LARGEST_SI else f"at least {least:g}"
        yield Fault(
            f"is {found:.3g} in SI units, outside the range of double precision for all that is "
            f"computed from it; its magnitude must be {bound}. Check its unit and its exponent",
            key,
        )
