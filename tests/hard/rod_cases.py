"""Hard cases of the rod: buckling, curling, stiffness, release, resonance."""

from __future__ import annotations

from tests.hard.case import Case

CASES: tuple[Case, ...] = ()
