"""Hard cases of the rod: buckling, curling, stiffness, release, resonance."""

from __future__ import annotations

import numpy as np

from tests.hard.case import Case
from tests.scenes import LEG_EI, LEG_LENGTH

L = LEG_LENGTH
CRITICAL = np.pi**2 / 4 * LEG_EI / L**2
"""Euler's load of an inextensible cantilever [N]."""
PER_PASCAL = 8 * 10.266 / 1.8e6
"""Angle of all eight sections per pressure of the left bellows above the right ones [rad/Pa]."""
ONE_PRESSURE = "effects={gravity: auto, others: off}"


def sides(left: str, right: str, count: int = 8) -> tuple[str, ...]:
    """Two inlets, one for the bellows of each side."""
    tubes = [
        f"{{from: {n}, to: {n[0].upper()}{j}, length: 40 mm, radius: 0.325 mm}}"
        for n in ("left", "right")
        for j in range(1, count + 1)
    ]
    return (
        f"network={{layout: custom, tubes: [{', '.join(tubes)}]}}",
        f"inputs={{left: {left}, right: {right}}}",
        "input=null",
    )


def ramp(start: float, end: float, time: float) -> str:
    """A trapezoid whose first rise is all that is seen."""
    return f"{{kind: trapezoid, low: {start!r}, high: {end!r}, rise: {time!r} s, hold: 1000 s, fall: 1 s, rest: 1 s}}"


def antisymmetric(first: float, last: float, time: float) -> tuple[str, ...]:
    """Intrinsic curvature times length from one value to another, without extension."""
    a, b = first / PER_PASCAL / 2, last / PER_PASCAL / 2
    left = ramp(a, b, time) if a < b else _falling(a, b, time)
    right = ramp(-a, -b, time) if -a < -b else _falling(-a, -b, time)
    return sides(left, right)


def _falling(start: float, end: float, time: float) -> str:
    return f"{{kind: trapezoid, high: {start!r}, low: {end!r}, rise: 1000 s, hold: 0 s, fall: {time!r} s, rest: 1000 s}}"


CASES: tuple[Case, ...] = ()
