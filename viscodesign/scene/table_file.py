"""A CSV of numbers; every fault names the file and the line."""

from __future__ import annotations

import csv
import io
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationInfo

from viscodesign.scene.section import Complaint, did_you_mean, refuse, refuse_any, refuse_at

Order = Callable[[Sequence[float]], Iterator[tuple[int, str]]]
"""Finds the places where a table's first column is out of order."""
LARGEST_FILE = 64 << 20
MOST_ROWS = 50_000
"""A resolved spec lists its rows, and has to stay a text that one can open."""


def with_rows(
    given: Any,
    info: ValidationInfo,
    columns: Sequence[str],
    order: Order,
    owner: str,
    others: Sequence[str] = (),
) -> Any:
    """A mapping whose 'file' is replaced by its 'rows'; what is no mapping stays.

    Of 'file', 'rows' and ``others`` the ``owner`` ('a table') needs just one.
    """
    if not isinstance(given, dict):
        return given
    *first, last = ("file", "rows", *others)
    if sum(key in given for key in (*first, last)) != 1:
        words = ", ".join(f"'{key}'" for key in first)
        raise refuse(f"{owner} needs one of {words} and '{last}'")
    if not isinstance(given.get("file", ""), str):
        raise refuse_at("file", "the name of a CSV file is wanted, like 'table.csv'")
    if "file" not in given:
        return given
    folder = (info.context or {}).get("folder", Path())
    rest = {key: value for key, value in given.items() if key != "file"}
    return {**rest, "rows": read_table(folder / given["file"], given["file"], columns, order)}


def refuse_rows(rows: Sequence[tuple[float, ...]], order: Order) -> None:
    """Raise a fault for too few or too many rows, or rows out of order."""
    if len(rows) < 2 or len(rows) > MOST_ROWS:
        raise refuse_at("rows", row_count(len(rows)))
    refuse_any(
        Complaint(("rows", str(k)), f"row {k + 1}: {found}")
        for k, found in order([row[0] for row in rows])
    )


def read_table(
    path: Path, shown: str, columns: Sequence[str], order: Order
) -> list[tuple[float, ...]]:
    """Rows of the file that the spec calls ``shown``, whose header is ``columns``."""
    text = _text(path, shown)
    try:
        lines = list(csv.reader(io.StringIO(text)))
    except csv.Error as error:
        raise refuse_at("file", f"{shown} is not a CSV: {error}") from error
    _check_header(lines[0] if lines else [], columns, shown)
    numbered = [(k, cells) for k, cells in enumerate(lines[1:], start=2) if cells]
    refuse_any(
        _faults(shown, k, found) for k, cells in numbered for found in _bad_cells(cells, columns)
    )
    rows = [tuple(float(cell) for cell in cells) for _, cells in numbered]
    first = [row[0] for row in rows]
    refuse_any(_faults(shown, numbered[k][0], found) for k, found in order(first))
    if len(rows) < 2 or len(rows) > MOST_ROWS:
        raise refuse_at("file", f"{shown}: {row_count(len(rows))}")
    return rows


def disorder(times: Sequence[float]) -> Iterator[tuple[int, str]]:
    """Places where time does not run on; two rows at one time are a jump, and legal."""
    if times and times[0] < 0:
        yield 0, f"time is {times[0]:g} s, before the start at 0"
    for k, (before, after) in enumerate(itertools.pairwise(times), start=1):
        if after < before:
            yield k, f"time runs back from {before:g} s to {after:g} s"
        elif k > 1 and times[k - 2] == before == after:
            yield k, f"time {after:g} s stands a third time; a jump takes two rows"


def standing(pressures: Sequence[float]) -> Iterator[tuple[int, str]]:
    """Places where pressure stands still from row to row."""
    for k, (before, after) in enumerate(itertools.pairwise(pressures), start=1):
        if after == before:
            yield k, f"pressure {after:g} Pa is that of the row before it"


def row_count(count: int) -> str:
    """What is wrong with so many rows."""
    return f"{count} rows; a table needs at least two, and at most {MOST_ROWS} are allowed"


def _text(path: Path, shown: str) -> str:
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
        if len(content) > LARGEST_FILE:
            raise refuse_at("file", f"{shown} is larger than {LARGEST_FILE >> 20} MiB")
        return content.decode("utf-8-sig")
    except (OSError, ValueError) as error:  # ValueError: not UTF-8, or a NUL in the name
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        raise refuse_at("file", f"{shown} cannot be read: {reason} (looked for {path})") from error


def _check_header(cells: list[str], columns: Sequence[str], shown: str) -> None:
    header = [cell.strip() for cell in cells]
    if header != list(columns):
        missing = [column for column in columns if column not in header]
        hints = "".join(did_you_mean(cell, missing) for cell in header if cell not in columns)
        given = ",".join(header)[:80]
        raise refuse_at(
            "file", f"{shown}, line 1 is '{given}'; '{','.join(columns)}' is wanted{hints}"
        )


def _bad_cells(cells: list[str], columns: Sequence[str]) -> Iterator[str]:
    if len(cells) != len(columns):
        yield f"{len(cells)} values; {len(columns)} are wanted"
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


def _faults(shown: str, line: int, message: str) -> Complaint:
    return Complaint(("file",), f"{shown}, line {line}: {message}")
