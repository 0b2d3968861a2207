"""What may stop a run that an effect would carry on."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum


class Obstacle(Enum):
    """A failure that effects know a remedy for."""

    NO_EQUILIBRIUM = "the rod has no equilibrium to start from under its loads"
    LIMIT_POINT = "a static rod's branch of equilibria ends"
    EMPTY_BELLOW = "the law of a bellow leads to volumes that no fluid can fill"
    OVERDRAWN = "a syringe draws more than the bellows can give"


FLOOR_REL_TOL = 0.02
"""Part of its minimum volume by which a bellow may fall below it: loads take volume too."""

Remedies = Mapping[Obstacle, tuple[str, ...]]
"""What the effects of a scene offer against each obstacle: clauses that begin with a verb."""


def advice(remedies: Remedies, obstacle: Obstacle, *measures: str) -> str:
    """A sentence of measures and of what effects offer, of which there is one at least."""
    *others, last = *measures, *remedies.get(obstacle, ())
    return f"{', '.join(others)}, or {last}." if others else f"{last}."
