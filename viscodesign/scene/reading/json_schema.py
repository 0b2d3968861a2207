"""JSON Schema of the spec, for editors."""

from __future__ import annotations

from typing import Any

from viscodesign.scene.effects_choice import OTHERS
from viscodesign.scene.fluid import named_fluids
from viscodesign.scene.reading.read import IGNORED_PREFIX, KnownEffects
from viscodesign.scene.scene import Scene
from viscodesign.scene.uncertainty import NONE, TYPICAL

_ON = ["on", "yes", True]
_OFF = ["off", "no", False]
_BOUNDS = {
    "gt": "exclusiveMinimum",
    "ge": "minimum",
    "lt": "exclusiveMaximum",
    "le": "maximum",
}


def spec_schema(known: KnownEffects) -> dict[str, Any]:
    """The schema, draft 2020-12, including the words that replace a mapping, such as `on`."""
    schema = Scene.model_json_schema(by_alias=True)
    definitions, properties = schema["$defs"], schema["properties"]
    properties["fluid"] = {
        "anyOf": [
            {"enum": [name for name, kind in named_fluids().items() if not kind.graded_like]},
            *(
                {"type": "string", "pattern": kind.pattern()}
                for kind in named_fluids().values()
                if kind.graded_like
            ),
            {"$ref": "#/$defs/Fluid"},
        ],
        "description": "A named fluid, or a mapping of properties",
    }
    mode = {"enum": ["auto", *_ON, *_OFF]}
    properties["effects"] = {
        "anyOf": [
            mode,
            {
                "type": "object",
                "properties": {
                    **dict.fromkeys(known.names, mode),
                    OTHERS: {**mode, "description": "Mode of all other effects"},
                },
                "additionalProperties": False,
            },
        ],
        "description": "auto, or effect: auto | on | off",
    }
    definitions.pop("EffectsChoice", None)
    end = {"anyOf": [{"type": "string"}, {"type": "number"}]}
    properties["uncertainty"] = {
        "anyOf": [
            {"const": TYPICAL},
            {
                "type": "object",
                "properties": {OTHERS: {"enum": [TYPICAL, NONE]}},
                "additionalProperties": {
                    "anyOf": [
                        {"type": "string"},
                        {"type": "array", "items": end, "minItems": 2, "maxItems": 2},
                        {"type": "object"},
                    ]
                },
            },
        ],
        "description": properties["uncertainty"]["description"],
    }
    definitions.pop("Uncertainty", None)
    gravity = definitions["Loads"]["properties"]["gravity"]
    gravity["anyOf"] = [{"enum": [*_ON, *_OFF, None]}, {"$ref": "#/$defs/GravityLoad"}]
    schema["oneOf"] = [{"required": ["input"]}, {"required": ["inputs"]}]
    schema["patternProperties"] = {f"^{IGNORED_PREFIX}": {}}
    _move_bounds(schema)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "viscodesign spec",
        **{key: value for key, value in schema.items() if key != "title"},
    }


def _move_bounds(node: Any) -> None:
    """Move the bounds of optional quantities to where JSON Schema expects them."""
    if isinstance(node, list):
        for item in node:
            _move_bounds(item)
    if not isinstance(node, dict):
        return
    for name, keyword in _BOUNDS.items():
        if isinstance(node.get(name), (int, float)) and "anyOf" in node:
            number = next(one for one in node["anyOf"] if one.get("type") == "number")
            number[keyword] = node.pop(name)
    for item in node.values():
        _move_bounds(item)
