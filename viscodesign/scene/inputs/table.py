"""`kind: table`: measured or designed, row by row."""

from __future__ import annotations

import csv
import io
import itertools
import math
from pathlib import Path
from typing import Any, ClassVar, Literal

from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.base import refuse, refuse_at
from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.units import Pressure, Time

COLUMNS = ("time_s", "pressure_pa")
LARGEST_FILE = 64 * 1024 * 1024


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
            raise refuse_at("file", f"{given['file']!r} is not a file name")
        if "file" in given:
            folder = (info.context or {}).get("folder", Path())
            rest = {key: value for key, value in given.items() if key != "file"}
            return {**rest, "rows": read_rows(folder / given["file"], given["file"])}
        return given

    @model_validator(mode="after")
    def _in_order(self) -> Table:
        rows = self.rows or ()
        if len(rows) < 2:
            raise refuse_at("rows", f"{len(rows)} rows; a table needs at least two")
        for k, (before, after) in enumerate(itertools.pairwise(rows)):
            if after[0] < before[0]:
                raise refuse_at(
                    "rows", f"row {k + 2}: time runs back from {before[0]:g} s to {after[0]:g} s"
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


def read_rows(path: Path, shown: str) -> list[tuple[float, float]]:
    """Rows (time [s], pressure [Pa]) of a CSV; faults name the file and the row."""
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise refuse_at("file", f"{shown} is larger than {LARGEST_FILE >> 20} MiB")
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        raise refuse_at("file", f"{shown} cannot be read: {reason} (looked for {path})") from error
    lines = csv.reader(io.StringIO(text))
    header = [cell.strip() for cell in next(lines, [])]
    if tuple(header) != COLUMNS:
        raise refuse_at(
            "file",
            f"{shown}: the first line is '{','.join(header)}'; '{','.join(COLUMNS)}' is wanted",
        )
    return [_row(cells, number, shown) for number, cells in enumerate(lines, start=2) if cells]


def _row(cells: list[str], number: int, shown: str) -> tuple[float, float]:
    place = f"{shown}, line {number}"
    if len(cells) != len(COLUMNS):
        raise refuse_at("file", f"{place}: {len(cells)} values; {len(COLUMNS)} are wanted")
    values = []
    for column, cell in zip(COLUMNS, cells, strict=True):
        if not cell.strip():
            raise refuse_at("file", f"{place}: {column} is empty")
        try:
            value = float(cell)
        except ValueError as error:
            raise refuse_at("file", f"{place}: {column} is '{cell}', not a number") from error
        if not math.isfinite(value):
            raise refuse_at("file", f"{place}: {column} is {cell}, not finite")
        values.append(value)
    if values[0] < 0:
        raise refuse_at("file", f"{place}: time_s is {values[0]:g}, before the start at 0")
    return values[0], values[1]
