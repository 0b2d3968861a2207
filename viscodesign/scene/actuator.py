"""`actuator:` the elastomer body."""

from __future__ import annotations

from pydantic import Field

from viscodesign.scene.spec_part import SpecPart
from viscodesign.units import Density, Fraction, Length, Pressure, Time


class Actuator(SpecPart):
    """The elastomer body, a beam that extends from its clamp along +z."""

    length: Length = Field(gt=0, description="Length of the actuator, clamp to tip")
    height: Length = Field(gt=0, description="Size along x, in the bending plane")
    width: Length = Field(gt=0, description="Size perpendicular to the bending plane")
    youngs_modulus: Pressure = Field(gt=0, description="Young's modulus of the elastomer")
    density: Density = Field(gt=0, description="Density of the elastomer")
    solid_fraction: Fraction = Field(gt=0, le=1, description="Solid fraction of the cross section")
    extension_factor: Fraction = Field(
        gt=0, description="Extension stiffness relative to a solid rectangle"
    )
    bending_factor: Fraction = Field(
        gt=0, description="Bending stiffness relative to a solid rectangle"
    )
    damping_time: Time = Field(
        1e-3, ge=0, description="Kelvin-Voigt retardation time of the elastomer"
    )
