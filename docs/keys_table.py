"""Tables of all keys of a spec, from the models that read it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from viscodesign.effects.catalogue import catalogue
from viscodesign.scene.actuator import Actuator
from viscodesign.scene.bellows import Bellows
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.reading.field_lookup import alternatives, entry_of, quantity_of
from viscodesign.scene.robot import Robot
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import SameInput
from viscodesign.scene.uncertainty import Uncertainty
from viscodesign.units import QuantityKind

HEAD = ("key", "meaning", "unit", "default", "range", "effects")
BOUNDS = {"gt": "> {:g}", "ge": ">= {:g}", "lt": "< {:g}", "le": "<= {:g}"}
KIND = "kind"
EXAMPLE_PATHS = {
    "sections": "sections.1-2",
    "bellows.changes": "bellows.changes.R1",
    "network.changes": "network.changes.R1-R2",
    "robot.legs": "robot.legs.LF",
}
"""Mappings with names of their own, with one such name."""

EFFECTS = (
    "Names of effects, each with its mode, or with a mapping of `mode` and its own options where "
    "it has some. A mode that is not stated is that of `others`."
)

Row = tuple[str, ...]
Section = tuple[str, str, list[Row]]
"""Heading, what it is, and its keys."""


def sections() -> Iterator[Section]:
    """Every section of a spec: the top level, those below it, and each kind of input."""
    yield "Top level", "", [_row("", name, found) for name, found in _top_level()]
    for name, found in _top_level():
        for model in _models(found.annotation):
            if model is EffectsChoice:
                yield "effects", EFFECTS, _effect_rows()
            elif model is Uncertainty:
                yield name, _summary(model), _uncertainty_rows()
            elif issubclass(model, PumpSpec):
                yield f"{name} of kind {model.name}", _summary(model), list(_rows(name, model))
            elif not issubclass(model, Input):
                yield f"{name}", _summary(model), list(_rows(EXAMPLE_PATHS.get(name, name), model))
    yield "robot", _summary(Robot), list(_rows("robot", Robot))
    yield "input that is another one", _summary(SameInput), list(_rows("inputs.B", SameInput))
    for kind, model in INPUT_KINDS.items():
        rows = [row for row in _rows("input", model) if row[0] != f"`input.{KIND}`"]
        yield f"input of kind {kind}", _summary(model), rows


def _uncertainty_rows() -> list[Row]:
    fields = Uncertainty.model_fields
    keyed = _row("uncertainty", "KEY", fields["spreads"])
    return [keyed, _row("uncertainty", "others", fields["others"])]


def coefficient_units() -> dict[str, QuantityKind]:
    """What the fields of the body and of the bellows hold, by name."""
    fields = {**Actuator.model_fields, **Bellows.model_fields}
    found = {name: quantity_of(field) for name, field in fields.items()}
    return {name: quantity for name, quantity in found.items() if quantity is not None}


def _top_level() -> list[tuple[str, FieldInfo]]:
    return [(found.alias or name, found) for name, found in Scene.model_fields.items()]


def _rows(path: str, model: type[BaseModel]) -> Iterator[Row]:
    """Keys of a section, each followed by those below it."""
    for name, found in model.model_fields.items():
        key = found.alias or name
        yield _row(path, key, found)
        below = EXAMPLE_PATHS.get(f"{path}.{key}", f"{path}.{key}")
        for part in _models(found.annotation):
            yield from _rows(below + ("[0]" if _is_list(found.annotation) else ""), part)


def _row(path: str, key: str, found: FieldInfo) -> Row:
    place = f"{path}.{key}" if path else key
    quantity = quantity_of(found)
    unit = "" if quantity is None or quantity.unit == "1" else f"`{quantity.unit}`"
    meaning = f"{found.description or ''}"
    return (
        f"`{place}`", meaning, unit, _default(found, quantity), _range(found), _effects_of(place)
    )  # fmt: skip


def _default(found: FieldInfo, quantity: QuantityKind | None) -> str:
    if found.is_required():
        return "required"
    value = found.default
    if value is PydanticUndefined or value is None or isinstance(value, BaseModel):
        return ""
    if isinstance(value, bool | str):
        return f"`{value}`"
    if quantity is None:
        return f"{value:,}".replace(",", "") if isinstance(value, int) else str(value)
    return f"{value:.6g}" if quantity.unit == "1" else f"{value:.6g} {quantity.unit}"


def _range(found: FieldInfo) -> str:
    for option in alternatives(found.annotation):
        if get_origin(option) is Literal:
            return ", ".join(f"`{word}`" for word in get_args(option))
    notes = [
        words.format(getattr(note, name))
        for name, words in BOUNDS.items()
        for note in found.metadata
        if isinstance(getattr(note, name, None), int | float) and math.isfinite(getattr(note, name))
    ]
    return ", ".join(notes)


def _effects_of(place: str) -> str:
    """Effects that read a key, or all below a section that they name."""
    names = [name for name, effect in catalogue().items() if effect.reads(place)]
    return ", ".join(f"`{name}`" for name in names)


def _effect_rows() -> list[Row]:
    modes = "`auto`, `on`, `off`"
    rows: list[Row] = []
    for name, effect in catalogue().items():
        what = (effect.__doc__ or "").strip().splitlines()[0]
        rows.append((f"`effects.{name}`", what, "", "`auto`", modes, f"`{name}`"))
        rows += _rows(f"effects.{name}", effect.options) if effect.options is not None else ()
    others = EffectsChoice.model_fields["others"].description or ""
    return [*rows, ("`effects.others`", others, "", "`auto`", modes, "")]


def _models(annotation: Any) -> list[type[BaseModel]]:
    """The parts that a field holds, directly or as entries."""
    found = []
    for option in (*alternatives(annotation), *alternatives(entry_of(annotation))):
        if isinstance(option, type) and issubclass(option, BaseModel) and option not in found:
            found.append(option)
    return found


def _is_list(annotation: Any) -> bool:
    return any(get_origin(option) is tuple for option in alternatives(annotation))


def _summary(model: type[BaseModel]) -> str:
    return (model.__doc__ or "").strip().splitlines()[0]
