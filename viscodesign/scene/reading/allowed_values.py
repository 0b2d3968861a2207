"""What a key of a spec may have, in words."""

from __future__ import annotations

from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from viscodesign.scene.reading.document import Document
from viscodesign.scene.reading.field_lookup import (
    FAMILIES,
    alternatives,
    example_of,
    field_at,
    keys_beside,
    quantity_of,
)
from viscodesign.scene.spec_part import KeyPath

_BOUNDS = {"gt": "above", "ge": "at least", "lt": "below", "le": "at most"}
_KINDS: dict[Any, str] = {
    int: "an integer",
    float: "a number",
    bool: "true or false",
    str: "text",
    dict: "a mapping",
    tuple: "a list",
}


def allowed_at(path: KeyPath, document: Document) -> str:
    """What the key of a path may have; of an unknown key, the keys that may stand there."""
    found = field_at(path, document)
    if found is not None:
        return allowed_of(found)
    keys = keys_beside(path, document) if path else []
    return f"one of the keys {', '.join(keys)}" if keys else ""


def allowed_of(found: FieldInfo) -> str:
    """What a field may have: its kind of value, and its bounds in SI."""
    quantity = quantity_of(found)
    if quantity is None:
        kinds = dict.fromkeys(filter(None, map(_kind, alternatives(found.annotation))))
        return " or ".join(kinds) + _bounds(found, "")
    article = "an" if quantity.name[0] in "aeiou" else "a"
    unit = "" if quantity.unit == "1" else f" {quantity.unit}"
    return (
        f"{article} {quantity.name}{_bounds(found, unit)}, such as '{example_of(found, quantity)}'"
    )


def words_at(path: KeyPath, document: Document) -> tuple[str, ...]:
    """The words that the value of a key may be; none for a number."""
    found = field_at(path, document)
    members = alternatives(found.annotation) if found is not None else []
    choices = [get_args(member) for member in members if get_origin(member) is Literal]
    return tuple(str(word) for words in choices for word in words)


def _kind(annotation: Any) -> str:
    """The kind of values of one member of a union; empty for none."""
    if get_origin(annotation) is Literal:
        return f"one of {', '.join(map(str, get_args(annotation)))}"
    plain = get_origin(annotation) or annotation
    for base, family, _ in FAMILIES:
        if isinstance(plain, type) and issubclass(plain, base):
            return f"a mapping whose kind is one of {', '.join(family)}"
    if isinstance(plain, type) and issubclass(plain, BaseModel):
        keys = (field.alias or name for name, field in plain.model_fields.items())
        return f"a mapping of {', '.join(keys)}"
    return _KINDS.get(plain, "")


def _bounds(found: FieldInfo, unit: str) -> str:
    words = [
        f"{word} {getattr(note, name):g}{unit}"
        for note in found.metadata
        for name, word in _BOUNDS.items()
        if isinstance(getattr(note, name, None), int | float)
    ]
    return f" {' and '.join(words)}" if words else ""
