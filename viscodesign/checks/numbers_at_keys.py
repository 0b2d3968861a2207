"""Numbers of a spec by its keys, of which a part may stand for any name or number."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

from pydantic import BaseModel

from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import SpecPart

ANY_NAME = "*"
INPUTS = "inputs."
"""All inputs, also the only one, whose own key is `input`."""


def numbers_at(spec: SpecPart, key: str) -> Iterator[tuple[str, float]]:
    """Numbers that stand at a key such as `network.changes.*.length`, each with its own key."""
    if not (key.startswith(INPUTS) and isinstance(spec, Scene)):
        yield from _below(spec, key.split("."), "")
        return
    name, *parts = key.removeprefix(INPUTS).split(".")
    for inlet, source in spec.inputs.items():
        if name in (ANY_NAME, inlet):
            own = "input" if spec.several_inputs is None else f"inputs.{inlet}"
            yield from _below(source, parts, own)


def _below(here: Any, parts: list[str], path: str) -> Iterator[tuple[str, float]]:
    if here is None:
        return
    if not parts:
        yield path, float(here)
        return
    part, *others = parts
    for name, value in _entries(here, part):
        yield from _below(value, others, f"{path}{name}" if name[0] == "[" else _joined(path, name))


def _entries(here: Any, part: str) -> Iterator[tuple[str, Any]]:
    """What stands below under a name, or under any."""
    if isinstance(here, BaseModel):
        for field in _fields(type(here)).get(part, ()):
            yield part, getattr(here, field)
    elif isinstance(here, Mapping):
        yield from here.items()
    elif isinstance(here, tuple):
        yield from ((f"[{k}]", value) for k, value in enumerate(here))


@cache
def _fields(kind: type[BaseModel]) -> dict[str, list[str]]:
    """Fields of a part of a spec by the names that they answer to: their own and their alias."""
    found: dict[str, list[str]] = {}
    for field, info in kind.model_fields.items():
        for name in {field, info.alias} - {None}:
            found.setdefault(str(name), []).append(field)
    return found


def _joined(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name
