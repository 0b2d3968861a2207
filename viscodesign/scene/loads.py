"""`loads:` external loads on the rod."""

from __future__ import annotations

from typing import Any

from pydantic import Field, field_validator

from viscodesign.errors import not_among
from viscodesign.scene.ground import Ground
from viscodesign.scene.spec_part import SpecPart, invalid, switch
from viscodesign.units import Acceleration, Angle, Force, Mass

STANDARD_GRAVITY = 9.80665


class GravityLoad(SpecPart):
    """Gravity in the plane of motion; `tilt` rotates it from +z towards +x."""

    acceleration: Acceleration = Field(
        STANDARD_GRAVITY, ge=0, description="Gravitational acceleration"
    )
    tilt: Angle = Field(
        0.0,
        description="Angle to the clamped axis: 0 for a hanging, 90 deg for a horizontal actuator",
    )


class TipForce(SpecPart):
    """A dead force on the tip."""

    x: Force = Field(0.0, description="To the right")
    z: Force = Field(0.0, description="Away from the clamp")


class Loads(SpecPart):
    """Gravity, a force on the tip, a payload, and what the actuator may touch."""

    gravity: GravityLoad | None = Field(
        default_factory=GravityLoad,
        description="off, on, or {acceleration, tilt}; default: hanging in Earth's gravity",
    )
    tip_force: TipForce = Field(
        default_factory=TipForce, description="Force on the tip, of constant direction"
    )
    payload: Mass = Field(0.0, ge=0, description="Mass at the tip")
    ground: Ground | None = Field(
        None, description="Rigid surface that the actuator may touch; default: none"
    )

    @field_validator("gravity", mode="before")
    @classmethod
    def _switch(cls, given: Any) -> Any:
        if isinstance(given, (dict, GravityLoad)) or given is None:
            return given
        if isinstance(switched := switch(given), bool):
            return {} if switched else None
        raise invalid(not_among(given, ("off", "on"), "a mapping of acceleration, tilt"))
