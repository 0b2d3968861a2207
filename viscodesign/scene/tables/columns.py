"""Selection of the columns of a file: by the spec, by their names, or by their units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

from pydantic_core import PydanticCustomError

from viscodesign.errors import described, did_you_mean
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.tables.contradictions import (
    refuse_other_quantity,
    refuse_other_unit,
    refuse_shared,
)
from viscodesign.scene.tables.header_units import (
    HeaderUnit,
    header_unit,
    unclear_unit,
    unit_factor,
)
from viscodesign.units import QuantityKind


@dataclass(frozen=True)
class WantedColumn:
    """A column that a table must have."""

    name: str
    kind: QuantityKind
    words: tuple[str, ...] = ()
    """Other names that it has in headers, in lower case."""

    @property
    def names(self) -> tuple[str, ...]:
        """All names that it may have in headers, in lower case."""
        return (self.name, *self.words)

    @property
    def header(self) -> str:
        """The header that is never ambiguous: name and SI unit."""
        return f"{self.name}_{self.unit_word}"

    @property
    def unit_word(self) -> str:
        """The SI unit as the last word of a header."""
        return self.kind.unit.lower().replace("^", "")


@dataclass(frozen=True)
class ChosenColumn:
    """Where a wanted column stands in a file, and what its numbers are."""

    place: int
    header: str
    factor: float
    reference: str = ""
    """Reference of a pressure: ``gauge``, ``abs`` or not said."""
    has_baseline: bool = False
    """Whether the scene's baseline is part of the numbers, as in the tables that a run writes."""


@dataclass(frozen=True)
class Header:
    """The header of a file, as its messages call it; without cells where there is none."""

    shown: str
    cells: tuple[str, ...]
    count: int
    """Columns of the file."""


def chosen_columns(
    wanted: Sequence[WantedColumn], header: Header, given: Mapping[str, Any], inlet: str
) -> list[ChosenColumn]:
    """The wanted columns; ``given`` is the spec's `columns`, ``inlet`` the name of the input."""
    for name in given:
        known = [column.name for column in wanted]
        if name not in known:
            raise invalid_at(
                "columns",
                f"'{name}' is not a column of this table{did_you_mean(name, known)}; "
                f"the columns are {', '.join(known)}",
            )
    found = [
        _stated(column, wanted, header, given[column.name])
        if column.name in given
        else _found(column, wanted, header, inlet)
        for column in wanted
    ]
    refuse_shared([(own.place, own.header) for own in found], [w.name for w in wanted])
    return found


# -- as the spec says ---------------------------------------------------------------------


def _stated(
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
    return ChosenColumn(place, text, own.factor, own.reference, _is_of_run(text, wanted))


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


# -- by names and units -------------------------------------------------------------------


def _found(
    wanted: WantedColumn, all_wanted: Sequence[WantedColumn], header: Header, inlet: str
) -> ChosenColumn:
    """The only column that can be meant."""
    cells = [cell.strip() for cell in header.cells]
    own = (wanted.header, *_headers_of_run(wanted, inlet))
    for name in own:
        if cells.count(name) == 1:
            return ChosenColumn(cells.index(name), name, 1.0, "", name != wanted.header)
    fitting = {k: unit for k, cell in enumerate(cells) if (unit := header_unit(cell, wanted.kind))}
    is_alone = _is_alone(wanted, all_wanted)
    if not is_alone or (len(fitting) > 1 and wanted.kind.unit == "s"):
        named = [k for k, unit in fitting.items() if _is_named(wanted, unit.name)]
        fitting = {k: fitting[k] for k in named} if len(named) == 1 or not is_alone else fitting
    if len(fitting) == 1:
        place, unit = next(iter(fitting.items()))
        return ChosenColumn(
            place, cells[place], unit.factor, unit.reference, _is_of_run(cells[place], wanted)
        )
    if fitting:
        _refuse_several(wanted, header, [cells[k] for k in fitting])
    return _refuse_none(wanted, all_wanted, header, cells)


def _is_alone(wanted: WantedColumn, all_wanted: Sequence[WantedColumn]) -> bool:
    """Whether its unit tells it; of several columns with one unit, names have to."""
    return sum(other.kind.unit == wanted.kind.unit for other in all_wanted) == 1


def _is_named(wanted: WantedColumn, name: str) -> bool:
    return name.lower() in wanted.names


def _headers_of_run(wanted: WantedColumn, inlet: str) -> tuple[str, ...]:
    """Columns of `trajectory.csv` and `record.csv`, which hold the baseline already."""
    if wanted.name != "pressure":
        return ()
    return ("inlet_pressure_pa", f"inlet_pressure_{inlet}_pa")


def _is_of_run(header: str, wanted: WantedColumn) -> bool:
    is_of_run = header.startswith("inlet_pressure_") and header.endswith("_pa")
    return wanted.name == "pressure" and is_of_run


def _refuse_several(wanted: WantedColumn, header: Header, cells: list[str]) -> NoReturn:
    listed = ", ".join(f"'{cell[:40]}'" for cell in cells[:8])
    raise invalid_at(
        "file",
        f"{header.shown} has {len(cells)} columns that may be the {wanted.name}: {listed}. Choose "
        f'one, as in columns: {{{wanted.name}: "{cells[0][:40]}"}}',
    )


def _refuse_none(
    wanted: WantedColumn, all_wanted: Sequence[WantedColumn], header: Header, cells: list[str]
) -> NoReturn:
    expected = ",".join(column.header for column in all_wanted)
    given = ",".join(cells)[:80]
    bare = next((cell for cell in cells if _is_named(wanted, cell)), None)
    if not header.cells and header.count:
        example = ", ".join(
            f"{column.name}: {{column: {k}, unit: {column.kind.unit}}}"
            for k, column in enumerate(all_wanted, start=1)
        )
        hint = f"no header; name the columns in its first line, or write columns: {{{example}}}"
        raise invalid_at("file", f"{header.shown}: expected '{expected}', got {hint}")
    if bare is not None:
        unit = wanted.kind.unit
        hint = (
            f"; '{bare}' has no unit; did you mean '{bare}_{wanted.unit_word}'? Or write "
            f"columns: {{{wanted.name}: {{column: {bare}, unit: {unit}}}}}"
        )
    else:
        for cell in cells:
            if unclear := unclear_unit(cell, wanted.kind):
                raise invalid_at("file", f"{header.shown}: '{cell}' {unclear}")
        headers = [column.header for column in all_wanted]
        missing = [name for name in headers if name not in cells]
        hint = "".join(did_you_mean(cell, missing) for cell in cells if cell not in headers)
        missed = f"a {wanted.kind.name}" if _is_alone(wanted, all_wanted) else wanted.name
        hint = hint[:200] or f"; no column is {missed}"
    raise invalid_at("file", f"{header.shown}: expected '{expected}', got '{given}'{hint}")


def _listed(header: Header) -> str:
    cells = ", ".join(f"'{cell.strip()[:40]}'" for cell in header.cells[:12])
    return f"its columns are {cells}" if cells else f"it has no header, but {header.count} columns"
