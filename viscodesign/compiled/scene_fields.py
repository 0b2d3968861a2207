"""The fields of a scene that hold numbers, read and replaced by their places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, get_args, get_origin

from pydantic.fields import FieldInfo

from viscodesign.compiled.free_number import Bounds
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.network import TubeChange
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.spec_part import KeyPath, SpecPart
from viscodesign.units import QuantityKind


@dataclass(frozen=True)
class NumberField:
    """A place in a scene that holds a number, or could."""

    path: KeyPath
    value: float | None
    unit: str
    bounds: Bounds


@dataclass(frozen=True)
class TableField:
    """A place in a scene that holds rows of numbers, or a list of them."""

    path: KeyPath
    count: int
    columns: tuple[str, ...]
    """Named by what they hold; of a list a single one, without a name."""

    def entry(self, row: int, column: str) -> KeyPath:
        """Where a number of it stands."""
        own = (str(self.columns.index(column)),) if column else ()
        return (*self.path, str(row), *own)


def number_fields(part: SpecPart, path: KeyPath = ()) -> Iterator[NumberField]:
    """Every number of a part of a scene."""
    for place, value, found in _fields(part, path):
        kind, kinds = quantity_of(found), _column_kinds(found)
        if kind is not None:
            yield NumberField(place, value, kind.unit, Bounds.of(found.metadata))
        for k, row in enumerate(value or () if kinds else ()):
            entries = row if isinstance(row, tuple) else (row,)
            for c, (kind, entry) in enumerate(zip(kinds, entries, strict=True)):
                own = (str(c),) if isinstance(row, tuple) else ()
                yield NumberField((*place, str(k), *own), entry, kind.unit, Bounds())
        for key, inner in parts_in(value):
            yield from number_fields(inner, (*place, *key))


def table_fields(part: SpecPart, path: KeyPath = ()) -> Iterator[TableField]:
    """Every table and every list of numbers of a part of a scene."""
    for place, value, found in _fields(part, path):
        kinds = _column_kinds(found)
        if kinds and value:
            names = tuple(kind.name.replace(" ", "_") for kind in kinds)
            yield TableField(place, len(value), names if isinstance(value[0], tuple) else ("",))
        for key, inner in parts_in(value):
            yield from table_fields(inner, (*place, *key))


def _fields(part: SpecPart, path: KeyPath) -> Iterator[tuple[KeyPath, Any, FieldInfo]]:
    for key, value, found in part.keyed_fields():
        yield (*path, key), value, found


def parts_in(value: Any) -> list[tuple[KeyPath, SpecPart]]:
    """The parts of a spec that a field's value holds, and their keys below it."""
    if isinstance(value, SpecPart):
        return [((), value)]
    if isinstance(value, dict):
        return [((k,), v) for k, v in value.items() if isinstance(v, SpecPart)]
    if isinstance(value, tuple):
        return [((str(k),), v) for k, v in enumerate(value) if isinstance(v, SpecPart)]
    return []


def _column_kinds(found: FieldInfo) -> Sequence[QuantityKind]:
    """Kinds of the columns of a field that is a tuple of rows or of numbers; else none."""
    for outer in (found.annotation, *get_args(found.annotation)):
        if get_origin(outer) is not tuple or not get_args(outer):
            continue
        inner = get_args(outer)[0]
        columns = get_args(inner) if get_origin(inner) is tuple else (inner,)
        notes = [note for column in columns for note in get_args(column)[1:]]
        return [note for note in notes if isinstance(note, QuantityKind)]
    return ()


def value_at(value: Any, path: KeyPath) -> Any:
    """What stands at a place of a scene; raises `LookupError` where nothing does."""
    for part in path:
        if isinstance(value, SpecPart):
            value = _by_key(value)[part]
        elif isinstance(value, dict):
            value = value[part]
        elif isinstance(value, tuple) and part.isdigit():
            value = value[int(part)]
        else:
            raise LookupError(part)
    return value


def is_given(scene: SpecPart, path: KeyPath) -> bool:
    """Whether a spec has a value at a place."""
    try:
        return value_at(scene, path) is not None
    except LookupError:
        return False


def _by_key(part: SpecPart) -> dict[str, Any]:
    """What stands at the keys of a part."""
    return {key: value for key, value, _ in part.keyed_fields()}


def replaced(value: Any, tree: Any) -> Any:
    """A part of a scene with what a tree of keys holds in their places; nothing is validated."""
    if not isinstance(tree, dict):
        return tree
    if isinstance(value, SpecPart):
        held = _by_key(value)
        return value.with_keys({key: replaced(held[key], below) for key, below in tree.items()})
    if isinstance(value, tuple):
        entries = list(value)
        for key, below in tree.items():
            entries[int(key)] = replaced(entries[int(key)], below)
        return tuple(entries)
    # Of all mappings only that of changed tubes lets a key be new.
    changes = {k: replaced(value.get(k, TubeChange()), below) for k, below in tree.items()}
    return {**value, **changes}
