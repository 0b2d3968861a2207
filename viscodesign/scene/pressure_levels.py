"""Levels of pressure in an input, which may say that they are gauge or absolute.

A bare level, or one that says `gauge`, is added to the baseline. One that says `abs` is the
absolute pressure at the inlet: ambient pressure and baseline are subtracted when a spec is read.
Heights such as an amplitude or a drop have no reference.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.scene.inputs.base import Input
from viscodesign.scene.spec_part import KeyFault, KeyPath, raise_faults
from viscodesign.units import PRESSURE_LEVEL, PressureLevelKind, ReferencedPressure


def with_levels_above(baseline: float, kind: type[Input], given: Mapping[str, Any]) -> Any:
    """The keys of an input with its absolute levels as gauge above the baseline.

    ``baseline`` is absolute [Pa]. Raises faults for levels that cannot be read.
    """
    found: dict[str, Any] = dict(given)
    faults: list[KeyFault] = []
    for key in level_keys(kind):
        found[key] = _above(baseline, found.get(key), (key,), faults)
    if "rows" in found and kind.name == "table" and isinstance(found["rows"], (list, tuple)):
        found["rows"] = [
            _row_above(baseline, row, ("rows", str(k), "1"), faults)
            for k, row in enumerate(found["rows"])
        ]
    raise_faults(faults)
    return {key: value for key, value in found.items() if key in given}


def level_keys(kind: type[Input]) -> list[str]:
    """The keys of a kind that hold a level of pressure."""
    return [
        name
        for name, field in kind.model_fields.items()
        if any(isinstance(note, PressureLevelKind) for note in field.metadata)
    ]


def levels_of(source: Input) -> list[tuple[str, float]]:
    """Its levels above the baseline [Pa], by key."""
    return [(key, getattr(source, key)) for key in level_keys(type(source))]


def stated_reference(level: float) -> str:
    """The reference that a level was given with; empty for a bare one."""
    return level.reference if isinstance(level, ReferencedPressure) else ""


def bare_levels(source: Input) -> list[tuple[str, float]]:
    """Its levels [Pa] that say neither gauge nor absolute, by key."""
    return [(key, float(level)) for key, level in levels_of(source) if not stated_reference(level)]


def _row_above(baseline: float, row: Any, path: KeyPath, faults: list[KeyFault]) -> Any:
    if not isinstance(row, (list, tuple)) or len(row) != 2 or not isinstance(row[1], str):
        return row
    return [row[0], _above(baseline, row[1], path, faults)]


def _above(baseline: float, given: Any, path: KeyPath, faults: list[KeyFault]) -> Any:
    """An absolute level as gauge above the baseline; anything else as it is."""
    if not isinstance(given, str) or not PRESSURE_LEVEL.has_reference(given):
        return given
    try:
        level = PRESSURE_LEVEL.parse_with_reference(given)
    except PydanticCustomError as error:
        faults.append(KeyFault(path, str((error.context or {})["message"])))
        return 0.0
    if level.reference == "abs":
        return ReferencedPressure.of(float(level) - baseline, "gauge")
    return level
