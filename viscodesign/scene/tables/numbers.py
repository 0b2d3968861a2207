"""The numbers of a table: by numpy's reader where it is plain, cell by cell where it is not."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterator, Sequence
from typing import Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import KeyFault, invalid_at, raise_faults
from viscodesign.scene.tables.cells import SPACES
from viscodesign.scene.tables.layout import NUMBER, TableText

Decimal = Literal["point", "comma"]
_COMMA_NUMBER = re.compile(r"[-+]?[0-9]*,[0-9]+(?:[eE][-+]?[0-9]+)?", re.ASCII)
_THOUSANDS = re.compile(r"[-+]?[1-9][0-9]{0,2},[0-9]{3}", re.ASCII)
GAPS = ("", "nan", "na", "n/a", "-", "--")
"""Cells that say that nothing was measured."""
_SURELY_DECIMAL = re.compile(r"(?<![0-9])(?:0?|[0-9]{4,}),[0-9]|,[0-9]{1,2}(?![0-9])|,[0-9]{4}")
"""A comma that cannot group thousands."""


@dataclass(frozen=True, eq=False)
class TableNumbers:
    """Numbers of some columns, and where they stand."""

    values: np.ndarray
    """(n, c)"""
    lines: Callable[[], list[int]]
    """The line of every row in the file."""


def read_numbers(
    text: TableText,
    places: Sequence[int],
    names: Sequence[str],
    shown: str,
    decimal: Decimal | None,
    *,
    gaps: bool = False,
) -> TableNumbers:
    """Numbers (n, c) in the columns ``places``, called ``names`` in faults.

    ``decimal`` is the sign that the spec states. With ``gaps``, cells that are empty or say so
    (nan) are NaN, but for those of the first column. Raises faults that name file and line.
    """
    values = _at_once(text, places, decimal)
    if values is not None:
        return TableNumbers(values, _CellReader(text, shown).lines)
    return _CellReader(text, shown, gaps).numbers(places, names, decimal)


def _at_once(text: TableText, places: Sequence[int], decimal: Decimal | None) -> np.ndarray | None:
    """All numbers by numpy's reader; None for a table that needs a closer look."""
    body = text.body
    if '"' in body or not body.strip():
        return None
    if text.delimiter != "," and "," in body:
        is_decimal = decimal == "comma" or (decimal is None and _SURELY_DECIMAL.search(body))
        if not is_decimal or "." in body:
            return None
        body = body.replace(",", ".")
    elif decimal == "comma" and "." in body:
        return None
    try:
        found = np.loadtxt(
            io.StringIO(body),
            delimiter=None if text.delimiter == SPACES else text.delimiter,
            usecols=places,
            comments=None,
            ndmin=2,
        )
    except ValueError:
        return None
    if text.delimiter == SPACES:
        cells = len(body.split())
    else:
        cells = body.count(text.delimiter) + len(found)
    is_whole = cells == text.columns * len(found) and np.all(np.isfinite(found))
    return found if is_whole else None


@dataclass(frozen=True)
class _CellReader:
    """Reads cell by cell, for odd tables and for messages."""

    text: TableText
    shown: str
    gaps: bool = False

    def numbers(
        self, places: Sequence[int], names: Sequence[str], decimal: Decimal | None
    ) -> TableNumbers:
        """Numbers (n, c); raises a fault for every cell that has none."""
        rows = list(self._rows())
        mark = self._decimal_mark(rows, places, decimal)
        raise_faults(
            KeyFault(("file",), f"{self.shown}, line {line}: {found}")
            for line, cells in rows
            for found in self._bad_cells(cells, places, names, mark)
        )
        values = [
            [self._value(cells[place].strip(), mark) for place in places] for _, cells in rows
        ]
        lines = [line for line, _ in rows]
        return TableNumbers(np.array(values).reshape(-1, len(places)), lambda: lines)

    def _value(self, cell: str, mark: str) -> float:
        return math.nan if self.gaps and _is_gap(cell) else float(_pointed(cell, mark))

    def lines(self) -> list[int]:
        """The line of every row."""
        return [line for line, _ in self._rows()]

    def _rows(self) -> Iterator[tuple[int, list[str]]]:
        """Lines with their cells, without those that are empty."""
        text = self.text
        before = text.first_line - 1
        if text.delimiter == SPACES:
            lines = enumerate((line.split() for line in text.body.split("\n")), start=1)
            yield from ((before + k, cells) for k, cells in lines if cells)
            return
        reader = csv.reader(io.StringIO(text.body, newline=""), delimiter=text.delimiter)
        try:
            for cells in reader:
                if any(cell.strip() for cell in cells):
                    while len(cells) > text.columns and not cells[-1].strip():
                        cells.pop()  # a delimiter at the end of every line
                    yield before + reader.line_num, cells
        except csv.Error as error:
            raise invalid_at("file", f"{self.shown} is not a CSV file: {error}") from error

    def _decimal_mark(
        self,
        rows: Sequence[tuple[int, list[str]]],
        places: Sequence[int],
        decimal: Decimal | None,
    ) -> str:
        """The decimal sign of all numbers; refuses what may be read in two ways."""
        used = ((line, cells[p].strip()) for line, cells in rows for p in places if p < len(cells))
        commas = [(line, cell) for line, cell in used if "," in cell]
        if decimal is not None or not commas:
            return "," if decimal == "comma" else "."
        pointed = next(
            (cells[p] for _, cells in rows for p in places if p < len(cells) and "." in cells[p]),
            None,
        )
        line, cell = commas[0]
        if pointed is not None and _COMMA_NUMBER.fullmatch(cell):
            self._refuse_mark(line, f"'{cell[:40]}' has a comma, '{pointed.strip()[:40]}' a point")
        if all(_THOUSANDS.fullmatch(cell) for _, cell in commas):
            bare = cell.replace(",", "")
            self._refuse_mark(line, f"'{cell}' may be {_pointed(cell, ',')} or {bare}")
        return ","

    def _refuse_mark(self, line: int, problem: str) -> None:
        raise invalid_at(
            "file",
            f"{self.shown}, line {line}: {problem}; write 'decimal: comma' if commas are decimal "
            "signs, or numbers without separators of thousands",
        )

    def _bad_cells(
        self, cells: list[str], places: Sequence[int], names: Sequence[str], mark: str
    ) -> Iterator[str]:
        if len(cells) != self.text.columns:
            yield f"expected {self.text.columns} values, got {len(cells)}{self._reason(cells)}"
            return
        for place, name in zip(places, names, strict=True):
            cell = cells[place].strip()
            if self.gaps and place != places[0] and _is_gap(cell):
                continue
            if not cell:
                yield f"{name} is empty"
            elif NUMBER.fullmatch(_pointed(cell, mark)) is None:
                if cell.lower().lstrip("+-") in ("nan", "inf", "infinity"):
                    yield f"{name} is {cell}, not finite"
                else:
                    yield f"{name} is '{cell[:40]}', not a number"
            elif not np.isfinite(float(_pointed(cell, mark))):
                yield f"{name} is {cell[:40]}, not finite"

    def _reason(self, cells: list[str]) -> str:
        """Why a line may have other columns than its table."""
        if self.text.delimiter == "," and len(cells) == 2 * self.text.columns:
            return "; a table with decimal commas needs semicolons or tabs between its columns"
        return ""


def _is_gap(cell: str) -> bool:
    return cell.lower() in GAPS


def _pointed(cell: str, mark: str) -> str:
    """A number with a decimal point; one with both signs stays what it is, no number."""
    return cell.replace(",", ".") if mark == "," and "." not in cell else cell
