"""The model field that a key of a spec belongs to, and the keys allowed beside it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from viscodesign.scene.effects_choice import MODE, OTHERS, EffectsChoice, is_effect
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
    if model is None:
        return []
    return [*([MODE] if is_effect(path[:-1]) else []), *_fields(model)]


def fields_below(model: type[BaseModel], above: str) -> Iterator[tuple[str, FieldInfo]]:
    """Every key below a section and its field, each followed by those below it."""
    for name, found in _fields(model).items():
        yield f"{above}{name}", found
        for part in _parts(found.annotation):
            yield from fields_below(part, f"{above}{name}.")


def _parts(annotation: Any) -> list[type[BaseModel]]:
    """The parts of a spec that a field may hold."""
    kinds = [kind for kind in alternatives(annotation) if isinstance(kind, type)]
    return [kind for kind in kinds if issubclass(kind, BaseModel)]


def is_key_of_a_kind(key: str) -> bool:
    """Whether a section that comes in kinds has a key of this name in one of them."""
    return any(key in _fields(kind) for _, kinds, _ in FAMILIES for kind in kinds.values())


def _fields(model: type[BaseModel]) -> dict[str, FieldInfo]:
    if model is EffectsChoice:  # its other keys are names of effects
        return {OTHERS: model.model_fields[OTHERS]}
    return {found.alias or name: found for name, found in model.model_fields.items()}


def _model_at(path: KeyPath, document: Document) -> type[BaseModel] | None:
    """The model that the mapping of a key is read into."""
    annotation: Any = document.model or Scene
    for depth, part in enumerate(path):
        model = _model_in(annotation, document.given(path[:depth]))
        if model is EffectsChoice:
            annotation = document.effects.options.get(part)
        elif model is None:
            annotation = entry_of(annotation)
        elif part in _fields(model):
            annotation = _fields(model)[part].annotation
        else:
            return None
    return _model_in(annotation, document.given(path))


def _model_in(annotation: Any, given: Any) -> type[BaseModel] | None:
    """The model of an annotation; of a family of kinds, the given one."""
    models = _parts(annotation)
    if isinstance(given, dict) and "as" in given and SameInput in models:
        return SameInput
    models = [model for model in models if model is not SameInput]
    for base, family, default in FAMILIES:
        if models and all(issubclass(model, base) for model in models):
            kind = given.get("kind", default) if isinstance(given, dict) else None
            return family.get(kind) if isinstance(kind, str) else None
    is_type = [isinstance(kind, type) for kind in alternatives(annotation)]
    if not all(is_type) and is_by_inlet(given):
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
