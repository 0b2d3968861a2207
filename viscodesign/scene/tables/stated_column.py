"""The column of a file that a spec names, by its header or its number."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.errors import described, did_you_mean
from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.tables.columns import ChosenColumn, Header, WantedColumn
from viscodesign.scene.tables.contradictions import refuse_other_quantity, refuse_other_unit
from viscodesign.scene.tables.header_units import HeaderUnit, header_unit, unit_factor


def stated_column(
    wanted: WantedColumn, all_wanted: Sequence[WantedColumn], header: Header, given: Any
) -> ChosenColumn:
    """The column that the spec names, by its header or its number from 1."""
    keys = given if isinstance(given, Mapping) else {"column": given}
    column, unit = keys.get("column"), keys.get("unit")
    is_known = set(keys) <= {"column", "unit"}
    if not isinstance(column, (int, str)) or isinstance(column, bool) or not is_known:
        raise invalid_at(
            "columns",
            f"{wanted.name}: expected a header, a number from 1, or "
            f"{{column: ..., unit: ...}}; got {described(given)}",
        )
    written = header_unit(column, wanted.kind) if isinstance(column, str) else None
    if written is not None and unit is None and written.name in _names(header):
        column, unit = written.name, column.removeprefix(written.name).strip("[]()/,_ ")
    place = _place_of(wanted, header, column)
    text = header.cells[place].strip() if header.cells else f"column {place + 1}"
    others = {name: c.kind for c in all_wanted if c.kind != wanted.kind for name in c.names}
    refuse_other_quantity(wanted.name, text, wanted.kind, others, unit is not None)
    own = header_unit(text, wanted.kind) or HeaderUnit(text, 1.0)
    if unit is not None:
        factor, reference = _stated_unit(wanted, unit)
        refuse_other_unit(wanted.name, text, wanted.kind, str(unit), factor, reference)
        return ChosenColumn(place, text, factor, reference or own.reference)
    return ChosenColumn(place, text, own.factor, own.reference, wanted.is_of_run(text))


def _place_of(wanted: WantedColumn, header: Header, column: int | str) -> int:
    if isinstance(column, int):
        if 1 <= column <= header.count:
            return column - 1
        raise invalid_at(
            "columns",
            f"{wanted.name}: {header.shown} has columns 1 to {header.count}; got {column}",
        )
    names = _names(header)
    own = [header_unit(cell, wanted.kind) for cell in names]
    bare = [unit.name if unit else cell for unit, cell in zip(own, names, strict=True)]
    for candidates in (names, bare):
        places = [k for k, name in enumerate(candidates) if name == column.strip()]
        if len(places) == 1:
            return places[0]
    several = "several columns" if column.strip() in bare else "no column"
    raise invalid_at(
        "columns",
        f"{wanted.name}: {header.shown} has {several} '{column}'"
        f"{did_you_mean(column, names)}; {_listed(header)}",
    )


def _names(header: Header) -> list[str]:
    return [cell.strip() for cell in header.cells]


def _stated_unit(wanted: WantedColumn, unit: Any) -> tuple[float, str]:
    text = str(unit).strip()
    factor, reference = unit_factor(text, wanted.kind)
    if factor is not None:
        return factor, reference
    try:
        return wanted.kind.parse(f"1 {text}"), ""
    except PydanticCustomError as error:
        message = (error.context or {})["message"]
        raise invalid_at("columns", f"{wanted.name}: unit {message}") from None


def _listed(header: Header) -> str:
    cells = ", ".join(f"'{cell.strip()[:40]}'" for cell in header.cells[:12])
    return f"its columns are {cells}" if cells else f"it has no header, but {header.count} columns"
