"""Which columns of a file are the wanted ones: as the spec says, or by their names and units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from viscodesign.errors import did_you_mean
from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.tables.columns import ChosenColumn, Header, WantedColumn
from viscodesign.scene.tables.contradictions import refuse_shared
from viscodesign.scene.tables.found_column import found_column
from viscodesign.scene.tables.stated_column import stated_column


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
        stated_column(column, wanted, header, given[column.name])
        if column.name in given
        else found_column(column, wanted, header, inlet)
        for column in wanted
    ]
    refuse_shared([(own.place, own.header) for own in found], [w.name for w in wanted])
    return found
