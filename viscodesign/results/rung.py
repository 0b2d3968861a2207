"""One attempt to get past a place where a run had come to a stop."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Rung:
    """What was tried where, why, and whether it helped."""

    time_s: float
    """Where the run had stopped [s]."""
    tried: str
    """What was changed."""
    solved: bool
    reason: str
    """What had failed before."""
