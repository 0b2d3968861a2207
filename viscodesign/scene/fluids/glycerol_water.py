"""`fluid: {name: glycerol-water, fraction: 50 %}`."""

from __future__ import annotations

from typing import ClassVar

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.spec_part import invalid, invalid_at

MAX_FRACTION = 0.6


class GlycerolWater(NamedFluid):
    """Glycerol dissolved in water, by mass fraction.

    Density and viscosity by Melinder (2010), as implemented in the library `CoolProp`
    (its fluid INCOMP::MGL), up to 60 % glycerol. Its bulk modulus is unknown; give a
    custom fluid where a syringe is the input.
    """

    name: ClassVar[str] = "glycerol-water"
    min_temperature: ClassVar[float] = 253.15
    max_temperature: ClassVar[float] = 313.15
    is_mixture: ClassVar[bool] = True
    has_stiffness: ClassVar[bool] = False

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        if fraction > MAX_FRACTION:
            raise invalid_at(
                "fraction",
                f"must be at most {100 * MAX_FRACTION:g} % glycerol by mass, the range of known "
                f"properties; got {100 * fraction:g} %. Give viscosity and density instead",
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
        raise invalid(
            "glycerol-water needs the library CoolProp: pip install 'viscodesign[mixtures]', "
            "or give viscosity and density"
        ) from error
    try:
        return float(PropsSI(letter, "T", temperature, "P", pressure, f"INCOMP::MGL[{fraction}]"))
    except ValueError as error:
        raise invalid_at(
            "temperature",
            f"a solution of {100 * fraction:g} % glycerol has no known properties at "
            f"{temperature:g} K (it may be frozen)",
        ) from error
