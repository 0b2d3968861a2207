"""CSV tables of numbers; every fault names the file and the line."""

from __future__ import annotations

import csv
import io
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationInfo

from viscodesign.errors import did_you_mean
from viscodesign.scene.spec_part import KeyFault, invalid, invalid_at, raise_faults

RowCheck = Callable[[Sequence[float]], Iterator[tuple[int, str]]]
"""Finds the rows in which a table's first column is invalid: (index, message)."""
MAX_FILE_BYTES = 64 << 20
MAX_ROWS = 50_000
"""A resolved spec lists all rows and should stay small enough for an editor."""


def with_rows(
    given: Any,
    info: ValidationInfo,
    columns: Sequence[str],
    check: RowCheck,
    owner: str,
    others: Sequence[str] = (),
) -> Any:
    """A mapping with its 'file' replaced by 'rows'; anything but a mapping is returned as it is.

    The ``owner`` ('a table') needs exactly one of 'file', 'rows' and ``others``.
    """
    if not isinstance(given, dict):
        return given
    *first, last = ("file", "rows", *others)
    if sum(key in given for key in (*first, last)) != 1:
        words = ", ".join(f"'{key}'" for key in first)
        raise invalid(f"{owner} needs exactly one of {words} and '{last}'")
    if not isinstance(given.get("file", ""), str):
        raise invalid_at("file", "expected the name of a CSV file, such as 'table.csv'")
    if "file" not in given:
        return given
    folder = (info.context or {}).get("folder", Path())
    rest = {key: value for key, value in given.items() if key != "file"}
    return {**rest, "rows": read_table(folder / given["file"], given["file"], columns, check)}


def check_rows(rows: Sequence[tuple[float, ...]], check: RowCheck) -> None:
    """Raise a fault for too few or too many rows, or an invalid first column."""
    if len(rows) < 2 or len(rows) > MAX_ROWS:
        raise invalid_at("rows", _row_count_fault(len(rows)))
    raise_faults(
        KeyFault(("rows", str(k)), f"row {k + 1}: {found}")
        for k, found in check([row[0] for row in rows])
    )


def read_table(
    path: Path, shown: str, columns: Sequence[str], check: RowCheck
) -> list[tuple[float, ...]]:
    """Rows of the file that the spec calls ``shown``, whose header is ``columns``."""
    text = _text(path, shown)
    try:
        lines = list(csv.reader(io.StringIO(text)))
    except csv.Error as error:
        raise invalid_at("file", f"{shown} is not a CSV file: {error}") from error
    _check_header(lines[0] if lines else [], columns, shown)
    numbered = [(k, cells) for k, cells in enumerate(lines[1:], start=2) if cells]
    raise_faults(
        _located(shown, k, found) for k, cells in numbered for found in _bad_cells(cells, columns)
    )
    rows = [tuple(float(cell) for cell in cells) for _, cells in numbered]
    first = [row[0] for row in rows]
    raise_faults(_located(shown, numbered[k][0], found) for k, found in check(first))
    if len(rows) < 2 or len(rows) > MAX_ROWS:
        raise invalid_at("file", f"{shown}: {_row_count_fault(len(rows))}")
    return rows


def time_faults(times: Sequence[float]) -> Iterator[tuple[int, str]]:
    """Rows where time decreases; two rows at the same time are a jump, which is legal."""
    if times and times[0] < 0:
        yield 0, f"time is {times[0]:g} s, before the start at 0 s"
    for k, (before, after) in enumerate(itertools.pairwise(times), start=1):
        if after < before:
            yield k, f"time decreases from {before:g} s to {after:g} s"
        elif k > 1 and times[k - 2] == before == after:
            yield k, f"third row at {after:g} s; a jump has two rows"


def pressure_faults(pressures: Sequence[float]) -> Iterator[tuple[int, str]]:
    """Rows with the same pressure as the row before."""
    for k, (before, after) in enumerate(itertools.pairwise(pressures), start=1):
        if after == before:
            yield k, f"the pressure {after:g} Pa is that of the row before"


def _row_count_fault(count: int) -> str:
    """The message for too few or too many rows."""
    return f"must have from 2 to {MAX_ROWS} rows; got {count}"


def _text(path: Path, shown: str) -> str:
    try:
        with path.open("rb") as file:
            content = file.read(MAX_FILE_BYTES + 1)
        if len(content) > MAX_FILE_BYTES:
            raise invalid_at("file", f"{shown} is larger than {MAX_FILE_BYTES >> 20} MiB")
        return content.decode("utf-8-sig")
    except (OSError, ValueError) as error:  # ValueError: not UTF-8, or a NUL in the name
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        raise invalid_at("file", f"{shown} cannot be read: {reason} (looked for {path})") from error


def _check_header(cells: list[str], columns: Sequence[str], shown: str) -> None:
    header = [cell.strip() for cell in cells]
    if header != list(columns):
        missing = [column for column in columns if column not in header]
        hints = "".join(did_you_mean(cell, missing) for cell in header if cell not in columns)
        given = ",".join(header)[:80]
        raise invalid_at(
            "file", f"{shown}, line 1: expected '{','.join(columns)}', got '{given}'{hints}"
        )


def _bad_cells(cells: list[str], columns: Sequence[str]) -> Iterator[str]:
    if len(cells) != len(columns):
        yield f"expected {len(columns)} values, got {len(cells)}"
        return
    for column, cell in zip(columns, cells, strict=True):
        if not cell.strip():
            yield f"{column} is empty"
            continue
        try:
            value = float(cell)
        except ValueError:
            yield f"{column} is '{cell[:40]}', not a number"
            continue
        if not math.isfinite(value):
            yield f"{column} is {cell.strip()}, not finite"


def _located(shown: str, line: int, message: str) -> KeyFault:
    return KeyFault(("file",), f"{shown}, line {line}: {message}")
