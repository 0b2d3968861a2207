"""`fluid: air`."""

from __future__ import annotations

import math
from typing import ClassVar

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid

HEAT_CAPACITY_RATIO = 1.4


class Air(NamedFluid):
    """Dry air.

    Density by Lemmon et al. (2000), viscosity by Lemmon and Jacobsen (2004), both
    as implemented in the library `chemicals`.
    """

    name: ClassVar[str] = "air"
    min_temperature: ClassVar[float] = 132.7
    max_temperature: ClassVar[float] = 1000.0

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del fraction
        from chemicals.air import lemmon2000_air_MW, lemmon2000_rho
        from chemicals.viscosity import mu_air_lemmon

        molar_density = lemmon2000_rho(temperature, pressure)
        density = molar_density * lemmon2000_air_MW / 1000
        gas_constant = pressure / (density * temperature)
        return FluidProperties(
            name=cls.name,
            viscosity=float(mu_air_lemmon(temperature, molar_density)),
            density=float(density),
            gas_constant=float(gas_constant),
            speed_of_sound=math.sqrt(HEAT_CAPACITY_RATIO * gas_constant * temperature),
        )
