"""Random numbers over powers of ten, with rare outliers."""

from __future__ import annotations

from random import Random

RARE = 0.015
"""Probability of an outlier."""
FAR = 5.0
"""Powers of ten by which an outlier may exceed the usual range."""


def rng_of(seed: object, number: int) -> Random:
    """The random generator of one scene, reproducible by seed and number."""
    return Random(f"{seed}:{number}")


def around(rng: Random, value: float, low: float, high: float) -> float:
    """``value`` times a power of ten from ``low`` to ``high``, to six digits."""
    return float(f"{value * 10 ** rng.uniform(low, high):.6g}")


def size(rng: Random, value: float, low: float, high: float) -> float:
    """Like `around`, with rare outliers."""
    if rng.random() < RARE:
        return around(rng, value, low - FAR, high + FAR)
    return around(rng, value, low, high)


def share(rng: Random, low: float, high: float) -> float:
    """From ``low`` to ``high``; rarely exactly one of them."""
    if rng.random() < 2 * RARE:
        return rng.choice([low, high])
    return float(f"{rng.uniform(low, high):.6g}")


def chance_of(rng: Random, chance: float) -> bool:
    """True with this probability."""
    return rng.random() < chance
