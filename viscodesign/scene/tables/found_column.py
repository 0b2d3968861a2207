"""The column of a file that a quantity must be, by its name and unit, where a spec names none."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NoReturn

from viscodesign.errors import did_you_mean
from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.tables.columns import ChosenColumn, Header, WantedColumn
from viscodesign.scene.tables.header_units import header_unit, unclear_unit


def found_column(
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
            place, cells[place], unit.factor, unit.reference, wanted.is_of_run(cells[place])
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
