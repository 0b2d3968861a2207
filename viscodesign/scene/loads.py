"""`loads:` what acts on the rod from outside."""

from __future__ import annotations

from typing import Any

from pydantic import Field, field_validator

from viscodesign.scene.section import Part, did_you_mean, refuse, switch
from viscodesign.units import Acceleration, Angle, Force, Mass

STANDARD_GRAVITY = 9.80665


class Gravity(Part):
    """Gravity in the plane of motion; `tilt` turns it from +z towards +x."""

    acceleration: Acceleration = Field(STANDARD_GRAVITY, ge=0, description="Its size")
    tilt: Angle = Field(
        0.0, description="From the clamped axis: 0 hangs, 90 deg is a horizontal actuator"
    )


class TipForce(Part):
    """A dead force on the tip."""

    x: Force = Field(0.0, description="To the right")
    z: Force = Field(0.0, description="Away from the clamp")


class Loads(Part):
    """Gravity, a force on the tip, and a mass carried there."""

    gravity: Gravity | None = Field(None, description="off, on, or {acceleration, tilt}")
    tip_force: TipForce = Field(default_factory=TipForce)
    payload: Mass = Field(0.0, ge=0, description="Mass carried at the tip")

    @field_validator("gravity", mode="before")
    @classmethod
    def _switch(cls, given: Any) -> Any:
        if isinstance(given, (dict, Gravity)) or given is None:
            return given
        if isinstance(switched := switch(given), bool):
            return {} if switched else None
        raise refuse(
            f"{given!r} is given; allowed are off, on or a mapping of acceleration, tilt"
            + (did_you_mean(given, ("off", "on")) if isinstance(given, str) else "")
        )
