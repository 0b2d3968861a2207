"""`fluid: {name: glycerol-water, fraction: 50 %}`."""

from __future__ import annotations

from typing import ClassVar

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.section import refuse, refuse_at

LARGEST_FRACTION = 0.6


class GlycerolWater(NamedFluid):
    """Glycerol dissolved in water, by mass fraction.

    Density and viscosity by Melinder (2010), as implemented in the library `CoolProp`
    (its fluid INCOMP::MGL), up to 60 % glycerol. Its bulk modulus is not known there;
    state one where a syringe drives.
    """

    name: ClassVar[str] = "glycerol-water"
    coldest: ClassVar[float] = 253.15
    hottest: ClassVar[float] = 313.15
    mixture: ClassVar[bool] = True
    stiffness_known: ClassVar[bool] = False

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        if fraction > LARGEST_FRACTION:
            raise refuse_at(
                "fraction",
                f"{100 * fraction:g} % is given; the properties of {cls.name} are known up to "
                f"{100 * LARGEST_FRACTION:g} % glycerol by mass. Give viscosity and density",
            )
        viscosity, density = (
            _property(letter, temperature, pressure, fraction) for letter in ("V", "D")
        )
        return FluidProperties(name=cls.name, viscosity=viscosity, density=density)


def _property(letter: str, temperature: float, pressure: float, fraction: float) -> float:
    try:
        # Slow to import, and only this fluid needs it.
        from CoolProp.CoolProp import PropsSI
    except ImportError as error:
        raise refuse(
            "glycerol-water needs the library CoolProp: pip install 'viscodesign[mixtures]', "
            "or give viscosity and density"
        ) from error
    try:
        return float(PropsSI(letter, "T", temperature, "P", pressure, f"INCOMP::MGL[{fraction}]"))
    except ValueError as error:
        raise refuse_at(
            "temperature",
            f"{temperature:g} K is given; a solution of {100 * fraction:g} % glycerol has no "
            "known properties there (it may be frozen)",
        ) from error
