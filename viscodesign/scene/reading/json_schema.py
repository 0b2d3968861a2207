"""JSON Schema of the spec, for editors."""

from __future__ import annotations

from typing import Any

from viscodesign.scene.effects_choice import EFFECTS, EFFECTS_WORDS, MODE, OTHERS, KnownEffects
from viscodesign.scene.fluid import named_fluids
from viscodesign.scene.reading.document import IGNORED_PREFIX, ROBOT_KEY
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import SpecPart
from viscodesign.scene.uncertainty import NONE, TYPICAL

_ON = ["on", "yes", True]
_OFF = ["off", "no", False]
_BOUNDS = {
    "gt": "exclusiveMinimum",
    "ge": "minimum",
    "lt": "exclusiveMaximum",
    "le": "maximum",
}


Node = dict[str, Any]
SCENES: dict[str, type[SpecPart]] = {
    "Scene": Scene,
    "RobotScene": RobotScene,
    "SeveralScene": SeveralScene,
}
"""What a spec may be of, by the name of its definition."""


def spec_schema(known: KnownEffects) -> Node:
    """The schema, draft 2020-12, including the words that replace a mapping, such as `on`."""
    found = {name: model.model_json_schema(by_alias=True) for name, model in SCENES.items()}
    definitions: Node = {}
    effects = _effects(known, definitions)
    for name, schema in found.items():
        definitions |= schema.pop("$defs")
        definitions[name] = _with_words(schema, effects)
    definitions["Scene"]["oneOf"] = [{"required": ["input"]}, {"required": ["inputs"]}]
    for replaced in ("EffectsChoice", "Uncertainty"):
        definitions.pop(replaced, None)
    gravity = definitions["Loads"]["properties"]["gravity"]
    gravity["anyOf"] = [{"enum": [*_ON, *_OFF, None]}, {"$ref": "#/$defs/GravityLoad"}]
    _move_bounds(definitions)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "viscodesign spec",
        "type": "object",
        **_chosen([(ROBOT_KEY, "RobotScene"), ("actuators", "SeveralScene")], "Scene"),
        "$defs": definitions,
    }


def _chosen(by_key: list[tuple[str, str]], otherwise: str) -> Node:
    """The definition of the first key that a spec has, or another one."""
    if not by_key:
        return {"$ref": f"#/$defs/{otherwise}"}
    (key, name), *others = by_key
    return {
        "if": {"required": [key]},
        "then": {"$ref": f"#/$defs/{name}"},
        "else": _chosen(others, otherwise),
    }


def _with_words(schema: Node, effects: Node) -> Node:
    """The schema of a scene with the words and names that its keys take besides mappings."""
    properties = schema["properties"]
    properties["fluid"] = _fluid()
    properties[EFFECTS] = effects
    if "uncertainty" in properties:
        properties["uncertainty"] = _uncertainty(properties["uncertainty"]["description"])
    schema["patternProperties"] = {f"^{IGNORED_PREFIX}": {}}
    return {key: value for key, value in schema.items() if key != "title"}


def _fluid() -> Node:
    kinds = named_fluids().items()
    return {
        "anyOf": [
            {"enum": [name for name, kind in kinds if not kind.graded_like]},
            *(
                {"type": "string", "pattern": kind.pattern()}
                for _, kind in kinds
                if kind.graded_like
            ),
            {"$ref": "#/$defs/Fluid"},
        ],
        "description": "A named fluid, or a mapping of properties",
    }


def _effects(known: KnownEffects, definitions: Node) -> Node:
    """Modes and options of effects; ``definitions`` gets those of parts of options."""
    mode = {"enum": ["auto", *_ON, *_OFF]}
    modes: Node = dict.fromkeys(known.names, mode)
    for name, kind in known.options.items():
        own = kind.model_json_schema(by_alias=True)
        definitions |= own.pop("$defs", {})
        own["properties"] = {MODE: mode, **own["properties"]}
        modes[name] = {"anyOf": [mode, own]}
    return {
        "anyOf": [
            mode,
            {
                "type": "object",
                "properties": {
                    **modes,
                    OTHERS: {**mode, "description": "Mode of all other effects"},
                },
                "additionalProperties": False,
            },
        ],
        "description": EFFECTS_WORDS,
    }


def _uncertainty(description: str) -> Node:
    end = {"anyOf": [{"type": "string"}, {"type": "number"}]}
    return {
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
        "description": description,
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
