"""Numbers with their units, as warnings show them."""

from __future__ import annotations

import math

_PREFIXES = {-9: "n", -6: "u", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
_PREFIXED_UNITS = ("m", "Pa", "s")
_FINEST = {"m": -6, "Pa": -3, "s": -6}
_COARSEST = {"m": 6, "Pa": 9, "s": 0}


def written(value: float, unit: str) -> str:
    """A number in the prefix that leaves one to three digits before the point."""
    if unit not in _PREFIXED_UNITS or not value:
        return f"{value:.4g} {unit}".rstrip()
    exponent = 3 * math.floor(math.log10(abs(value) * (1 + 1e-12)) / 3)
    exponent = min(max(exponent, _FINEST[unit]), _COARSEST[unit])
    return f"{value / 10.0**exponent:.4g} {_PREFIXES[exponent]}{unit}"
