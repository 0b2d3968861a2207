"""`kind: table`: measured or designed values in rows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, ClassVar, Literal, get_args

import numpy as np
from pydantic import Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticCustomError

from viscodesign.scene.inputs.base import (
    PiecewiseLinear,
    Surroundings,
    periods_to_cover,
    shortest_swing,
)
from viscodesign.scene.spec_part import invalid_at, switch
from viscodesign.scene.table_file import (
    FILE_KEYS,
    FileTable,
    FromFile,
    check_rows,
    require_one_source,
    table_of_file,
    time_faults,
)
from viscodesign.scene.tables.columns import WantedColumn
from viscodesign.scene.tables.measured import (
    Followed,
    MeasuredTable,
    cut_off_period,
    followed,
)
from viscodesign.scene.tables.noise import white_noise
from viscodesign.scene.tables.smoothing import without_noise
from viscodesign.units import Pressure, Time

TIME = WantedColumn("time", get_args(Time)[1], ("t", "zeit", "temps"))
PRESSURE = WantedColumn(
    "pressure", get_args(Pressure)[1], ("p", "press", "inlet_pressure", "druck", "pression")
)
MAX_FILE_ROWS = 5_000_000
ENDS_IN_NOISE = 4.0
"""Standard deviations of noise by which the ends of a cycle may differ and still meet."""
Rows = tuple[tuple[Time, Pressure], ...]


class TableInput(PiecewiseLinear, FromFile):
    """Linear between rows, constant before the first and after the last; equal times are a jump.

    With `repeat`, the rows are one cycle, from the first to the last.
    """

    name: ClassVar[str] = "table"
    kind: Literal["table"]
    rows: Rows | None = Field(None, description="Instead of a file: pairs of [time, pressure]")
    repeat: bool = Field(False, description="Whether the rows repeat, as one cycle")
    smooth: Literal["auto", "off"] | str | None = Field(
        None,
        description="auto: white noise is taken out; off: every row is followed; a time or a "
        "frequency: all that is faster is taken out. Default: auto for a file, off for rows",
    )
    measured: MeasuredTable | None = Field(
        None, description="Written by the program: where the rows come from"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        if not isinstance(given, dict):
            return given
        return cls.prepared(given, Surroundings.of(info.context))

    @classmethod
    def prepared(cls, given: Mapping[str, Any], around: Surroundings) -> dict[str, Any]:
        """The keys with rows as they are followed, instead of file, smooth and times of a cycle."""
        require_one_source(given, "a table")
        smooth, repeats = given.get("smooth"), switch(given.get("repeat")) is True
        rest = {key: v for key, v in given.items() if key not in (*FILE_KEYS, "smooth")}
        if given.get("file") is not None:
            table = _file_table(given, around)
            rows, own = table.values, _origin(given["file"], table)
            smooth = "auto" if smooth is None else smooth
        else:
            smooth = "off" if smooth is None else smooth
            is_plain = cut_off_period(smooth) == 0.0 and not repeats
            plain = None if is_plain else _plain_rows(given.get("rows"))
            if plain is None or (cut_off_period(smooth) == 0.0 and plain[0, 0] == 0.0):
                return rest
            rows, own = plain, {"rows": len(plain)}
        if repeats and rows[-1, 0] > rows[0, 0]:
            rows = _from_zero(rows)
        found = followed(rows[:, 0], rows[:, 1], smooth, around.accuracy)
        found = _ends_met(found) if repeats else found
        own |= {"noise": found.noise or None, "largest": found.largest or None}
        told = {"measured": own} if "file" in own or found.largest else {}
        pairs = zip(found.time.tolist(), found.value.tolist(), strict=True)
        return {**rest, **told, "rows": list(pairs)}

    @field_validator("repeat", mode="before")
    @classmethod
    def _switch(cls, given: Any) -> Any:
        return switch(given)

    @model_validator(mode="after")
    def _check_times(self) -> TableInput:
        rows = self.rows or ()
        check_rows(rows, time_faults)
        if self.repeat and not rows[-1][0] > rows[0][0]:
            raise invalid_at("repeat", "all rows are at one time; a cycle needs a duration")
        return self

    @property
    def period(self) -> float | None:
        """From the first row to the last, if these repeat [s]."""
        rows = self.rows or ()
        return rows[-1][0] - rows[0][0] if self.repeat else None

    def vertices(self, duration: float) -> np.ndarray:
        rows = self.rows or ()
        if self.period is not None:
            return self._cycles(periods_to_cover(duration / self.period))
        first = [(0.0, rows[0][1])] if rows[0][0] > 0 else []
        return np.array([*first, *rows, (max(duration, rows[-1][0]) + 1.0, rows[-1][1])])

    def _cycles(self, count: int) -> np.ndarray:
        """The rows of some cycles; where they meet, one row is enough."""
        rows = np.array(self.rows or ())
        period = rows[-1, 0] - rows[0, 0]
        start = np.arange(count) * period
        is_jump = bool(rows[0, 1] != rows[-1, 1])
        own = rows if is_jump else rows[:-1]
        times = (start[:, None] + own[:, 0]).reshape(-1)
        cycles = np.column_stack((times, np.tile(own[:, 1], count)))
        end = (count * period, rows[0 if is_jump else -1, 1])
        return np.concatenate([cycles, [end]])

    def initial(self) -> float:
        return (self.rows or ())[0][1]

    def profile(self) -> list[tuple[float, float]]:
        """The rows; of a cycle all of one, from its highest to its highest again."""
        rows = list(self.rows or ())
        if self.period is None:
            return rows
        top = max(range(len(rows)), key=lambda k: rows[k][1])
        again = [(t + self.period, p) for t, p in rows[: top + 1]]
        return [*rows[top:], *(again if rows[0][1] != rows[-1][1] else again[1:])]

    def shortest_swing(self, until: float) -> float:
        """Shortest swing of the rows without their noise."""
        profile = self.profile()
        noise = (self.measured.noise if self.measured is not None else None) or 0.0
        if not noise:
            time, value = np.array(profile).T
            noise = white_noise(time, value)
            if noise:
                smooth = without_noise(time, value, noise, 0.0)
                profile = list(zip(time.tolist(), smooth.tolist(), strict=True))
        return shortest_swing(profile, noise, until)

    @property
    def covered(self) -> tuple[float, float] | None:
        """First and last time [s] of measured rows; None where all times are covered."""
        rows = self.rows or ()
        return None if self.repeat else (rows[0][0], rows[-1][0])


def _file_table(given: Mapping[str, Any], around: Surroundings) -> FileTable:
    """The table of a file, its pressures above the baseline."""
    table = table_of_file(
        given,
        around.folder,
        (TIME, PRESSURE),
        time_faults,
        most_rows=MAX_FILE_ROWS,
        inlet=around.inlet,
    )
    pressure = table.columns[1]
    if pressure.reference == "abs":
        table.values[:, 1] -= around.ambient + around.baseline
    elif pressure.has_baseline:
        table.values[:, 1] -= around.baseline
    return table


def _origin(file: str, table: FileTable) -> dict[str, Any]:
    headers = ", ".join(column.header for column in table.columns)
    baseline = "; holds the baseline" if table.columns[1].has_baseline else ""
    absolute = "; absolute" if table.columns[1].reference == "abs" else ""
    return {"file": file, "rows": len(table.values), "columns": f"{headers}{baseline}{absolute}"}


def _plain_rows(rows: Any) -> np.ndarray | None:
    """Rows of a spec as numbers (n, 2); None where they are none, which is told elsewhere."""
    try:
        kinds = (TIME.kind, PRESSURE.kind)
        plain = [[k.parse(cell) for k, cell in zip(kinds, row, strict=True)] for row in rows]
        found = np.array(plain)
        return found if len(found) > 1 and not list(time_faults(found[:, 0])) else None
    except (PydanticCustomError, TypeError, ValueError):
        return None


def _from_zero(rows: np.ndarray) -> np.ndarray:
    """One cycle (n, 2) that starts at 0 s, of rows that may start anywhere on it."""
    time, value = rows.T
    period = time[-1] - time[0]
    start = math.ceil(time[0] / period) * period  # a whole number of cycles
    if not time[0] < start < time[-1]:
        return np.column_stack((time - time[0], value))
    behind, ahead = time > start, time < start
    ahead[0] = value[0] != value[-1]
    after = float(np.interp(start, time, value))
    at_start = np.flatnonzero(time == start)
    before = float(value[at_start[0]]) if len(at_start) else after
    times = [[0.0], time[behind] - start, time[ahead] - time[0] + (time[-1] - start), [period]]
    return np.column_stack(
        (np.concatenate(times), np.concatenate([[after], value[behind], value[ahead], [before]]))
    )


def _ends_met(found: Followed) -> Followed:
    """A cycle whose ends differ by no more than its noise meets in their mean."""
    apart = abs(found.value[-1] - found.value[0])
    if not 0.0 < apart <= ENDS_IN_NOISE * found.noise:
        return found
    value = found.value.copy()
    value[[0, -1]] = (value[0] + value[-1]) / 2
    return replace(found, value=value)
