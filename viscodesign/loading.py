"""Reading a spec with the effects of this version."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from viscodesign.effects.catalogue import effect_names
from viscodesign.scene.reading.json_schema import spec_schema
from viscodesign.scene.reading.read import KnownEffects, load_scene
from viscodesign.scene.scene import Scene


def known_effects() -> KnownEffects:
    """Names that a spec may use under `effects:`."""
    return KnownEffects(effect_names())


def load(path: str | Path, overrides: Sequence[str] = ()) -> Scene:
    """Read a spec; ``overrides`` are 'key.path=value'. Raises `SpecError` with all faults."""
    return load_scene(path, overrides, known_effects())


def schema() -> dict[str, Any]:
    """The JSON Schema of a spec, for editors."""
    return spec_schema(known_effects())
