"""`fluid: water`."""

from __future__ import annotations

import math
from typing import ClassVar

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.section import refuse_at

SMALL_COMPRESSION = 1e6
"""Pressure step [Pa] over which the bulk modulus is taken."""


class Water(NamedFluid):
    """Ordinary water, liquid.

    Density and vapour pressure by IAPWS-95, viscosity by IAPWS 2008, both as
    implemented in the library `chemicals`.
    """

    name: ClassVar[str] = "water"
    coldest: ClassVar[float] = 273.16
    hottest: ClassVar[float] = 640.0

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del fraction
        from chemicals.iapws import iapws95_Psat, iapws95_rho
        from chemicals.viscosity import mu_IAPWS

        vapour_pressure = float(iapws95_Psat(temperature))
        if pressure <= vapour_pressure:
            raise refuse_at(
                "temperature",
                f"water boils at {temperature:g} K and {pressure:g} Pa absolute",
            )
        density = float(iapws95_rho(temperature, pressure))
        denser = float(iapws95_rho(temperature, pressure + SMALL_COMPRESSION))
        bulk_modulus = density * SMALL_COMPRESSION / (denser - density)
        return FluidProperties(
            name=cls.name,
            viscosity=float(mu_IAPWS(temperature, density)),
            density=density,
            bulk_modulus=bulk_modulus,
            vapour_pressure=vapour_pressure,
            speed_of_sound=math.sqrt(bulk_modulus / density),
        )
