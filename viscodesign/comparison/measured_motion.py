"""The motion of a measured table: columns of times and of the tip's x and z."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import get_args

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.errors import UsageError
from viscodesign.results.metrics import MetricInputs, metric_values
from viscodesign.results.run_comparison import ComparedMotion
from viscodesign.scene.reading.markers_file import MarkersFile, recorded_tip
from viscodesign.scene.spec_part import faults_of
from viscodesign.scene.table_file import table_of_file, text_of_file
from viscodesign.scene.tables.columns import WantedColumn
from viscodesign.scene.tables.layout import taken_apart
from viscodesign.units import Length, Time

MAX_MEASURED_ROWS = 5_000_000
_LENGTH = get_args(Length)[1]
COLUMNS = (
    WantedColumn("time", get_args(Time)[1], ("t",)),
    WantedColumn("tip_x", _LENGTH, ("x",)),
    WantedColumn("tip_z", _LENGTH, ("z",)),
)
HEADERS = ",".join(column.header for column in COLUMNS)


def measured_motion(file: Path, markers: MarkersFile | None = None) -> ComparedMotion:
    """The motion in a table, read as `scene.tables` reads all of them.

    ``markers``: which of a table in space are at the clamp and which at the tip. Raises
    `ViscodesignError` with what is wrong: no times, a unit that is unclear, a line that is not a
    row of numbers.
    """
    in_space = recorded_tip(_header(file), str(file), markers)
    if in_space is not None:
        values, words = np.column_stack([in_space.time, in_space.tip]), in_space.notices
    else:
        values, words = _table_rows(file), ()
    rows, note = _without_gaps(values)
    if len(rows) < 2:
        raise UsageError(f"{file}: fewer than two rows have x and z of the tip")
    told = "; ".join([*words, *([note] if note else [])])
    return replace(motion_of_rows(file.stem, rows, str(file)), note=told)


def _header(file: Path) -> tuple[str, ...]:
    """The header of a table; empty where it cannot be read, which is told later."""
    try:
        return tuple(taken_apart(text_of_file(file, str(file))).header)
    except PydanticCustomError:
        return ()


def _table_rows(file: Path) -> np.ndarray:
    """Rows (T, 3) of a table with time, x and z of the tip; NaN in gaps."""
    try:
        table = table_of_file(
            {"file": str(file)},
            Path(),
            COLUMNS,
            _time_faults,
            most_rows=MAX_MEASURED_ROWS,
            gaps=True,
        )
    except PydanticCustomError as error:
        # What follows is for a spec, which can say where the columns are.
        told = "; ".join(_without_spec_hint(fault.message) for fault in faults_of(error))
        end = "" if told.endswith("?") else "."
        raise UsageError(f"{told}{end} A table to compare has the columns {HEADERS}") from None
    return table.values


def _without_gaps(rows: np.ndarray) -> tuple[np.ndarray, str]:
    """The rows that are whole, and what to say of the others."""
    whole = np.isfinite(rows).all(axis=1)
    kept = rows[whole]
    if whole.all() or len(kept) < 2:
        return kept, ""
    gap = float(np.diff(kept[:, 0]).max())
    missing = len(rows) - len(kept)
    return kept, (
        f"{missing:,} of {len(rows):,} rows lack x or z and are left out; it is interpolated over "
        f"up to {gap:.3g} s"
    )


def motion_of_rows(label: str, rows: np.ndarray, source: str = "") -> ComparedMotion:
    """The motion of rows (T, 3): time [s], x and z of the tip [m]."""
    time, tip = rows[:, 0].copy(), rows[:, 1:].copy()
    return ComparedMotion(
        label=label,
        origin="table",
        source=source,
        time=time,
        tip=tip,
        metrics=tip_metrics(time, tip),
        error_words="none stated, a table",
    )


def tip_metrics(time: np.ndarray, tip: np.ndarray, period: float | None = None) -> dict[str, float]:
    """Metrics of a tip (T, 2) alone, NaN where one is of pressures."""
    return metric_values(MetricInputs(time, tip, np.zeros_like(tip), (), period))


def _without_spec_hint(message: str) -> str:
    for words in (" Or write columns:", " Choose one, as in columns:", "; name the columns in its"):
        message = message.partition(words)[0]
    return message.rstrip(".")


def _time_faults(time: np.ndarray) -> Iterator[tuple[int, str]]:
    for k in np.flatnonzero(~np.isfinite(time)):
        yield int(k), f"time is {time[k]:g}"
    for k in np.flatnonzero(time[1:] <= time[:-1]) + 1:
        yield int(k), f"times must increase; got {time[k]:g} s after {time[k - 1]:g} s"
