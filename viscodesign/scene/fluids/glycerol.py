"""`fluid: glycerol`."""

from __future__ import annotations

from typing import ClassVar

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.fluids.glycerol_water import (
    ZERO_CELSIUS,
    glycerol_density,
    glycerol_viscosity,
)


class Glycerol(NamedFluid):
    """Pure glycerol; what stands open takes up water, and 1 % makes it a fifth less viscous.

    Viscosity by Cheng (2008), within 4 % of Segur and Oberstar (1951) from 0 to 100 degC; density
    by Volk and Kaehler (2018). Its bulk modulus is not given here; give a custom fluid where a
    syringe is the input.
    """

    name: ClassVar[str] = "glycerol"
    other_names: ClassVar[tuple[str, ...]] = ("glycerin", "glycerine", "pure glycerol")
    min_temperature: ClassVar[float] = ZERO_CELSIUS
    max_temperature: ClassVar[float] = 373.15
    has_stiffness: ClassVar[bool] = False

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del pressure, fraction
        celsius = temperature - ZERO_CELSIUS
        return FluidProperties(
            cls.name, glycerol_viscosity(celsius, 1.0), glycerol_density(celsius, 1.0)
        )
