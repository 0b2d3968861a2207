"""Properties of a fluid, and the base of named fluids."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from typing import ClassVar

from viscodesign.lazy_dataclass import dataclass
from viscodesign.references import LiteratureReference
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
    """Polytropic exponent of a gas in the bellows; 1 is isothermal."""

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
    max_pressure: ClassVar[float] = 1e9
    """Highest absolute pressure of the correlations: that of the formulation of water [Pa]."""
    has_stiffness: ClassVar[bool] = True
    """Whether a gas constant or a bulk modulus is known."""
    other_names: ClassVar[tuple[str, ...]] = ()
    """What else it is called: a spec that says so is told its name."""
    graded_like: ClassVar[str] = ""
    """A name with a grade, of a fluid that comes in several: "silicone oil 1000 cSt"."""
    grade: ClassVar[float] = 0.0
    """Kinematic viscosity at 25 degC of one of these [cSt]."""
    is_mixture: ClassVar[bool] = False
    """Whether its properties depend on the mass fraction of a solute."""
    references: ClassVar[tuple[LiteratureReference, ...]] = ()
    """What to cite for it."""

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
        if pressure > cls.max_pressure:
            raise invalid_at(
                "ambient_pressure",
                f"must be at most {cls.max_pressure:g} Pa, up to which the properties of "
                f"{cls.name} are known; got {pressure:g} Pa",
            )
        return cls.properties(temperature, pressure, fraction or 0.0)

    @classmethod
    def called(cls, name: str) -> type[NamedFluid] | None:
        """The fluid that a spec's name stands for, if it is this one or a grade of it."""
        if not cls.graded_like:
            return cls if name == cls.name else None
        found = re.fullmatch(cls.pattern(), name)
        return None if found is None else type(cls.__name__, (cls,), {"grade": float(found[1])})

    @classmethod
    def pattern(cls) -> str:
        """Regular expression of a name with a grade [cSt]."""
        return rf"^{cls.name} +([0-9]+(?:\.[0-9]+)?) *cSt$"

    @classmethod
    @abstractmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        """Properties within the range of temperatures."""
