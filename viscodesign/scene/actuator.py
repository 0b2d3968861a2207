"""`actuator:` the solid."""

from __future__ import annotations

from pydantic import Field

from viscodesign.scene.section import Part
from viscodesign.units import Density, Fraction, Length, Pressure, Time


class Actuator(Part):
    """The elastomer body as a beam that hangs from its clamp along +z."""

    length: Length = Field(gt=0, description="Length of the actuator, clamp to tip")
    height: Length = Field(gt=0, description="Size along x, in the plane of bending")
    width: Length = Field(gt=0, description="Size across the plane of bending")
    youngs_modulus: Pressure = Field(gt=0, description="Young's modulus of the elastomer")
    density: Density = Field(gt=0, description="Density of the elastomer")
    solid_fraction: Fraction = Field(gt=0, le=1, description="Solid part of the cross section")
    extension_factor: Fraction = Field(
        gt=0, description="Extension stiffness over that of a full rectangle"
    )
    bending_factor: Fraction = Field(
        gt=0, description="Bending stiffness over that of a full rectangle"
    )
    damping_time: Time = Field(1e-3, ge=0, description="Kelvin-Voigt time of the elastomer")
