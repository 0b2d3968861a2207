"""A scene back into YAML: as resolved, in SI with units, runnable again."""

from __future__ import annotations

from typing import Any

import yaml
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from viscodesign.scene.effects_choice import OTHERS, EffectsChoice
from viscodesign.scene.scene import Scene
from viscodesign.units import Kind


def resolved_yaml(scene: Scene) -> str:
    """The spec as resolved; loading it gives an equal scene."""
    return yaml.dump(_model(scene), sort_keys=False, allow_unicode=True, default_flow_style=False)


def _model(part: BaseModel) -> dict[str, Any]:
    """Fields under their YAML keys; what is unset stays away."""
    data: dict[str, Any] = {}
    for name, found in type(part).model_fields.items():
        value = getattr(part, name)
        if value is None and name != "gravity":
            continue
        data[found.alias or name] = _value(value, found)
    return data


def _value(value: Any, found: FieldInfo) -> Any:
    kinds = [k for k in found.metadata if isinstance(k, Kind)]
    if value is None:
        return "off"
    if isinstance(value, EffectsChoice):
        return {**value.modes, OTHERS: value.others}
    if isinstance(value, BaseModel):
        return _model(value)
    if isinstance(value, dict):
        return {k: _model(v) if isinstance(v, BaseModel) else v for k, v in value.items()}
    if isinstance(value, tuple):
        return [_entry(v) for v in value]
    if kinds and isinstance(value, float):
        return _with_unit(value, kinds[0])
    return value


def _entry(value: Any) -> Any:
    if isinstance(value, BaseModel):
        return _model(value)
    return [_entry(v) for v in value] if isinstance(value, tuple) else value


def _with_unit(value: float, kind: Kind) -> Any:
    """SI with its unit; temperatures stay in kelvin, fractions are plain numbers."""
    return value if kind.unit == "1" else f"{value!r} {kind.unit}"
