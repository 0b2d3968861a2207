"""The smallest change of a number that satisfies a limit: found by bisection, then confirmed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

Passes = Callable[[float], bool]


@dataclass(frozen=True)
class SearchNumbers:
    """How long and how finely a factor is sought."""

    halvings: int = 40
    retries: int = 10
    first_step: float = 0.97
    """What a factor that failed is changed by, first; each next time by twice as much."""
    step_growth: float = 2.0
    refinements: int = 5
    """Halvings between one that failed and one that held."""
    digits: int = 3


SEARCH = SearchNumbers()


def nearest(passes: Passes, near: float, far: float) -> float | None:
    """The value nearest to ``near`` that passes, between the two; None where ``far`` does not."""
    if not passes(far):
        return None
    low, high = math.log(near), math.log(far)
    for _ in range(SEARCH.halvings):
        middle = (low + high) / 2
        low, high = (low, middle) if passes(math.exp(middle)) else (middle, high)
    return math.exp(high)


def confirmed(holds: Passes, guess: float, far: float) -> float | None:
    """The rounded value nearest to a guess, towards ``far``, that holds; None within few tries."""
    step = SEARCH.first_step if far < guess else 1 / SEARCH.first_step
    value, failed = guess, None
    for _ in range(SEARCH.retries):
        if holds(value):
            return value if failed is None else _refined(holds, failed, value, far)
        failed, value, step = value, rounded(value * step, far), step**SEARCH.step_growth
    return None


def _refined(holds: Passes, failed: float, value: float, far: float) -> float:
    for _ in range(SEARCH.refinements):
        middle = rounded(math.sqrt(failed * value), far)
        if middle in (failed, value):
            break
        failed, value = (failed, middle) if holds(middle) else (middle, value)
    return value


def rounded(value: float, far: float) -> float:
    """Few digits, rounded towards ``far``; what has no more already stays."""
    unit = 10.0 ** (math.floor(math.log10(value)) - SEARCH.digits + 1)
    steps = value / unit
    whole = round(steps)
    turned = math.floor(steps) if far < value else math.ceil(steps)
    return float(f"{(whole if abs(steps - whole) < 1e-6 else turned) * unit:.12g}")
