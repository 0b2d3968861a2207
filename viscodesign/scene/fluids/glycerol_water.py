"""`fluid: {name: glycerol-water, fraction: 50 %}`."""

from __future__ import annotations

import math
from typing import ClassVar

from viscodesign.references import LiteratureReference
from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.spec_part import invalid, invalid_at

MAX_FRACTION_BELOW_FREEZING = 0.6
ZERO_CELSIUS = 273.15


class GlycerolWater(NamedFluid):
    """Glycerol dissolved in water, by mass fraction.

    From 0 to 100 degC, viscosity by Cheng (2008) with a correction for cold dilute solutions,
    within 3 % of Segur and Oberstar (1951) up to 60 % glycerol and 80 degC and within 4 % beyond;
    density by Volk and Kaehler (2018). Below 0 degC both by Melinder (2010), as implemented in the
    library `CoolProp` (its fluid INCOMP::MGL), up to 60 % glycerol. Its bulk modulus is unknown;
    give a custom fluid where a syringe is the input.
    """

    name: ClassVar[str] = "glycerol-water"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "cheng2008",
            "article",
            {
                "author": "Cheng, Nian-Sheng",
                "title": "Formula for the Viscosity of a Glycerol-Water Mixture",
                "journal": "Industrial \\& Engineering Chemistry Research",
                "volume": "47",
                "pages": "3285--3288",
                "year": "2008",
                "doi": "10.1021/ie071349z",
            },
        ),
        LiteratureReference(
            "volk2018",
            "article",
            {
                "author": 'Volk, A. and K{\\"a}hler, C. J.',
                "title": "Density model for aqueous glycerol solutions",
                "journal": "Experiments in Fluids",
                "volume": "59",
                "pages": "75",
                "year": "2018",
                "doi": "10.1007/s00348-018-2527-y",
            },
        ),
    )
    min_temperature: ClassVar[float] = 253.15
    max_temperature: ClassVar[float] = 373.15
    is_mixture: ClassVar[bool] = True
    has_stiffness: ClassVar[bool] = False

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        if temperature < ZERO_CELSIUS:
            return _cold(temperature, pressure, fraction)
        celsius = temperature - ZERO_CELSIUS
        return FluidProperties(
            cls.name, glycerol_viscosity(celsius, fraction), glycerol_density(celsius, fraction)
        )


def glycerol_viscosity(celsius: float, fraction: float) -> float:
    """Viscosity of a mass fraction of glycerol in water from 0 to 100 degC [Pa s].

    Source: N.-S. Cheng, Formula for the viscosity of a glycerol-water mixture, Industrial and
    Engineering Chemistry Research 47, 2008, 3285-3288. What it lacks of Segur and Oberstar (1951)
    in solutions below 50 % and 40 degC, up to 3.4 %, is added but for 2 %.
    """
    water = 1.790e-3 * math.exp((-1230 - celsius) * celsius / (36100 + 360 * celsius))
    glycerol = 12.1 * math.exp((-1233 + celsius) * celsius / (9900 + 70 * celsius))
    a = 0.705 - 0.0017 * celsius
    b = (4.9 + 0.036 * celsius) * a**2.5
    rest = 1 - fraction
    share = rest + a * b * fraction * rest / (a * fraction + b * rest)
    dilute, cold = max(0.5 - fraction, 0.0), max(1 - celsius / 40, 0.0)
    lacking = 1.2 * fraction * dilute**2 * cold**2
    return float(water**share * glycerol ** (1 - share) * (1 + lacking))


def glycerol_density(celsius: float, fraction: float) -> float:
    """Density of a mass fraction of glycerol in water from 0 to 100 degC [kg/m^3].

    Source: A. Volk and C. J. Kaehler, Density model for aqueous glycerol solutions, Experiments in
    Fluids 59, 2018, 75; by Bosart and Snoddy's measurements from 15 to 30 degC.
    """
    glycerol = 1273.3 - 0.6121 * celsius
    water = 1000 * (1 - abs((celsius - 3.98) / 615) ** 1.71)
    most = 1.78e-6 * celsius**2 - 1.82e-4 * celsius + 1.41e-2
    contraction = 1 + most * max(math.sin(math.pi * fraction**1.31), 0.0) ** 0.81
    return float(contraction / (fraction / glycerol + (1 - fraction) / water))


def _cold(temperature: float, pressure: float, fraction: float) -> FluidProperties:
    if fraction > MAX_FRACTION_BELOW_FREEZING:
        raise invalid_at(
            "fraction",
            f"must be at most {100 * MAX_FRACTION_BELOW_FREEZING:g} % glycerol by mass below 0 "
            f"degC, the range of known properties; got {100 * fraction:g} %. Give viscosity and "
            "density instead",
        )
    viscosity, density = (_property(letter, temperature, pressure, fraction) for letter in "VD")
    return FluidProperties(GlycerolWater.name, viscosity, density)


def _property(letter: str, temperature: float, pressure: float, fraction: float) -> float:
    try:
        # Slow to import, and only a solution below 0 degC needs it.
        from CoolProp.CoolProp import PropsSI
    except ImportError as error:
        raise invalid(
            "glycerol-water below 0 degC needs the library CoolProp: pip install "
            "'viscodesign[mixtures]', or give viscosity and density"
        ) from error
    try:
        return float(PropsSI(letter, "T", temperature, "P", pressure, f"INCOMP::MGL[{fraction}]"))
    except ValueError as error:
        raise invalid_at(
            "temperature",
            f"a solution of {100 * fraction:g} % glycerol has no known properties at "
            f"{temperature:g} K (it may be frozen)",
        ) from error
