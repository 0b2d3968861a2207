"""JSON Schema of the spec, for editors."""

from __future__ import annotations

from typing import Any

from viscodesign.scene.effects_choice import OTHERS
from viscodesign.scene.fluid import named_fluids
from viscodesign.scene.load import KnownEffects
from viscodesign.scene.scene import Scene


def spec_schema(known: KnownEffects) -> dict[str, Any]:
    """Draft 2020-12. The words that stand for a mapping are allowed beside it."""
    schema = Scene.model_json_schema(by_alias=True)
    definitions, properties = schema["$defs"], schema["properties"]
    properties["fluid"] = {
        "anyOf": [{"enum": list(named_fluids())}, {"$ref": "#/$defs/Fluid"}],
        "description": "A named fluid, or a mapping with its properties",
    }
    mode = {"enum": ["auto", "on", "off", True, False]}
    properties["effects"] = {
        "anyOf": [
            {"enum": ["auto", "on", "off"]},
            {
                "type": "object",
                "properties": {
                    **dict.fromkeys(known.names, mode),
                    **{name: {"enum": ["off", False]} for name in known.reserved},
                    OTHERS: {**mode, "description": "For every effect that is not named"},
                },
                "additionalProperties": False,
            },
        ],
        "description": "auto, or effect: auto | on | off",
    }
    definitions.pop("EffectsChoice", None)
    gravity = definitions["Loads"]["properties"]["gravity"]
    gravity["anyOf"] = [{"enum": ["on", "off", True, False, None]}, {"$ref": "#/$defs/Gravity"}]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "viscodesign spec",
        **{key: value for key, value in schema.items() if key != "title"},
    }
