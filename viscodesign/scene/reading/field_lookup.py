"""The model field that a key of a spec belongs to, and the keys allowed beside it."""

from __future__ import annotations

from collections.abc import Mapping
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.per_inlet import is_by_inlet
from viscodesign.scene.pump import DEFAULT_KIND, PUMP_KINDS
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.reading.document import Document
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import SameInput
from viscodesign.scene.spec_part import KeyPath
from viscodesign.units import QuantityKind

FAMILIES: tuple[tuple[type[BaseModel], Mapping[str, type[BaseModel]], str | None], ...] = (
    (Input, INPUT_KINDS, None),
    (PumpSpec, PUMP_KINDS, DEFAULT_KIND),
)
"""Sections that come in kinds: their base, the kinds by name, and the one that is not named."""


def field_at(path: KeyPath, document: Document) -> FieldInfo | None:
    """The field that a key is read into, or None."""
    model = _model_at(path[:-1], document) if path else None
    return _fields(model).get(path[-1]) if model is not None else None


def quantity_of(found: FieldInfo) -> QuantityKind | None:
    """The kind of quantity that a field holds, optional ones included."""
    notes = [*found.metadata, *_notes(found.annotation)]
    return next((note for note in notes if isinstance(note, QuantityKind)), None)


def example_of(found: FieldInfo, quantity: QuantityKind) -> str:
    """An example of a field's value: its own, or else that of its kind."""
    return str(found.examples[0]) if found.examples else quantity.example


def keys_beside(path: KeyPath, document: Document) -> list[str]:
    """The keys that are allowed beside the last one of ``path``."""
    model = _model_at(path[:-1], document)
    return list(_fields(model)) if model is not None else []


def is_key_of_a_kind(key: str) -> bool:
    """Whether a section that comes in kinds has a key of this name in one of them."""
    return any(key in _fields(kind) for _, kinds, _ in FAMILIES for kind in kinds.values())


def _fields(model: type[BaseModel]) -> dict[str, FieldInfo]:
    return {found.alias or name: found for name, found in model.model_fields.items()}


def _model_at(path: KeyPath, document: Document) -> type[BaseModel] | None:
    """The model that the mapping of a key is read into."""
    annotation: Any = document.model or Scene
    for depth, part in enumerate(path):
        model = _model_in(annotation, document.given(path[:depth]))
        if model is None:
            annotation = entry_of(annotation)
        elif part in _fields(model):
            annotation = _fields(model)[part].annotation
        else:
            return None
    return _model_in(annotation, document.given(path))


def _model_in(annotation: Any, given: Any) -> type[BaseModel] | None:
    """The model of an annotation; of a family of kinds, the given one."""
    kinds = [a for a in alternatives(annotation) if isinstance(a, type)]
    models = [a for a in kinds if issubclass(a, BaseModel)]
    if isinstance(given, dict) and "as" in given and SameInput in models:
        return SameInput
    models = [model for model in models if model is not SameInput]
    for base, family, default in FAMILIES:
        if models and all(issubclass(model, base) for model in models):
            kind = given.get("kind", default) if isinstance(given, dict) else None
            return family.get(kind) if isinstance(kind, str) else None
    if len(kinds) < len(alternatives(annotation)) and is_by_inlet(given):
        return None
    return models[0] if len(models) == 1 else None


def entry_of(annotation: Any) -> Any:
    """The type of the entries of a mapping or a list."""
    for alternative in alternatives(annotation):
        if get_origin(alternative) is dict:
            return get_args(alternative)[1]
        if get_origin(alternative) is tuple:
            return get_args(alternative)[0]
    return None


def _notes(annotation: Any) -> list[Any]:
    """The annotations of the members of a union."""
    if get_origin(annotation) is Annotated:
        return list(get_args(annotation)[1:])
    if get_origin(annotation) in (Union, UnionType):
        return [note for member in get_args(annotation) for note in _notes(member)]
    return []


def alternatives(annotation: Any) -> list[Any]:
    """The members of a union, however nested and annotated."""
    origin = get_origin(annotation)
    if origin is Annotated:
        return alternatives(get_args(annotation)[0])
    if origin in (Union, UnionType):
        return [a for member in get_args(annotation) for a in alternatives(member)]
    return [annotation]
