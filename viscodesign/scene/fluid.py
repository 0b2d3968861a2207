"""`fluid:` a name, or a mapping with its properties."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

from pydantic import Field, model_validator

from viscodesign.plugins import members
from viscodesign.scene.fluids import __name__ as fluids_package
from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.section import Part, did_you_mean, refuse, refuse_at
from viscodesign.units import Density, Fraction, GasConstant, Pressure, Viscosity


@cache
def named_fluids() -> dict[str, type[NamedFluid]]:
    """Fluids that a spec may call by name."""
    return members(fluids_package, NamedFluid)  # type: ignore[type-abstract]


class Fluid(Part):
    """A named fluid of the library, or one with stated properties."""

    name: str = Field(min_length=1, description="air, water, or a name of your own")
    viscosity: Viscosity | None = Field(None, gt=0, description="Dynamic viscosity")
    density: Density | None = Field(None, gt=0, description="Density")
    gas_constant: GasConstant | None = Field(
        None, gt=0, description="Specific gas constant, for a gas"
    )
    bulk_modulus: Pressure | None = Field(None, gt=0, description="Bulk modulus, for a liquid")
    vapour_pressure: Pressure | None = Field(
        None, ge=0, description="Absolute vapour pressure, for a liquid"
    )
    fraction: Fraction | None = Field(
        None, ge=0, le=1, description="Mass fraction of the solute, for a named mixture"
    )
    polytropic_exponent: Fraction | None = Field(
        None,
        ge=1,
        le=5 / 3,
        description="Of a gas: 1 keeps its temperature (default), 1.4 lets air exchange no heat",
    )

    @model_validator(mode="after")
    def _complete(self) -> Fluid:
        if self.gas_constant is not None and self.bulk_modulus is not None:
            raise refuse("gas_constant and bulk_modulus are both given; a fluid is gas or liquid")
        if (self.viscosity is None) != (self.density is None):
            missing = "viscosity" if self.viscosity is None else "density"
            raise refuse_at(missing, "missing; a fluid of your own needs viscosity and density")
        stated = (self.gas_constant, self.bulk_modulus, self.vapour_pressure)
        if self.viscosity is None and self.name in named_fluids() and any(stated):
            raise refuse(
                f"{self.name} has its properties from a library; to state one of them, "
                "state viscosity and density as well"
            )
        if self.viscosity is None and self.name not in named_fluids():
            known = ", ".join(named_fluids())
            raise refuse(
                f"'{self.name}' is not a known fluid ({known}); give its viscosity and density"
                + did_you_mean(self.name, named_fluids())
            )
        return self

    @property
    def library_knows_stiffness(self) -> bool:
        """Whether the named fluid comes with a gas law or a bulk modulus."""
        return self.name in named_fluids() and named_fluids()[self.name].stiffness_known

    def properties(self, temperature: float, pressure: float) -> FluidProperties:
        """Its properties at ``temperature`` [K] and absolute ``pressure`` [Pa]."""
        if self.viscosity is None or self.density is None:
            known = named_fluids()[self.name].at(temperature, pressure, self.fraction)
        else:
            known = self._own(self.viscosity, self.density, temperature)
        return self._with_exponent(known)

    def _with_exponent(self, known: FluidProperties) -> FluidProperties:
        if self.polytropic_exponent is None:
            return known
        if not known.is_gas:
            raise refuse_at("polytropic_exponent", f"given, but {self.name} is no gas")
        return replace(known, polytropic_exponent=self.polytropic_exponent)

    def _own(self, viscosity: float, density: float, temperature: float) -> FluidProperties:
        """Properties as the spec states them."""
        if self.fraction is not None:
            raise refuse_at("fraction", "given, but only a named mixture has one")
        sound = None
        if self.gas_constant is not None:
            # Isothermal: the lower, cautious one where the heat capacities are not known.
            sound = math.sqrt(self.gas_constant * temperature)
        elif self.bulk_modulus is not None:
            sound = math.sqrt(self.bulk_modulus / density)
        return FluidProperties(
            name=self.name,
            viscosity=viscosity,
            density=density,
            gas_constant=self.gas_constant,
            bulk_modulus=self.bulk_modulus,
            vapour_pressure=self.vapour_pressure,
            speed_of_sound=sound,
        )
