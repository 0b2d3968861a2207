"""What a fluid is, and how a named one gets its properties."""

from __future__ import annotations

import math
from abc import ABC
from dataclasses import dataclass
from typing import ClassVar

from viscodesign.scene.base import refuse_at


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
    """[Pa] of a liquid."""
    vapour_pressure: float | None = None
    """Absolute [Pa], of a liquid where it is known."""
    speed_of_sound: float | None = None
    """[m/s]"""

    @property
    def is_gas(self) -> bool:
        """Whether a gas law holds for it."""
        return self.gas_constant is not None


class NamedFluid(ABC):
    """A fluid of the property library CoolProp (Bell et al. 2014)."""

    name: ClassVar[str]
    library_name: ClassVar[str]
    gas: ClassVar[bool]

    @classmethod
    def at(cls, temperature: float, pressure: float) -> FluidProperties:
        """Properties at ``temperature`` [K] and absolute ``pressure`` [Pa]."""
        from CoolProp.CoolProp import PropsSI

        def value(what: str) -> float:
            return float(PropsSI(what, "T", temperature, "P", pressure, cls.library_name))

        try:
            density, sound = value("D"), value("A")
            vapour = None
            if not cls.gas:
                vapour = float(PropsSI("P", "T", temperature, "Q", 0, cls.library_name))
                if pressure <= vapour:
                    raise refuse_at(
                        "temperature", f"{cls.name} boils at {temperature:g} K and {pressure:g} Pa"
                    )
            viscosity = value("V")
        except ValueError as error:
            if cls.__name__ in str(error):
                raise
            raise refuse_at(
                "temperature",
                f"{cls.name} has no properties at {temperature:g} K and {pressure:g} Pa absolute: "
                f"{str(error).split(':')[0].strip()}",
            ) from error
        return FluidProperties(
            name=cls.name,
            viscosity=viscosity,
            density=density,
            gas_constant=pressure / (density * temperature) if cls.gas else None,
            bulk_modulus=None if cls.gas else density * sound**2,
            vapour_pressure=vapour,
            speed_of_sound=sound,
        )


def isothermal_sound(gas_constant: float, temperature: float) -> float:
    """Isothermal speed of sound of an ideal gas, sqrt(R T) [m/s]: the lower, cautious one."""
    return math.sqrt(gas_constant * temperature)
