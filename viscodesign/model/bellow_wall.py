"""Laws of a bellow's wall: volume and strains of its section as functions of its pressure.

A law takes the pressures of all bellows (B,); its numbers are one for all of them, or one of each
(B,). The strains of a section's two bellows add up: curvature
of the left minus that of the right, stretch of both.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics import bellow
from viscodesign.physics.curves import PiecewiseCubic

SX = ca.SX


class Wall(ABC):
    """Volume, strains and energy of one bellow as functions of its gauge pressure.

    For a `SnappingWall` they are functions of its swelling.
    """

    @abstractmethod
    def volume(self, pressure: SX) -> SX:
        """Volume [m3]."""

    @abstractmethod
    def curvature(self, pressure: SX) -> SX:
        """Contribution of a left bellow to its section's intrinsic curvature [1/m]."""

    @abstractmethod
    def stretch(self, pressure: SX) -> SX:
        """Contribution of a bellow to its section's intrinsic stretch [1]."""

    @abstractmethod
    def energy(self, pressure: SX) -> SX:
        """Integral of pressure over volume from zero gauge, up to a constant [J]."""


@dataclass(frozen=True)
class LinearWall(Wall):
    """The linear laws: equations (1), (9) and (10)."""

    rest_volume: SX
    compliance: SX
    curvature_per_pressure: SX
    stretch_per_pressure: SX

    def volume(self, pressure: SX) -> SX:
        return self.rest_volume + self.compliance * pressure

    def curvature(self, pressure: SX) -> SX:
        return self.curvature_per_pressure * pressure

    def stretch(self, pressure: SX) -> SX:
        return self.stretch_per_pressure * pressure

    def energy(self, pressure: SX) -> SX:
        return self.compliance * pressure**2 / 2


@dataclass(frozen=True)
class CollapsingWall(Wall):
    """The linear laws down to where the walls touch; below, pressure has ever less effect."""

    linear: LinearWall
    floor: SX
    """Gauge pressure of the minimum volume [Pa]."""
    fade: SX
    """Range above the floor in which the walls come into contact [Pa]."""
    give: SX
    """Remaining part of the compliance when they are in full contact [1]."""

    def volume(self, pressure: SX) -> SX:
        return self.linear.volume(self._effective(pressure))

    def curvature(self, pressure: SX) -> SX:
        return self.linear.curvature(self._effective(pressure))

    def stretch(self, pressure: SX) -> SX:
        return self.linear.stretch(self._effective(pressure))

    def energy(self, pressure: SX) -> SX:
        # By parts: p p_e - integral of p_e.
        effective = pressure * self._effective(pressure)
        below = bellow.effective_pressure_integral(pressure, self.floor, self.fade, ca, self.give)
        start = self.floor + self.fade
        return SX(self.linear.compliance * (effective - below - start**2 / 2))

    def _effective(self, pressure: SX) -> SX:
        return SX(bellow.effective_pressure(pressure, self.floor, self.fade, ca, self.give))


@dataclass(frozen=True)
class MeasuredWall(Wall):
    """Laws through measured points: cubics in pressure, zero at zero gauge."""

    rest_volume: SX
    volume_curve: PiecewiseCubic
    """Volume beyond that at rest [m3]."""
    curvature_curve: PiecewiseCubic
    stretch_curve: PiecewiseCubic

    def volume(self, pressure: SX) -> SX:
        return SX(self.rest_volume + self.volume_curve(pressure, ca))

    def curvature(self, pressure: SX) -> SX:
        return SX(self.curvature_curve(pressure, ca))

    def stretch(self, pressure: SX) -> SX:
        return SX(self.stretch_curve(pressure, ca))

    def energy(self, pressure: SX) -> SX:
        curve = self.volume_curve
        return SX(pressure * curve(pressure, ca) - curve.integral(pressure, ca))


@dataclass(frozen=True)
class SnappingWall(Wall):
    """Laws through measured points between which the pressure falls as the bellow swells.

    Pressure does not determine the swelling there: the laws are functions of the swelling,
    the volume beyond that at rest [m3].
    """

    rest_volume: SX
    pressure_curve: PiecewiseCubic
    """Gauge pressure [Pa] as a function of the swelling, as are the other laws."""
    curvature_curve: PiecewiseCubic
    stretch_curve: PiecewiseCubic

    def pressure(self, swelling: SX) -> SX:
        """Gauge pressure in equilibrium with a swelling [Pa]."""
        return SX(self.pressure_curve(swelling, ca))

    def volume(self, swelling: SX) -> SX:
        return self.rest_volume + swelling

    def curvature(self, swelling: SX) -> SX:
        return SX(self.curvature_curve(swelling, ca))

    def stretch(self, swelling: SX) -> SX:
        return SX(self.stretch_curve(swelling, ca))

    def energy(self, swelling: SX) -> SX:
        return SX(self.pressure_curve.integral(swelling, ca))


@dataclass(frozen=True)
class OwnWalls(Wall):
    """A law of its own for every bellow."""

    walls: tuple[Wall, ...]

    def pressure(self, swelling: SX) -> SX:
        """Gauge pressures in equilibrium with swellings (B,), where all walls may snap [Pa]."""
        walls = [wall for wall in self.walls if isinstance(wall, SnappingWall)]
        each = zip(walls, ca.vertsplit(swelling), strict=True)
        return ca.vertcat(*(wall.pressure(own) for wall, own in each))

    def volume(self, pressure: SX) -> SX:
        return self._each(lambda wall, own: wall.volume(own), pressure)

    def curvature(self, pressure: SX) -> SX:
        return self._each(lambda wall, own: wall.curvature(own), pressure)

    def stretch(self, pressure: SX) -> SX:
        return self._each(lambda wall, own: wall.stretch(own), pressure)

    def energy(self, pressure: SX) -> SX:
        return self._each(lambda wall, own: wall.energy(own), pressure)

    def _each(self, law: Callable[[Wall, SX], SX], pressure: SX) -> SX:
        each = zip(self.walls, ca.vertsplit(pressure), strict=True)
        return ca.vertcat(*(law(wall, own) for wall, own in each))
