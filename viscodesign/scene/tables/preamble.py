"""Headers below what an instrument writes above a table, and units in a line of their own."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import get_args

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.tables.cells import COMMENT_SIGNS, delimiter_of, is_numeric, lines_of, split
from viscodesign.scene.tables.header_units import header_unit, unit_factor
from viscodesign.units import Angle, Length, Pressure, Time, Volume

MAX_LINES = 200
"""Lines above the first number that are looked through."""
KINDS = tuple(get_args(alias)[1] for alias in (Time, Pressure, Length, Angle, Volume))
"""Quantities that a column may have."""
NO_UNIT = ("", "-", "1")


@dataclass(frozen=True)
class HeaderBelow:
    """The header of a table that does not begin with it."""

    cells: tuple[str, ...]
    line: int
    """Its number in the file."""
    end: int
    """Place behind it in the text."""
    delimiter: str


def says_units(cells: Sequence[str]) -> bool:
    """Whether a header names the unit of any quantity."""
    return any(header_unit(cell, kind) is not None for cell in cells for kind in KINDS)


def header_below(text: str) -> HeaderBelow | None:
    """The lines of names (and of units) right above the first line of numbers, if these are not
    the first lines of all; names and units as one header.
    """
    above: list[tuple[int, str]] = []
    for number, (start, end) in enumerate(islice(lines_of(text), MAX_LINES), start=1):
        line = text[start:end].strip()
        if not line or line.startswith(COMMENT_SIGNS):
            continue
        if is_numeric(split(line, delimiter_of(line))):
            return _named(above, start)
        above.append((number, line))
    return None


def _named(above: list[tuple[int, str]], end: int) -> HeaderBelow | None:
    if len(above) < 2:
        return None
    (_, line_before), (number, line) = above[-2:]
    delimiter = delimiter_of(line)
    cells, before = split(line, delimiter), split(line_before, delimiter)
    if len(cells) < 2 or any(is_numeric([cell]) for cell in cells if cell.strip()):
        return None
    if len(before) == len(cells) and all(map(_is_unit, cells)):
        cells = [_with_unit(name, unit) for name, unit in zip(before, cells, strict=True)]
    return HeaderBelow(tuple(cells), number, end, delimiter)


def _is_unit(cell: str) -> bool:
    unit = cell.strip().strip("[]()").strip()
    return unit in NO_UNIT or any(unit_factor(unit, kind)[0] is not None for kind in KINDS)


def _with_unit(name: str, unit: str) -> str:
    bare = unit.strip().strip("[]()").strip()
    return name.strip() if bare in NO_UNIT else f"{name.strip()} [{bare}]"
