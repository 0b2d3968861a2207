"""Units that cancel each other, as in '1.8 MPa MPa/Pa': a slip, although it has a value."""

from __future__ import annotations

import itertools

from viscodesign.values.common_units import dimensions, powers_of_names
from viscodesign.values.grammar import OFFSET_UNITS

RATIO = 2
"""Names in a plain ratio, such as mm/m, which a fraction may have."""


def repeated_units(spelled: str, names: tuple[str, ...]) -> tuple[str, ...]:
    """Names in a canonical product that cancel, wholly or in part; empty where it is in order.

    One quantity may be above and below the line, as the lengths are in mm^2/(N*m), but only where
    it is a base one; none may cancel itself.
    """
    names = tuple(OFFSET_UNITS.get(name, name) for name in names)  # as they are in the product
    powers = powers_of_names(spelled)
    if not powers and len(names) != RATIO:
        return ()
    is_ratio = len(names) == RATIO and sum(powers.values()) == 0
    for name in dict.fromkeys(names):
        gone = name not in powers and not is_ratio
        if gone or names.count(name) > RATIO:
            return (name,)
    for one, other in itertools.combinations(powers, 2):
        kind = dimensions(one)
        if not kind or kind != dimensions(other) or powers[one] * powers[other] > 0 or is_ratio:
            continue
        if len(kind) > 1 or powers[one] + powers[other] == 0 or len(names) > len(powers):
            return one, other
    return ()
