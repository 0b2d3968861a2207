"""What the header of a column says against what a spec takes the column for."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from viscodesign.scene.spec_part import invalid_at
from viscodesign.scene.tables.header_units import header_unit, unclear_unit, unit_factor
from viscodesign.scene.tables.preamble import KINDS
from viscodesign.units import QuantityKind

_BRACKETED = re.compile(r".*(?:\[(?P<square>.+)\]|\((?P<round>.+)\))\s*")
SAME_UNIT = 1e-9
"""Relative difference up to which two units are one."""


def refuse_other_unit(
    name: str, header: str, kind: QuantityKind, unit: str, factor: float, reference: str
) -> None:
    """Refuse a stated unit, or a reference of a pressure, that is not the one of the header."""
    own = header_unit(header, kind)
    if own is None:
        return
    is_same = math.isclose(own.factor, factor, rel_tol=SAME_UNIT)
    if not is_same or (reference and own.reference and reference != own.reference):
        raise invalid_at(
            "columns",
            f"{name}: its header '{header}' has another unit than the stated '{unit}'; leave "
            "'unit' out to read it as its header says, or correct the header",
        )


def refuse_other_quantity(
    name: str, header: str, kind: QuantityKind, others: dict[str, QuantityKind], is_stated: bool
) -> None:
    """Refuse a column whose header says another quantity, or a unit that is unclear.

    ``others`` are the names of the table's other columns. ``is_stated``: whether the spec states
    the unit; round brackets may then hold a word, as in ``p (in)``.
    """
    if not is_stated and (unclear := unclear_unit(header, kind)):
        raise invalid_at("columns", f"{name}: '{header}' {unclear}")
    if header_unit(header, kind) is None and (
        said := _named(header, others) or _in_brackets(header, is_stated)
    ):
        raise invalid_at(
            "columns",
            f"{name}: its header '{header}' says {said}, not {kind.name}; choose another "
            "column, or correct the header",
        )


def refuse_shared(found: Sequence[tuple[int, str]], names: Sequence[str]) -> None:
    """Refuse one column of a file, by place from 0 and header, for two of the ``names``."""
    taken: dict[int, str] = {}
    for name, (place, header) in zip(names, found, strict=True):
        if (other := taken.setdefault(place, name)) != name:
            raise invalid_at(
                "columns",
                f"{other} and {name} are both column {place + 1}, '{header}'; choose another one "
                "for one of them",
            )


def _named(header: str, others: dict[str, QuantityKind]) -> str:
    """The quantity of a header such as ``time_s`` with the name and the unit of another column."""
    for name, kind in others.items():
        own = header_unit(header, kind)
        if own is not None and own.name.lower() == name:
            return kind.name
    return ""


def _in_brackets(header: str, only_square: bool) -> str:
    found = _BRACKETED.fullmatch(header)
    unit = found and (found["square"] or ("" if only_square else found["round"]))
    if not unit:
        return ""
    fitting = (kind.name for kind in KINDS if unit_factor(unit.strip(), kind)[0] is not None)
    return next(fitting, "")
