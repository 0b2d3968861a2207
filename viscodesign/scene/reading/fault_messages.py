"""Validation faults in words of the user, each with file, line and key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from viscodesign.errors import Fault
from viscodesign.scene.cross_checks import disagreements
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.per_inlet import EACH, ONE
from viscodesign.scene.reading.field_lookup import field_at, keys_beside, quantity_of
from viscodesign.scene.reading.yaml_nodes import Document
from viscodesign.scene.section import Complaint, KeyPath, did_you_mean

_BOUNDS = {
    "greater_than": ("gt", "above"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "below"),
    "less_than_equal": ("le", "at most"),
}
_WANTED = {
    "string_type": "a text",
    "string_too_short": "a text",
    "string_too_long": "a shorter text",
    "int_type": "a whole number",
    "int_parsing": "a whole number",
    "int_parsing_size": "a whole number",
    "int_from_float": "a whole number",
    "bool_type": "true or false",
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "tuple_type": "a list",
    "list_type": "a list",
    "too_long": "a pair",
    "too_short": "a pair",
    "union_tag_not_found": "a mapping with the key 'kind'",
}
_SILENT = "default_factory_not_called"
"""A default that waits for another key, whose own fault is told."""


def explain(error: ValidationError, document: Document) -> list[Fault]:
    """Every fault of the parts."""
    return [
        _fault(Complaint((*_key_path(detail, document), *path), message), document)
        for detail in error.errors(include_url=False)
        if detail["type"] != _SILENT
        for path, message in _complaints(detail, document)
    ]


def explain_disagreements(
    valid: Mapping[tuple[str, str | None], Any], document: Document
) -> list[Fault]:
    """Every fault between the parts that are right by themselves."""
    return [_fault(complaint, document) for complaint in disagreements(valid)]


def _fault(complaint: Complaint, document: Document) -> Fault:
    file, line = document.place(complaint.path)
    return Fault(complaint.message, ".".join(complaint.path), file, line)


def _key_path(detail: ErrorDetails, document: Document) -> KeyPath:
    """The YAML key: pydantic's place without the tags of its unions."""
    path: KeyPath = ()
    for part in map(str, detail["loc"]):
        is_tag = (part in INPUT_KINDS and _is_input(path)) or part in (ONE, EACH)
        if not is_tag or isinstance(document.given((*path, part)), dict):
            path = (*path, part)
    return path


def _is_input(path: KeyPath) -> bool:
    return path == ("input",) or (len(path) == 2 and path[0] == "inputs")


def _complaints(detail: ErrorDetails, document: Document) -> Iterator[Complaint]:
    context: dict[str, Any] = detail.get("ctx") or {}
    if "complaints" in context:
        yield from context["complaints"]
        return
    yield Complaint((), _message(detail, context, _key_path(detail, document), document))


def _message(
    detail: ErrorDetails, context: dict[str, Any], path: KeyPath, document: Document
) -> str:
    kind, given = detail["type"], detail["input"]
    if kind == "quantity":
        return str(context["message"])
    if kind == "missing":
        pair = "; a pair is wanted" if path[-1].isdigit() else ""
        return "missing" + pair + _description(path, document)
    if kind == "extra_forbidden":
        return _unknown_key(path, document)
    if kind in _BOUNDS:
        return _out_of_bounds(kind, given, context, path, document)
    if kind == "literal_error":
        known = [word.strip("'\" ") for word in context["expected"].replace(" or ", ",").split(",")]
        return (
            f"{given!r} is given; allowed are {', '.join(known)}{did_you_mean(str(given), known)}"
        )
    if kind == "union_tag_invalid":
        return _input_kind(str(context.get("tag")))
    if kind in _WANTED:
        return f"{_shown(given)} is given; {_WANTED[kind]} is wanted{_description(path, document)}"
    return f"{_shown(given)} is given; {detail['msg'][0].lower()}{detail['msg'][1:]}"


def _input_kind(given: str) -> str:
    allowed = f"allowed are {', '.join(INPUT_KINDS)}"
    return f"kind '{given}' is given; {allowed}{did_you_mean(given, INPUT_KINDS)}"


def _unknown_key(path: KeyPath, document: Document) -> str:
    known = keys_beside(path, document)
    hint = did_you_mean(path[-1], known)
    stop = "" if hint else "."
    return f"no such key{hint}" + (f"{stop} Allowed here: {', '.join(known)}" if known else "")


def _out_of_bounds(
    kind: str, given: Any, context: dict[str, Any], path: KeyPath, document: Document
) -> str:
    """The value as it was written, and the bound in the unit that a bare number has."""
    name, words = _BOUNDS[kind]
    found = field_at(path, document)
    quantity = quantity_of(found) if found is not None else None
    is_fraction = quantity is not None and quantity.unit == "1"
    unit = f" {quantity.unit}" if quantity is not None and not is_fraction else ""
    written = document.given(path)
    is_bare = is_fraction and isinstance(written, (int, float)) and written > 1
    percent = "; a percentage needs its sign, like '50 %'" if is_bare else ""
    shown = written if isinstance(written, (int, float, str)) else given
    return f"{shown!r} is given; allowed are values {words} {context[name]:g}{unit}{percent}"


def _shown(given: Any) -> str:
    if given is None:
        return "nothing"
    if isinstance(given, dict):
        return "a mapping"
    if isinstance(given, (list, tuple)):
        return "a list"
    text = repr(given)
    return text if len(text) < 60 else text[:57] + "..."


def _description(path: KeyPath, document: Document) -> str:
    """What the key is for, and a value that it may have."""
    found = field_at(path, document)
    if found is None or not found.description:
        return ""
    quantity = quantity_of(found)
    example = f", like '{quantity.example}'" if quantity is not None else ""
    return f"; {found.description[0].lower()}{found.description[1:]}{example}"
