"""Tables of numbers that a spec lists or reads from a file; every fault names the line."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

import numpy as np
from pydantic import Field, ValidationInfo

from viscodesign.errors import described, did_you_mean, not_among
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, invalid_at, raise_faults
from viscodesign.scene.tables.chosen_columns import chosen_columns
from viscodesign.scene.tables.columns import ChosenColumn, Header, WantedColumn
from viscodesign.scene.tables.layout import TableText, taken_apart
from viscodesign.scene.tables.numbers import Decimal, read_numbers

RowCheck = Callable[[np.ndarray], Iterator[tuple[int, str]]]
"""Finds the rows in which a table's first column (n,) is invalid: (index, message)."""
MAX_FILE_BYTES = 512 << 20
MAX_ROWS = 50_000
"""A resolved spec lists all rows and should stay small enough for an editor."""
FILE_KEYS = ("file", "columns", "decimal")
DECIMALS: tuple[Decimal, ...] = ("point", "comma")


class FromFile(SpecPart):
    """A part of a spec whose rows may stand in a file."""

    file: str | None = Field(
        None, description="Table as text, with columns of what `rows` holds; relative to the spec"
    )
    columns: dict[str, str | int | dict[str, str | int]] | None = Field(
        None,
        description="Columns of the file: its header, its number, or {column: ..., unit: ...}; "
        "default: found by names and units",
    )
    decimal: Literal["point", "comma"] | None = Field(
        None, description="Decimal sign of the file; default: found"
    )


@dataclass(frozen=True, eq=False)
class FileTable:
    """What a file holds."""

    values: np.ndarray
    """(n, c) in SI."""
    columns: tuple[ChosenColumn, ...]


def with_rows(
    given: Any,
    info: ValidationInfo,
    columns: Sequence[WantedColumn],
    check: RowCheck,
    owner: str,
    others: Sequence[str] = (),
) -> Any:
    """A mapping with its 'file' replaced by 'rows'; anything but a mapping is returned as it is.

    The ``owner`` ('a table') needs exactly one of 'file', 'rows' and ``others``.
    """
    if not isinstance(given, dict):
        return given
    require_one_source(given, owner, others)
    if given.get("file") is None:
        return given
    folder = (info.context or {}).get("folder", Path())
    table = table_of_file(given, folder, columns, check, most_rows=MAX_ROWS)
    rest = {key: value for key, value in given.items() if key not in FILE_KEYS}
    return {**rest, "rows": list(map(tuple, table.values.tolist()))}


def require_one_source(given: Mapping[str, Any], owner: str, others: Sequence[str] = ()) -> None:
    """Raise a fault unless a mapping has exactly one of 'file', 'rows' and ``others``."""
    *first, last = ("file", "rows", *others)
    if sum(key in given for key in (*first, last)) != 1:
        words = ", ".join(f"'{key}'" for key in first)
        raise invalid(f"{owner} needs exactly one of {words} and '{last}'")
    for key in FILE_KEYS[1:]:
        if given.get(key) is not None and "file" not in given:
            raise invalid_at(key, "describes a file, and there is none; remove it")


def table_of_file(
    given: Mapping[str, Any],
    folder: Path,
    columns: Sequence[WantedColumn],
    check: RowCheck,
    *,
    most_rows: int,
    inlet: str = "",
    gaps: bool = False,
) -> FileTable:
    """The table that the keys of a spec describe; ``inlet`` is the name of the input it is for.

    With ``gaps`` cells that are empty are NaN, but not those of the first column.
    """
    shown, decimal, stated = given["file"], given.get("decimal"), given.get("columns")
    if not isinstance(shown, str):
        raise invalid_at("file", "expected the name of a CSV file, such as 'table.csv'")
    if decimal is not None and decimal not in DECIMALS:
        raise invalid_at("decimal", not_among(decimal, DECIMALS))
    if stated is not None and not isinstance(stated, Mapping):
        raise invalid_at(
            "columns",
            f"expected a mapping such as {{time: Time, pressure: P1}}; got {described(stated)}",
        )
    text = taken_apart(text_of_file(folder / shown, shown))
    header = Header(f"{shown}, line {text.header_line}", text.header, text.columns)
    chosen = chosen_columns(columns, header, stated or {}, inlet)
    return _read(text, chosen, check, shown, decimal, most_rows, gaps)


def _read(
    text: TableText,
    chosen: Sequence[ChosenColumn],
    check: RowCheck,
    shown: str,
    decimal: Decimal | None,
    most_rows: int,
    gaps: bool,
) -> FileTable:
    places, names = [c.place for c in chosen], [c.header for c in chosen]
    found = read_numbers(text, places, names, shown, decimal, gaps=gaps)
    values = np.stack(
        [_scaled(v, c.factor) for v, c in zip(found.values.T, chosen, strict=True)], 1
    )
    if faults := list(check(values[:, 0])):
        lines = found.lines()
        raise_faults(
            KeyFault(("file",), f"{shown}, line {lines[k]}: {message}") for k, message in faults
        )
    if not 2 <= len(values) <= most_rows:
        raise invalid_at("file", f"{shown}: {_row_count_fault(len(values), most_rows)}")
    return FileTable(values, tuple(chosen))


def _scaled(values: np.ndarray, factor: float) -> np.ndarray:
    """In SI; milliseconds are divided by 1000, which rounds as decimal text would."""
    inverse = round(1 / factor)
    return values / inverse if factor < 1.0 and inverse * factor == 1.0 else values * factor


def check_rows(rows: Sequence[tuple[float, ...]], check: RowCheck) -> None:
    """Raise a fault for too few or too many rows, or an invalid first column."""
    if len(rows) < 2 or len(rows) > MAX_ROWS:
        raise invalid_at("rows", _row_count_fault(len(rows), MAX_ROWS))
    raise_faults(
        KeyFault(("rows", str(k)), f"row {k + 1}: {found}")
        for k, found in check(np.array([row[0] for row in rows]))
    )


def time_faults(times: np.ndarray) -> Iterator[tuple[int, str]]:
    """Rows where time decreases; two rows at the same time are a jump, which is legal."""
    if len(times) and times[0] < 0:
        yield 0, f"time is {times[0]:g} s, before the start at 0 s"
    for k in np.flatnonzero(times[1:] < times[:-1]) + 1:
        yield int(k), f"time decreases from {times[k - 1]:g} s to {times[k]:g} s"
    for k in np.flatnonzero(times[:-2] == times[1:-1]) + 2:
        if times[k] == times[k - 1]:
            yield int(k), f"third row at {times[k]:g} s; a jump has two rows"


def pressure_faults(pressures: np.ndarray) -> Iterator[tuple[int, str]]:
    """Rows with the same pressure as the row before."""
    for k in np.flatnonzero(pressures[1:] == pressures[:-1]) + 1:
        yield int(k), f"the pressure {pressures[k]:g} Pa is that of the row before"


def _row_count_fault(count: int, most: int) -> str:
    """The message for too few or too many rows."""
    return f"must have from 2 to {most} rows; got {count}"


def text_of_file(path: Path, shown: str) -> str:
    """The text of a file with plain line ends."""
    try:
        with path.open("rb") as file:
            content = file.read(MAX_FILE_BYTES + 1)
        if len(content) > MAX_FILE_BYTES:
            raise invalid_at("file", f"{shown} is larger than {MAX_FILE_BYTES >> 20} MiB")
        text = _decoded(content)
    except (OSError, ValueError) as error:  # ValueError: no text, or a NUL in the name
        reason = error.strerror if isinstance(error, OSError) else "not text"
        raise invalid_at(
            "file", f"{shown} cannot be read: {reason}{_place(path, shown)}"
        ) from error
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def _place(path: Path, shown: str) -> str:
    """Where a file was looked for, unless its name says so, and a file there that may be meant."""
    beside = path.parent
    names = [file.name for file in beside.iterdir()] if beside.is_dir() else []
    place = f" (looked for {path})" if str(path) != shown else ""
    return place + ("" if path.name in names else did_you_mean(path.name, names))


def _decoded(content: bytes) -> str:
    """UTF-8, UTF-16 by its mark, or else the Windows code page that old loggers write."""
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16")
    if b"\x00" in content:
        raise ValueError("binary")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252")
