"""`robot:` a body on actuators as legs."""

from __future__ import annotations

import math
import re
from typing import Annotated, Any

from pydantic import AfterValidator, Field, field_validator, model_validator

from viscodesign.scene.integer import Integer
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, invalid_at, raise_faults
from viscodesign.units import Angle, Fraction, Length, Mass, Time, Volume

STEEPEST = math.radians(45)
"""To which a leg may be turned: the equations hold for feet below their hips."""


class CentreOfMass(SpecPart):
    """Where the body's centre of mass is."""

    x: Length = Field(0.0, description="Forward of the middle", examples=["0 mm"])
    y: Length = Field(0.0, description="To the right of the middle", examples=["0 mm"])
    below_hips: Length = Field(0.0, description="Below the plane of the hips", examples=["10 mm"])


class RobotLeg(SpecPart):
    """A leg: which actuator, where it hangs, how it leans, and which input feeds it."""

    actuator: str = Field(min_length=1, description="Name of one of the actuators")
    x: Length = Field(description="Place of the hip, forward", examples=["90 mm"])
    y: Length = Field(description="Place of the hip, to the right", examples=["60 mm"])
    splay: Angle = Field(
        0.0,
        ge=-STEEPEST,
        le=STEEPEST,
        description="Turn outward, out of its plane of bending",
        examples=["5 deg"],
    )
    lean: Angle = Field(
        0.0,
        ge=-STEEPEST,
        le=STEEPEST,
        description="Turn forward, in its plane of bending",
        examples=["0 deg"],
    )
    source: str = Field(min_length=1, description="Name of the input that feeds it")

    @model_validator(mode="after")
    def _has_outside(self) -> RobotLeg:
        if self.splay and self.y == 0.0:
            raise invalid_at("splay", "a hip in the middle (y: 0) has no outer side; remove it")
        return self

    @property
    def tilt(self) -> float:
        """Its splay, positive to the right [rad]."""
        return self.splay if self.y >= 0.0 else -self.splay


class RobotFoot(SpecPart):
    """The feet, all equal: balls at the tips that roll on the ground."""

    radius: Length = Field(ge=0, description="Radius of the foot", examples=["15 mm"])
    mass: Mass = Field(
        gt=0,
        description="Mass of one foot; without mass feet would wedge under friction",
        examples=["7 g"],
    )
    friction: Fraction = Field(
        ge=0, description="Coefficient of Coulomb friction with the ground", examples=["0.6"]
    )


class RobotGround(SpecPart):
    """The ground: a plane."""

    slope: Angle = Field(
        0.0,
        ge=-STEEPEST,
        le=STEEPEST,
        description="By which the ground rises forward",
        examples=["0 deg"],
    )


class RobotPump(SpecPart):
    """What each of the robot's pumps can do, to be told whether a gait asks for more."""

    volume: Volume = Field(gt=0, description="Volume of its barrel", examples=["100 mL"])
    stroke_time: Time | None = Field(
        None, gt=0, description="Shortest time of a whole stroke", examples=["0.7 s"]
    )


def _named(legs: dict[str, RobotLeg]) -> dict[str, RobotLeg]:
    if not legs:
        raise invalid("empty; a robot needs legs")
    raise_faults(
        KeyFault((name,), "not a valid name; use letters, digits and '_', a letter first")
        for name in legs
        if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name)
    )
    return legs


class Robot(SpecPart):
    """One rigid body on legs; the pitch and roll inertias are those of an even slab."""

    mass: Mass = Field(gt=0, description="Mass of the whole robot", examples=["734 g"])
    body_length: Length = Field(
        gt=0, description="Length of the body, the unit of its speed", examples=["254 mm"]
    )
    payload: Mass = Field(0.0, ge=0, description="Mass carried at the centre of mass")
    centre_of_mass: CentreOfMass = Field(
        default_factory=CentreOfMass, description="Of the body, from the middle between the hips"
    )
    legs: Annotated[dict[str, RobotLeg], AfterValidator(_named)] = Field(
        description="The legs, by name"
    )
    foot: RobotFoot = Field(description="Radius, mass and friction of the feet")
    stiff_sections: tuple[Integer, ...] = Field(
        (),
        description="Sections, 1 at the hip, that pillars keep from bending and stretching",
    )
    ground: RobotGround = Field(default_factory=RobotGround, description="The ground")
    pump: RobotPump | None = Field(None, description="What each of its pumps can do")
    hip_height: Length | None = Field(
        None,
        gt=0,
        description="Height of the hips over the ground at the start; default: it stands",
    )
    damping_time: Time = Field(
        ge=0,
        description="Retardation time of the legs (Kelvin-Voigt); the speed depends on it",
        examples=["30 ms"],
    )

    @model_validator(mode="before")
    @classmethod
    def _one_body(cls, given: Any) -> Any:
        if isinstance(given, (list, tuple)):
            raise invalid(f"a list of {len(given)} bodies; a spec has one robot with one body")
        return given

    @field_validator("stiff_sections")
    @classmethod
    def _some(cls, sections: tuple[int, ...]) -> tuple[int, ...]:
        if any(section < 1 for section in sections):
            raise invalid("sections count from 1, at the hip")
        return tuple(sorted(set(sections)))

    @model_validator(mode="after")
    def _check_masses(self) -> Robot:
        feet = len(self.legs) * self.foot.mass
        if feet >= self.mass:
            raise invalid_at(
                "mass",
                f"{1e3 * self.mass:g} g for the whole robot, but its {len(self.legs)} feet alone "
                f"weigh {1e3 * feet:g} g; give the mass of body, legs and feet together",
            )
        return self
