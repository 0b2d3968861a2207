"""What a fluid is, and what a named one must offer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from viscodesign.scene.section import refuse_at


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
    """Absolute [Pa], of a liquid where it is known."""
    speed_of_sound: float | None = None
    """[m/s]"""
    polytropic_exponent: float = 1.0
    """Of a gas in its bellows: 1 keeps its temperature."""

    @property
    def is_gas(self) -> bool:
        """Whether a gas law holds for it."""
        return self.gas_constant is not None


class NamedFluid(ABC):
    """A fluid whose properties a library knows; a member is a file with one subclass."""

    name: ClassVar[str]
    coldest: ClassVar[float]
    """Lowest temperature of the correlations [K]."""
    hottest: ClassVar[float]
    """Highest temperature of the correlations [K]."""
    stiffness_known: ClassVar[bool] = True
    """Whether a gas law or a bulk modulus comes with it."""
    mixture: ClassVar[bool] = False
    """Whether its properties depend on the mass fraction of a solute."""

    @classmethod
    def at(
        cls, temperature: float, pressure: float, fraction: float | None = None
    ) -> FluidProperties:
        """Properties at ``temperature`` [K] and absolute ``pressure`` [Pa]; a fault outside.

        ``fraction`` is the mass fraction of a mixture's solute [1].
        """
        if cls.mixture and fraction is None:
            raise refuse_at("fraction", f"missing; {cls.name} needs a mass fraction, like '50 %'")
        if fraction is not None and not cls.mixture:
            raise refuse_at("fraction", f"given, but {cls.name} is no mixture")
        if not cls.coldest <= temperature <= cls.hottest:
            raise refuse_at(
                "temperature",
                f"{temperature:g} K is given; the properties of {cls.name} are known from "
                f"{cls.coldest:g} K to {cls.hottest:g} K",
            )
        return cls.properties(temperature, pressure, fraction or 0.0)

    @classmethod
    @abstractmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        """The same, inside of the range of temperatures."""
