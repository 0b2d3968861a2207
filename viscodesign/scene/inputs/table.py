"""`kind: table`: measured or designed values in rows."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.scene.table_file import check_rows, time_faults, with_rows
from viscodesign.units import Pressure, Time

PRESSURE_COLUMNS = ("time_s", "pressure_pa")


class TableInput(PiecewiseLinear):
    """Linear between rows, constant before the first and after the last; equal times are a jump."""

    name: ClassVar[str] = "table"
    kind: Literal["table"]
    file: str | None = Field(
        None, description="CSV with the columns time_s, pressure_pa; relative to the spec"
    )
    rows: tuple[tuple[Time, Pressure], ...] | None = Field(
        None, description="Instead of a file: pairs of [time, pressure]"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        return with_rows(given, info, PRESSURE_COLUMNS, time_faults, "a table")

    @model_validator(mode="after")
    def _check_times(self) -> TableInput:
        check_rows(self.rows or (), time_faults)
        return self

    def vertices(self, duration: float) -> np.ndarray:
        rows = self.rows or ()
        first = [(0.0, rows[0][1])] if rows[0][0] > 0 else []
        return np.array([*first, *rows, (max(duration, rows[-1][0]) + 1.0, rows[-1][1])])

    def initial(self) -> float:
        return (self.rows or ())[0][1]

    def profile(self) -> list[tuple[float, float]]:
        return list(self.rows or ())
