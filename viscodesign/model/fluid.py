"""Laws of the fluid for the balances: density as a function of pressure."""

from __future__ import annotations

from abc import ABC, abstractmethod

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.traced_formula import traced
from viscodesign.physics import gas

SX = ca.SX


class FluidLaw(ABC):
    """A barotropic fluid; amounts are stated as volume at ambient density."""

    @abstractmethod
    def density(self, pressure: SX) -> SX:
        """Density, relative to that at ambient pressure [1]."""

    @abstractmethod
    def density_integral(self, pressure: SX) -> SX:
        """Integral of the density over pressure, from zero gauge [Pa]; drives tube flow."""

    @abstractmethod
    def specific_work(self, pressure: SX) -> SX:
        """Integral of the inverse density over pressure [Pa]: work per amount of fluid."""


@dataclass(frozen=True)
class Incompressible(FluidLaw):
    """Constant density: amounts are volumes."""

    def density(self, pressure: SX) -> SX:
        del pressure
        return SX(1)

    def density_integral(self, pressure: SX) -> SX:
        return pressure

    def specific_work(self, pressure: SX) -> SX:
        return pressure


@dataclass(frozen=True)
class Gas(FluidLaw):
    """A polytropic gas; ``ambient`` absolute [Pa]."""

    ambient: SX
    exponent: float

    def density(self, pressure: SX) -> SX:
        return traced(gas.density_ratio, pressure, self.ambient, self.exponent)

    def density_integral(self, pressure: SX) -> SX:
        return traced(gas.density_integral, pressure, self.ambient, self.exponent)

    def specific_work(self, pressure: SX) -> SX:
        return traced(gas.specific_work, pressure, self.ambient, self.exponent)


@dataclass(frozen=True)
class Liquid(FluidLaw):
    """A liquid of constant bulk modulus K [Pa]: density 1 + p/K, relative to ambient."""

    bulk_modulus: SX

    def density(self, pressure: SX) -> SX:
        return 1 + pressure / self.bulk_modulus

    def density_integral(self, pressure: SX) -> SX:
        return pressure + pressure**2 / (2 * self.bulk_modulus)

    def specific_work(self, pressure: SX) -> SX:
        return self.bulk_modulus * ca.log(self.density(pressure))
