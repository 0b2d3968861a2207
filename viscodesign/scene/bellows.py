"""`bellows:` their number, size and measured coefficients."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, Field

from viscodesign.scene.base import Part, refuse
from viscodesign.units import (
    Angle,
    AreaPerForce,
    AreaPerMoment,
    AreaPerPressure,
    Fraction,
    Length,
)

MOST_BELLOWS = 4096


def _paired(count: int) -> int:
    if count < 2 or count > MOST_BELLOWS:
        raise refuse(f"{count} bellows; allowed are even counts from 2 to {MOST_BELLOWS}")
    if count % 2:
        raise refuse(
            f"{count} is odd; bellows come in pairs, one left and one right. "
            f"Use {count - 1} or {count + 1}"
        )
    return count


class Bellows(Part):
    """Equal bellows in pairs, one right and one left of the axis in every section."""

    count: Annotated[int, Field(strict=True), AfterValidator(_paired)] = Field(
        description="Number of bellows, even"
    )
    height: Length = Field(gt=0, description="Size along x")
    width: Length = Field(gt=0, description="Size along z")
    length: Length = Field(gt=0, description="Size along the stream")
    area_per_pressure: AreaPerPressure = Field(gt=0, description="da1/dp")
    angle_per_pressure: Angle = Field(description="dpsi/d(p'/E), bending of a section")
    extension_per_pressure: Length = Field(description="dzeta/d(pbar/E), extension of a section")
    area_per_force: AreaPerForce = Field(0.0, description="da1/dN_e, feedback of normal force")
    area_per_moment: AreaPerMoment = Field(0.0, description="da1/dM_e, feedback of moment")
    collapse_fraction: Fraction = Field(
        0.1, ge=0, lt=1, description="Smallest volume of a bellow, of its rest volume"
    )
