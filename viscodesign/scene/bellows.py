"""`bellows:` their number, size and measured coefficients."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Annotated, Any

from pydantic import AfterValidator, Field, ValidationInfo, model_validator

from viscodesign.scene.section import Part, refuse, refuse_at
from viscodesign.scene.table_file import refuse_rows, standing, with_rows
from viscodesign.units import (
    Angle,
    Area,
    AreaPerForce,
    AreaPerMoment,
    AreaPerPressure,
    Fraction,
    Length,
    Pressure,
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


CURVE_COLUMNS = ("pressure_pa", "area_m2", "angle_rad", "extension_m")
CLOSEST_ROWS = 1e-4
"""Part of the range by which pressures must differ; closer ones would cost digits."""
MOST_CURVE_ROWS = 60
"""Every row costs a term in every bellow."""


class MaterialCurve(Part):
    """What was measured of one bellow, row by row in the order of its growing area.

    Where the pressure falls between two rows the bellow snaps: under a given pressure its
    swelling is not settled there.
    """

    file: str | None = Field(
        None, description=f"CSV with the columns {', '.join(CURVE_COLUMNS)}; relative to the spec"
    )
    rows: tuple[tuple[Pressure, Area, Angle, Length], ...] | None = Field(
        None, description="Instead of a file: [pressure, area, angle, extension] rows"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        return with_rows(given, info, CURVE_COLUMNS, standing, "a curve")

    @model_validator(mode="after")
    def _fit_to_follow(self) -> MaterialCurve:
        rows = self.rows or ()
        refuse_rows(rows, standing)
        if len(rows) > MOST_CURVE_ROWS:
            raise refuse_at("rows", f"{len(rows)} rows; at most {MOST_CURVE_ROWS} are allowed")
        for k, (before, after) in enumerate(itertools.pairwise(rows), start=2):
            if after[1] <= before[1]:
                raise refuse_at("rows", f"row {k}: the area must rise with the pressure")
        if rows[1][0] < rows[0][0] or rows[-1][0] < rows[-2][0]:
            raise refuse_at(
                "rows",
                "the pressure must rise with the area at both ends; only between them may it "
                "fall, where a bellow snaps",
            )
        if not rows[0][0] <= 0.0 <= first_peak(rows):
            raise refuse_at("rows", "the pressures must reach across zero gauge")
        self._refuse_close(rows)
        return self

    def _refuse_close(self, rows: tuple[tuple[float, ...], ...]) -> None:
        """Raise a fault for rows that are closer than numbers can tell well."""
        column, unit = (1, "m2") if falls(rows) else (0, "Pa")
        closest = CLOSEST_ROWS * (rows[-1][column] - rows[0][column])
        for k, (before, after) in enumerate(itertools.pairwise(rows), start=2):
            if after[column] - before[column] < closest:
                raise refuse_at(
                    "rows",
                    f"rows {k - 1} and {k} are closer than {closest:.3g} {unit}, a ten-thousandth "
                    "of the measured range; leave one out",
                )


def falls(rows: Sequence[tuple[float, ...]]) -> bool:
    """Whether the pressure of a curve falls anywhere while its area grows."""
    return any(after[0] < before[0] for before, after in itertools.pairwise(rows))


def first_peak(rows: Sequence[tuple[float, ...]]) -> float:
    """Pressure up to which the first rows rise without a break [Pa]."""
    pressures = [row[0] for row in rows]
    rising = itertools.takewhile(lambda pair: pair[1] > pair[0], itertools.pairwise(pressures))
    return max([pressures[0], *(after for _, after in rising)])


def snaps(bellows: Bellows) -> bool:
    """Whether a curve was measured by which a bellow snaps."""
    return bellows.curve is not None and falls(bellows.curve.rows or ())


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
    curve: MaterialCurve | None = Field(
        None, description="Measured laws of one bellow in the place of the linear ones"
    )
