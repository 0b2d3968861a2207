"""`fluid:` a name, or a mapping with its properties."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from pydantic import Field, model_validator

from viscodesign.errors import did_you_mean
from viscodesign.plugins import members
from viscodesign.scene.fluids import __name__ as fluids_package
from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.spec_part import SpecPart, invalid, invalid_at
from viscodesign.units import AbsolutePressure, Density, Fraction, GasConstant, Pressure, Viscosity


@cache
def named_fluids() -> dict[str, type[NamedFluid]]:
    """Fluids that a spec may name."""
    return members(fluids_package, NamedFluid)  # type: ignore[type-abstract]


def named_fluid(name: str) -> type[NamedFluid] | None:
    """The fluid that a spec's name stands for; None for a name of the user's own."""
    return next((found for kind in named_fluids().values() if (found := kind.called(name))), None)


def _hint(name: str) -> str:
    """What the name of an unknown fluid may have been meant to be."""
    own, plain = named_fluids(), " ".join(name.lower().replace("-", " ").split())
    for kind in own.values():
        known = (kind.name, *kind.other_names)
        if plain in known or (kind.graded_like and plain.startswith(known)):
            return (
                f"; state its viscosity at 25 degC, as in '{kind.graded_like}'"
                if kind.graded_like
                else f"; did you mean '{kind.name}'?"
            )
    return did_you_mean(name, own)


class Fluid(SpecPart):
    """A named fluid of the library, or one with given properties."""

    name: str = Field(
        min_length=1,
        description="air, water, another named fluid, or any name with viscosity and density",
    )
    viscosity: Viscosity | None = Field(None, gt=0, description="Dynamic viscosity")
    density: Density | None = Field(None, gt=0, description="Density")
    gas_constant: GasConstant | None = Field(
        None, gt=0, description="Specific gas constant, for a gas"
    )
    bulk_modulus: Pressure | None = Field(
        None, gt=0, description="Bulk modulus, for a liquid", examples=["2.2 GPa"]
    )
    vapour_pressure: AbsolutePressure | None = Field(
        None, ge=0, description="Absolute vapour pressure, for a liquid", examples=["2.3 kPa"]
    )
    fraction: Fraction | None = Field(
        None,
        ge=0,
        le=1,
        description="Mass fraction of the solute, for a named mixture",
        examples=["50 %"],
    )
    polytropic_exponent: Fraction | None = Field(
        None,
        ge=1,
        le=5 / 3,
        description="Of a gas: 1 for isothermal (default), 1.4 for adiabatic air",
        examples=["1.4"],
    )

    @model_validator(mode="after")
    def _complete(self) -> Fluid:
        if self.gas_constant is not None and self.bulk_modulus is not None:
            raise invalid(
                "gas_constant and bulk_modulus are both given; a fluid is either a gas or a liquid"
            )
        if (self.viscosity is None) != (self.density is None):
            missing = "viscosity" if self.viscosity is None else "density"
            raise invalid_at(missing, "missing; a custom fluid needs both viscosity and density")
        given = (self.gas_constant, self.bulk_modulus, self.vapour_pressure)
        if self.viscosity is None and named_fluid(self.name) and any(given):
            raise invalid(
                f"the properties of {self.name} come from a library; to give one of them, "
                "give viscosity and density as well"
            )
        if self.viscosity is None and not named_fluid(self.name):
            known = ", ".join(kind.graded_like or name for name, kind in named_fluids().items())
            raise invalid(
                f"unknown fluid '{self.name}' (known: {known}); give its viscosity and density"
                + _hint(self.name)
            )
        return self

    @property
    def library_knows_stiffness(self) -> bool:
        """Whether the library has a gas law or a bulk modulus of the fluid."""
        known = named_fluid(self.name)
        return known is not None and known.has_stiffness

    def properties(self, temperature: float, pressure: float) -> FluidProperties:
        """Properties at ``temperature`` [K] and absolute ``pressure`` [Pa]."""
        if self.viscosity is None or self.density is None:
            kind = named_fluid(self.name)
            assert kind is not None  # an unknown one was refused
            known = kind.at(temperature, pressure, self.fraction)
        else:
            known = self._custom(self.viscosity, self.density, temperature)
        return self._with_exponent(known)

    def _with_exponent(self, known: FluidProperties) -> FluidProperties:
        if self.polytropic_exponent is None:
            return known
        if not known.is_gas:
            raise invalid_at("polytropic_exponent", f"given, but {self.name} is not a gas")
        return replace(known, polytropic_exponent=self.polytropic_exponent)

    def _custom(self, viscosity: float, density: float, temperature: float) -> FluidProperties:
        """Properties as given in the spec."""
        if self.fraction is not None:
            raise invalid_at("fraction", "given, but the fluid is not a named mixture")
        sound = None
        if self.gas_constant is not None:
            # Isothermal: the lower bound, as the heat capacities are unknown.
            sound = (self.gas_constant * temperature) ** 0.5
        elif self.bulk_modulus is not None:
            sound = (self.bulk_modulus / density) ** 0.5
        return FluidProperties(
            name=self.name,
            viscosity=viscosity,
            density=density,
            gas_constant=self.gas_constant,
            bulk_modulus=self.bulk_modulus,
            vapour_pressure=self.vapour_pressure,
            speed_of_sound=sound,
        )
