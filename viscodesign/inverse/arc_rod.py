"""The tip of a rod of arcs, one a section, as a function of bellows' pressures alone."""

from __future__ import annotations

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers


@dataclass(frozen=True, eq=False)
class ArcRod:
    """The tip of a row of arcs as a function of bellows' pressures."""

    section: float
    """Length of a section [m]."""
    turn: Numbers
    """Angle of a section per pressure of its left bellow, one or (B,) [rad/Pa]."""
    stretch: Numbers
    """Stretch of a section per pressure of a bellow, likewise [1/Pa]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> ArcRod:
        """That of a scene's actuator."""
        law, section = quantities.bellows, quantities.body.section_length
        return cls(section, law.curvature_per_pressure * section, law.stretch_per_pressure)

    def tip(self, pressure: np.ndarray) -> np.ndarray:
        """(T, 2) x, z [m] for pressures (T, B), R first."""
        middle, length, chord, _ = self._arcs(pressure)
        own = length * chord
        return np.stack([(own * np.sin(middle)).sum(1), (own * np.cos(middle)).sum(1)], axis=1)

    def longest(self, pressure: float, bellows: int) -> float:
        """Length of the rod with one pressure in all of so many bellows [m]."""
        stretched = float(np.sum(np.broadcast_to(self.stretch, bellows)))
        return self.section * (bellows // 2 + stretched * pressure)

    def slopes(self, pressure: np.ndarray) -> np.ndarray:
        """(T, 2, B) derivatives of the tip by the pressures."""
        middle, length, chord, slope = self._arcs(pressure)
        along = np.stack([np.sin(middle), np.cos(middle)], axis=1)
        across = np.stack([np.cos(middle), -np.sin(middle)], axis=1)
        arms = (length * chord)[:, None] * across
        behind = np.cumsum(arms[:, :, ::-1], axis=2)[:, :, ::-1] - arms
        by_turn = behind + arms / 2 + (length * slope)[:, None] * along
        by_stretch = self.section * chord[:, None] * along
        turned = self.turn * np.concatenate([-by_turn, by_turn], axis=2)
        return turned + self.stretch * np.concatenate([by_stretch, by_stretch], axis=2)

    def _arcs(self, pressure: np.ndarray) -> tuple[np.ndarray, ...]:
        """(T, S): direction of every chord, length of its arc, chord over arc, and its slope."""
        right, left = np.split(self.turn * pressure, 2, axis=1)
        turn = left - right
        drawn = np.sum(np.split(self.stretch * pressure, 2, axis=1), axis=0)
        middle = np.cumsum(turn, axis=1) - turn / 2
        half = turn / 2
        small = np.abs(half) < 1e-4
        safe = np.where(small, 1.0, half)
        chord = np.where(small, 1 - half**2 / 6, np.sin(safe) / safe)
        slope = np.where(small, -half / 3, (np.cos(safe) - np.sin(safe) / safe) / safe) / 2
        return middle, self.section * (1 + drawn), chord, slope
