"""A pressure regulator: an electro-pneumatic valve that is told a pressure and keeps it."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.units import Fraction, Pressure, PressureRate, Time

HIGHEST_SET_POINT = 1023
"""Set-points go from 0 to this, over the full scale."""


class RegulatorSpec(PumpSpec):
    """A pressure regulator on a serial line, fed with compressed gas."""

    name: ClassVar[str] = "regulator"

    kind: Literal["regulator"] = Field("regulator", description="The principle of the pump")
    full_scale: Pressure = Field(
        gt=0, description="Gauge pressure at the highest set-point", examples=["100 kPa"]
    )
    response_time: Time = Field(
        0.2, ge=0, description="Time constant with which the outlet follows (assumed)"
    )
    error: Fraction = Field(
        0.02, gt=0, lt=0.5, description="Error of the outlet at rest, relative to full scale"
    )
    rate_limit: PressureRate = Field(50e3, gt=0, description="Maximum commanded pressure rate")
    following_error: Fraction = Field(
        0.15,
        gt=0,
        lt=1,
        description="Distance from its set-point, relative to full scale, that stops it",
    )

    @property
    def step(self) -> float:
        """Step of the set-point [Pa]."""
        return self.full_scale / HIGHEST_SET_POINT
