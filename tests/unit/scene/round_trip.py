"""A resolved spec loads to an equal scene, and the schema accepts it."""

from __future__ import annotations

from functools import cache

import jsonschema
import yaml

from viscodesign import Scene
from viscodesign.loading import known_effects, schema
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.reading.write import resolved_yaml


@cache
def validator() -> jsonschema.Draft202012Validator:
    return jsonschema.Draft202012Validator(schema())


def comes_back(scene: Scene) -> str:
    """The resolved spec, once it has proved to mean the same."""
    text = resolved_yaml(scene)
    assert parse_scene(text.encode(), known=known_effects()).model_dump() == scene.model_dump()
    validator().validate(yaml.safe_load(text))
    return text
