"""`fluid: air`."""

from __future__ import annotations

import math
from typing import ClassVar

from viscodesign.references import LiteratureReference
from viscodesign.scene.fluids.base import FluidProperties, NamedFluid

HEAT_CAPACITY_RATIO = 1.4


class Air(NamedFluid):
    """Dry air.

    Density by Lemmon et al. (2000), viscosity by Lemmon and Jacobsen (2004), both
    as implemented in the library `chemicals`.
    """

    name: ClassVar[str] = "air"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "lemmon2000",
            "article",
            {
                "author": "Lemmon, Eric W. and Jacobsen, Richard T. and Penoncello,"
                " Steven G. and Friend, Daniel G.",
                "title": "Thermodynamic Properties of Air and Mixtures of "
                "Nitrogen, Argon, and Oxygen From 60 to 2000 {K} at "
                "Pressures to 2000 {MPa}",
                "journal": "Journal of Physical and Chemical Reference Data",
                "volume": "29",
                "number": "3",
                "pages": "331--385",
                "year": "2000",
                "doi": "10.1063/1.1285884",
            },
        ),
        LiteratureReference(
            "lemmon2004",
            "article",
            {
                "author": "Lemmon, E. W. and Jacobsen, R. T.",
                "title": "Viscosity and Thermal Conductivity Equations for "
                "Nitrogen, Oxygen, Argon, and Air",
                "journal": "International Journal of Thermophysics",
                "volume": "25",
                "number": "1",
                "pages": "21--69",
                "year": "2004",
                "doi": "10.1023/B:IJOT.0000022327.04529.f3",
            },
        ),
    )
    min_temperature: ClassVar[float] = 132.7
    max_temperature: ClassVar[float] = 1000.0

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del fraction
        # From the package: of modules that import each other two threads may meet half of one.
        from chemicals import lemmon2000_air_MW, lemmon2000_rho, mu_air_lemmon

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
