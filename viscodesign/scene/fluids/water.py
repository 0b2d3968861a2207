"""`fluid: water`."""

from __future__ import annotations

import math
from typing import ClassVar

from viscodesign.references import LiteratureReference
from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.spec_part import invalid_at

BULK_MODULUS_STEP = 1e6
"""Pressure increment for the bulk modulus [Pa]."""


class Water(NamedFluid):
    """Ordinary water, liquid.

    Density and vapour pressure by IAPWS-95, viscosity by IAPWS 2008, both as
    implemented in the library `chemicals`.
    """

    name: ClassVar[str] = "water"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "wagner2002",
            "article",
            {
                "author": "Wagner, Wolfgang and Pru{\\ss}, Andreas",
                "title": "The {IAPWS} Formulation 1995 for the Thermodynamic "
                "Properties of Ordinary Water Substance for General and "
                "Scientific Use",
                "journal": "Journal of Physical and Chemical Reference Data",
                "volume": "31",
                "number": "2",
                "pages": "387--535",
                "year": "2002",
                "doi": "10.1063/1.1461829",
            },
        ),
        LiteratureReference(
            "huber2009",
            "article",
            {
                "author": "Huber, M. L. and Perkins, R. A. and Laesecke, A. and "
                "Friend, D. G. and Sengers, J. V. and Assael, M. J. and "
                "Metaxa, I. N. and Vogel, E. and Mares, R. and Miyagawa, "
                "K.",
                "title": "New International Formulation for the Viscosity of {H2O}",
                "journal": "Journal of Physical and Chemical Reference Data",
                "volume": "38",
                "number": "2",
                "pages": "101--125",
                "year": "2009",
                "doi": "10.1063/1.3088050",
            },
        ),
    )
    min_temperature: ClassVar[float] = 273.16
    max_temperature: ClassVar[float] = 640.0

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del fraction
        # From the package, as in `air`.
        from chemicals import iapws95_Psat, iapws95_rho, mu_IAPWS

        vapour_pressure = float(iapws95_Psat(temperature))
        if pressure <= vapour_pressure:
            raise invalid_at(
                "temperature",
                f"water boils at {temperature:g} K and {pressure:g} Pa absolute",
            )
        density = float(iapws95_rho(temperature, pressure))
        denser = float(iapws95_rho(temperature, pressure + BULK_MODULUS_STEP))
        bulk_modulus = density * BULK_MODULUS_STEP / (denser - density)
        return FluidProperties(
            name=cls.name,
            viscosity=float(mu_IAPWS(temperature, density)),
            density=density,
            bulk_modulus=bulk_modulus,
            vapour_pressure=vapour_pressure,
            speed_of_sound=math.sqrt(bulk_modulus / density),
        )
