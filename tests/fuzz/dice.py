"""Random numbers over powers of ten, the rare ones far out."""

from __future__ import annotations

from random import Random

RARE = 0.015
"""Chance that a size is drawn far from the usual ones."""
FAR = 5.0
"""Powers of ten that such a size may lie beyond its usual range."""


def dice_of(seed: object, number: int) -> Random:
    """What draws one scene: the same whenever it is asked for by seed and number."""
    return Random(f"{seed}:{number}")


def around(dice: Random, value: float, low: float, high: float) -> float:
    """``value`` times ten to a power from ``low`` to ``high``, to six digits."""
    return float(f"{value * 10 ** dice.uniform(low, high):.6g}")


def size(dice: Random, value: float, low: float, high: float) -> float:
    """The same; rarely orders of magnitude away."""
    if dice.random() < RARE:
        return around(dice, value, low - FAR, high + FAR)
    return around(dice, value, low, high)


def share(dice: Random, low: float, high: float) -> float:
    """From ``low`` to ``high``; rarely one of these ends itself."""
    if dice.random() < 2 * RARE:
        return dice.choice([low, high])
    return float(f"{dice.uniform(low, high):.6g}")


def happens(dice: Random, chance: float) -> bool:
    """Whether something of this probability does."""
    return dice.random() < chance
