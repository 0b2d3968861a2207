"""Properties of a fluid, and the base of named fluids."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import invalid_at


@dataclass(frozen=True)
class FluidProperties:
    """A Newtonian fluid at the scene's temperature and ambient pressure, in SI."""

    name: str
    viscosity: float
    """[Pa s]"""
    density: float
    """[kg/m3]"""
    gas_constant: float | None = None
    """Specific gas constant [J/(kg K)] of a gas."""
    bulk_modulus: float | None = None
    """Isothermal [Pa], of a liquid."""
    vapour_pressure: float | None = None
    """Absolute [Pa], of a liquid if known."""
    speed_of_sound: float | None = None
    """[m/s]"""
    polytropic_exponent: float = 1.0
    """Of a gas in the bellows; 1 is isothermal."""

    @property
    def is_gas(self) -> bool:
        """Whether the fluid is a gas."""
        return self.gas_constant is not None


class NamedFluid(ABC):
    """A fluid whose properties come from a library; a fluid is a file with one subclass."""

    name: ClassVar[str]
    min_temperature: ClassVar[float]
    """Lowest temperature of the correlations [K]."""
    max_temperature: ClassVar[float]
    """Highest temperature of the correlations [K]."""
    has_stiffness: ClassVar[bool] = True
    """Whether a gas constant or a bulk modulus is known."""
    is_mixture: ClassVar[bool] = False
    """Whether its properties depend on the mass fraction of a solute."""

    @classmethod
    def at(
        cls, temperature: float, pressure: float, fraction: float | None = None
    ) -> FluidProperties:
        """Properties at ``temperature`` [K] and absolute ``pressure`` [Pa]; a fault out of range.

        ``fraction`` is the mass fraction of a mixture's solute [1].
        """
        if cls.is_mixture and fraction is None:
            raise invalid_at(
                "fraction", f"missing; {cls.name} needs a mass fraction, such as '50 %'"
            )
        if fraction is not None and not cls.is_mixture:
            raise invalid_at("fraction", f"given, but {cls.name} is not a mixture")
        if not cls.min_temperature <= temperature <= cls.max_temperature:
            raise invalid_at(
                "temperature",
                f"must be from {cls.min_temperature:g} K to {cls.max_temperature:g} K, where the "
                f"properties of {cls.name} are known; got {temperature:g} K",
            )
        return cls.properties(temperature, pressure, fraction or 0.0)

    @classmethod
    @abstractmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        """Properties within the range of temperatures."""
