"""`kind: table`: measured or designed, row by row."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.base import Complaint, refuse, refuse_any, refuse_at
from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.scene.table_file import MOST_ROWS, disorder, read_table, row_count
from viscodesign.units import Pressure, Time


class Table(PiecewiseLinear):
    """Linear between rows, level before the first and after the last; equal times jump."""

    name: ClassVar[str] = "table"
    kind: Literal["table"]
    file: str | None = Field(
        None, description="CSV with the columns time_s, pressure_pa; relative to the spec"
    )
    rows: tuple[tuple[Time, Pressure], ...] | None = Field(
        None, description="Instead of a file: [time, pressure] pairs"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        if not isinstance(given, dict):
            return given
        if ("file" in given) == ("rows" in given):
            raise refuse("a table needs one of 'file' and 'rows'")
        if not isinstance(given.get("file", ""), str):
            raise refuse_at("file", "the name of a CSV file is wanted, like 'pressure.csv'")
        if "file" in given:
            folder = (info.context or {}).get("folder", Path())
            rest = {key: value for key, value in given.items() if key != "file"}
            return {**rest, "rows": read_table(folder / given["file"], given["file"])}
        return given

    @model_validator(mode="after")
    def _in_order(self) -> Table:
        rows = self.rows or ()
        if len(rows) < 2 or len(rows) > MOST_ROWS:
            raise refuse_at("rows", row_count(len(rows)))
        refuse_any(
            Complaint(("rows", str(k)), f"row {k + 1}: {found}")
            for k, found in disorder([time for time, _ in rows])
        )
        return self

    def vertices(self, duration: float) -> list[tuple[float, float]]:
        rows = [(float(t), float(p)) for t, p in self.rows or ()]
        first = [(0.0, rows[0][1])] if rows[0][0] > 0 else []
        return [*first, *rows, (max(duration, rows[-1][0]) + 1.0, rows[-1][1])]

    def initial(self) -> float:
        return float((self.rows or ())[0][1])

    def profile(self) -> list[tuple[float, float]]:
        return [(float(t), float(p)) for t, p in self.rows or ()]
