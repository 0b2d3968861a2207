"""`actuator:` the elastomer body."""

from __future__ import annotations

from pydantic import Field

from viscodesign.scene.spec_part import SpecPart
from viscodesign.units import Density, Fraction, Length, Pressure, Time


class Actuator(SpecPart):
    """The elastomer body, a beam that extends from its clamp along +z."""

    length: Length = Field(
        gt=0, description="Length of the actuator, clamp to tip", examples=["109 mm"]
    )
    height: Length = Field(
        gt=0, description="Size along x, in the bending plane", examples=["30 mm"]
    )
    width: Length = Field(
        gt=0, description="Size perpendicular to the bending plane", examples=["20 mm"]
    )
    youngs_modulus: Pressure = Field(
        gt=0, description="Young's modulus of the elastomer", examples=["1.8 MPa"]
    )
    density: Density = Field(gt=0, description="Density of the elastomer")
    solid_fraction: Fraction = Field(
        gt=0,
        le=1,
        description="Solid part of the cross section (height x width), for the mass",
        examples=["47 %"],
    )
    extension_factor: Fraction = Field(
        gt=0,
        description="Stiffness in tension, EA, relative to a solid rectangle of height x width",
        examples=["0.53"],
    )
    bending_factor: Fraction = Field(
        gt=0,
        description="Bending stiffness, EI, relative to a solid rectangle of height x width",
        examples=["0.55"],
    )
    shear_factor: Fraction | None = Field(
        None,
        gt=0,
        description="Stiffness in shear, relative to a solid rectangle with kappa = 5/6 and "
        "G = E/3; absent: extension_factor",
        examples=["0.53"],
    )
    damping_time: Time = Field(
        1e-3, ge=0, description="Kelvin-Voigt retardation time of the elastomer", examples=["1 ms"]
    )
