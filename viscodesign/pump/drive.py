"""Rack, pinion and barrel: how servo counts, plunger and pushed volume belong together."""

from __future__ import annotations

import math
from dataclasses import dataclass

from viscodesign.scene.pump import PumpSpec

COUNTS_PER_TURN = 1024 * 360.0 / 300.0
"""The servo's 1024 counts span 300 degrees (e-manual of AX-12A and AX-18A, Goal Position)."""


@dataclass(frozen=True)
class Drive:
    """One plunger; positions are pushed in from home, positive towards the outlet."""

    pump: PumpSpec

    @property
    def area(self) -> float:
        """Cross section of the barrel [m2]."""
        return math.pi * self.pump.syringe_diameter**2 / 4

    @property
    def advance_per_count(self) -> float:
        """Travel of the rack for one count [m]; positive whichever way counts push."""
        return math.pi * self.pump.pinion_diameter / COUNTS_PER_TURN

    @property
    def volume_per_count(self) -> float:
        """[m3]"""
        return self.area * self.advance_per_count

    @property
    def _sign(self) -> int:
        return 1 if self.pump.push == "up" else -1

    def position(self, count: float) -> float:
        """Plunger pushed in from home [m] at a count."""
        return self._sign * (count - self.pump.home) * self.advance_per_count

    def count(self, position: float) -> float:
        """Servo count, not rounded, with the plunger pushed in this far from home [m]."""
        return self.pump.home + self._sign * position / self.advance_per_count

    @property
    def range(self) -> tuple[float, float]:
        """Plunger positions at the ends of travel, drawn out first [m from home]."""
        low, high = sorted(self.position(count) for count in self.pump.travel)
        return low, high

    @property
    def filled_at_home(self) -> float:
        """Length of barrel in front of the plunger at home [m]."""
        stated = self.pump.filled_length
        return self.pump.syringe_stroke + self.range[0] if stated is None else stated
