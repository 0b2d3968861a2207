"""Validation faults in words of the user, each with file, line and key."""

from __future__ import annotations

from typing import Any, get_args

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from viscodesign.errors import Fault
from viscodesign.scene.base import did_you_mean
from viscodesign.scene.input import INPUT_KINDS, NOT_YET
from viscodesign.scene.scene import Scene
from viscodesign.scene.yaml_text import Document

_BOUNDS = {
    "greater_than": ("gt", "above"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "below"),
    "less_than_equal": ("le", "at most"),
}
_WANTED = {
    "string_type": "a text",
    "int_type": "a whole number",
    "int_parsing": "a whole number",
    "int_from_float": "a whole number",
    "bool_type": "true or false",
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "tuple_type": "a list",
    "list_type": "a list",
    "union_tag_not_found": "a mapping with the key 'kind'",
}


def explain(error: ValidationError, document: Document) -> list[Fault]:
    """Every fault once, in the order of the file's lines."""
    faults: dict[tuple[str, str], Fault] = {}
    for detail in error.errors(include_url=False):
        path = _key_path(detail)
        message = _message(detail, path)
        file, line = document.place(path)
        key = ".".join(path)
        faults.setdefault((key, message), Fault(message, key, file, line))
    return sorted(faults.values(), key=lambda f: f.line if f.line is not None else 0)


def _key_path(detail: ErrorDetails) -> tuple[str, ...]:
    """The YAML key: without the tags of unions, with what the fault adds below."""
    parts = [str(part) for part in detail["loc"]]
    cleaned: list[str] = []
    for part in parts:
        tagged = bool(cleaned) and (cleaned[-1] == "input" or cleaned[:-1][-1:] == ["inputs"])
        if tagged and part in INPUT_KINDS:
            continue
        cleaned.append(part)
    if cleaned[:1] == ["effects"] and cleaned[1:2] == ["modes"]:
        cleaned = ["effects", *cleaned[2:]]
    below = (detail.get("ctx") or {}).get("below", "")
    return tuple(
        cleaned + (below.split(".") if below and "-" not in below else [below] * bool(below))
    )


def _message(detail: ErrorDetails, path: tuple[str, ...]) -> str:
    kind, given = detail["type"], detail["input"]
    context: dict[str, Any] = detail.get("ctx") or {}
    if kind in ("quantity", "spec"):
        return str(context["message"])
    if kind == "missing":
        return "missing" + _description(path)
    if kind == "extra_forbidden":
        return f"no such key{did_you_mean(path[-1], _sibling_keys(path))}{_allowed(path)}"
    if kind in _BOUNDS:
        name, words = _BOUNDS[kind]
        return f"{given!r} is given; allowed are values {words} {context[name]:g} (SI)"
    if kind == "literal_error":
        known = [word.strip("'\" ") for word in context["expected"].replace(" or ", ",").split(",")]
        return (
            f"{given!r} is given; allowed are {', '.join(known)}{did_you_mean(str(given), known)}"
        )
    if kind == "union_tag_invalid":
        return _input_kind(str(context.get("tag")))
    if kind in _WANTED:
        return f"{_shown(given)} is given; {_WANTED[kind]} is wanted{_description(path)}"
    return f"{_shown(given)} is given; {detail['msg'][0].lower()}{detail['msg'][1:]}"


def _input_kind(given: str) -> str:
    if given in NOT_YET:
        return f"kind '{given}' is not in this version; allowed are {', '.join(INPUT_KINDS)}"
    return (
        f"kind '{given}' is given; allowed are {', '.join(INPUT_KINDS)}"
        f"{did_you_mean(given, INPUT_KINDS)}"
    )


def _shown(given: Any) -> str:
    if given is None:
        return "nothing"
    if isinstance(given, dict):
        return "a mapping"
    if isinstance(given, (list, tuple)):
        return "a list"
    text = repr(given)
    return text if len(text) < 60 else text[:57] + "..."


def _model_at(path: tuple[str, ...]) -> type[BaseModel] | None:
    """The model that a key path leads into, where there is one."""
    model: type[BaseModel] | None = Scene
    for part in path:
        if model is None:
            return None
        found = next((f for n, f in model.model_fields.items() if (f.alias or n) == part), None)
        model = _model_in(found.annotation) if found is not None else None
    return model


def _model_in(annotation: Any) -> type[BaseModel] | None:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    models = [m for m in map(_model_in, get_args(annotation)) if m is not None]
    return models[0] if len(models) == 1 else None


def _sibling_keys(path: tuple[str, ...]) -> list[str]:
    model = _model_at(path[:-1])
    if model is not None:
        return [f.alias or n for n, f in model.model_fields.items()]
    if path[:1] in (("input",), ("inputs",)):
        return sorted({n for kind in INPUT_KINDS.values() for n in kind.model_fields})
    if path[:2] == ("network", "changes"):
        return ["length", "radius"]
    return ["from", "to", "length", "radius"] if path[:2] == ("network", "tubes") else []


def _allowed(path: tuple[str, ...]) -> str:
    keys = _sibling_keys(path)
    return f". Allowed here: {', '.join(keys)}" if 0 < len(keys) <= 12 else ""


def _description(path: tuple[str, ...]) -> str:
    model = _model_at(path[:-1])
    if model is None:
        return ""
    found = next((f for n, f in model.model_fields.items() if (f.alias or n) == path[-1]), None)
    if found is None:
        return ""
    examples = [k.example for k in found.metadata if k.__class__.__name__ == "Kind"]
    words = f"; {found.description[0].lower()}{found.description[1:]}" if found.description else ""
    return words + (f", like '{examples[0]}'" if examples else "")
