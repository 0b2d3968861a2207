"""A scene as YAML: resolved, in SI with units, runnable again."""

from __future__ import annotations

import hashlib
from typing import Any

import yaml
from pydantic.fields import FieldInfo

from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.reading.yaml_events import plain_value
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import SpecPart
from viscodesign.scene.uncertainty import Uncertainty
from viscodesign.storage.lru_cache import LruCache


class _Row(list[Any]):
    """A list that is written on one line."""


class _Dumper(yaml.CSafeDumper):
    """Writes plain data, with each row on one line."""


def _on_one_line(dumper: _Dumper, row: _Row) -> yaml.SequenceNode:
    return dumper.represent_sequence("tag:yaml.org,2002:seq", row, flow_style=True)


def _in_quotes_where_needed(dumper: _Dumper, text: str) -> yaml.ScalarNode:
    """Text that would be read as a number, such as the name 1e5, needs quotes."""
    style = None if plain_value(text) == text else "'"
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=style)


_Dumper.add_representer(_Row, _on_one_line)
_Dumper.add_representer(str, _in_quotes_where_needed)


_LATEST: LruCache[str] = LruCache(16)
"""Texts of the latest scenes: equal ones have the same."""


def resolved_yaml(scene: Scene) -> str:
    """The resolved spec; loading it gives an equal scene."""
    return _LATEST.get(scene.digest, lambda: _written(scene))


def resolved_sha256(scene: SpecPart) -> str:
    """SHA-256 of the resolved spec as a file: equal for runs of the same values alone."""
    text = resolved_yaml(scene) if isinstance(scene, Scene) else part_yaml(scene)
    return hashlib.sha256(text.encode()).hexdigest()


def _written(scene: Scene) -> str:
    return part_yaml(scene)


def part_yaml(part: SpecPart) -> str:
    """A whole spec, or a part of one, as YAML."""
    return yaml.dump(
        plain_part(part), Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=100
    )


def plain_part(part: SpecPart) -> dict[str, Any]:
    """A part as a spec has it: fields under their YAML keys, without those that are unset."""
    if isinstance(part, EffectsChoice):
        return part.as_in_a_spec(plain_part)
    if isinstance(part, Uncertainty):
        return {k: _entry(tuple(v)) if isinstance(v, list) else v
                for k, v in part.as_in_a_spec().items()}  # fmt: skip
    data: dict[str, Any] = {}
    for name, found in type(part).model_fields.items():
        value = getattr(part, name)
        if (value is None and name != "gravity") or name in part.unwritten():
            continue
        data[found.alias or name] = _value(value, found)
    return data


def _value(value: Any, found: FieldInfo) -> Any:
    quantity = quantity_of(found)
    if value is None:
        return "off"
    if isinstance(value, SpecPart):
        return plain_part(value)
    if isinstance(value, dict):
        return {k: plain_part(v) if isinstance(v, SpecPart) else v for k, v in value.items()}
    if isinstance(value, tuple):
        return [_entry(v) for v in value]
    if quantity is not None and isinstance(value, float):
        return quantity.written(value)
    return value


def _entry(value: Any) -> Any:
    if isinstance(value, SpecPart):
        return plain_part(value)
    return _Row(value) if isinstance(value, tuple) else value
