"""`bellows.curve:` what was measured of one bellow."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any, get_args

from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.table_file import FromFile, check_rows, pressure_faults, with_rows
from viscodesign.scene.tables.columns import WantedColumn
from viscodesign.units import Angle, Area, Length, Pressure

CURVE_COLUMNS = (
    WantedColumn("pressure", get_args(Pressure)[1], ("p",)),
    WantedColumn("area", get_args(Area)[1]),
    WantedColumn("angle", get_args(Angle)[1]),
    WantedColumn("extension", get_args(Length)[1]),
)
ROW_SPACING_REL_MIN = 1e-4
"""Smallest spacing of rows relative to the measured range; closer rows amplify rounding errors."""
MAX_CURVE_ROWS = 60
"""Each row adds a term to the equations of every bellow."""


class BellowCurve(FromFile):
    """The measured curve of one bellow, in rows of increasing area.

    Where the pressure falls from one row to the next, the bellow is unstable under a given
    pressure and snaps through.
    """

    rows: tuple[tuple[Pressure, Area, Angle, Length], ...] | None = Field(
        None, description="Instead of a file: rows of [pressure, area, angle, extension]"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        return with_rows(given, info, CURVE_COLUMNS, pressure_faults, "a curve")

    @model_validator(mode="after")
    def _check_rows(self) -> BellowCurve:
        rows = self.rows or ()
        check_rows(rows, pressure_faults)
        if len(rows) > MAX_CURVE_ROWS:
            raise invalid_at("rows", f"{len(rows)} rows; at most {MAX_CURVE_ROWS} are allowed")
        for k, (before, after) in enumerate(itertools.pairwise(rows), start=2):
            if after[1] <= before[1]:
                raise invalid_at("rows", f"row {k}: the area must increase from row to row")
        if rows[1][0] < rows[0][0] or rows[-1][0] < rows[-2][0]:
            raise invalid_at(
                "rows",
                "the pressure must increase with the area at both ends; it may decrease only in "
                "between, where the bellow snaps through",
            )
        if not rows[0][0] <= 0.0 <= first_peak(rows):
            raise invalid_at("rows", "the first rising part must include zero gauge pressure")
        self._check_spacing(rows)
        return self

    def _check_spacing(self, rows: tuple[tuple[float, ...], ...]) -> None:
        """Raise a fault for rows that are too close to be resolved numerically."""
        column, unit = (1, "m2") if falls(rows) else (0, "Pa")
        smallest = ROW_SPACING_REL_MIN * (rows[-1][column] - rows[0][column])
        for k, (before, after) in enumerate(itertools.pairwise(rows), start=2):
            if after[column] - before[column] < smallest:
                raise invalid_at(
                    "rows",
                    f"rows {k - 1} and {k} are closer than {smallest:.3g} {unit}, 1e-4 of the "
                    "measured range; remove one of them",
                )


def falls(rows: Sequence[tuple[float, ...]]) -> bool:
    """Whether the pressure of a curve decreases anywhere while the area increases."""
    return any(after[0] < before[0] for before, after in itertools.pairwise(rows))


def first_peak(rows: Sequence[tuple[float, ...]]) -> float:
    """Pressure at the first maximum of the curve [Pa]."""
    pressures = [row[0] for row in rows]
    rising = itertools.takewhile(lambda pair: pair[1] > pair[0], itertools.pairwise(pressures))
    return max([pressures[0], *(after for _, after in rising)])
