"""Validation errors in the words of a spec, each with file, line and key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from viscodesign.errors import (
    MAX_LISTED_FAULTS,
    Fault,
    described,
    did_you_mean,
    not_among,
)
from viscodesign.scene.cross_checks import cross_check
from viscodesign.scene.effects_choice import EFFECTS, OPTIONS
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.per_inlet import EACH, ONE
from viscodesign.scene.pump import PUMP_KINDS
from viscodesign.scene.reading.allowed_values import allowed_at
from viscodesign.scene.reading.document import (
    ACTUATORS_KEY,
    IGNORED_PREFIX,
    ROBOT_KEY,
    Document,
)
from viscodesign.scene.reading.field_lookup import (
    example_of,
    field_at,
    is_key_of_a_kind,
    keys_beside,
    quantity_of,
)
from viscodesign.scene.several import OWN, SAME
from viscodesign.scene.spec_part import KeyFault, KeyPath
from viscodesign.values.slips import odd_letter

_BOUNDS = {
    "greater_than": ("gt", "above"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "below"),
    "less_than_equal": ("le", "at most"),
}
_EXPECTED = {
    "string_type": "text",
    "string_too_short": "text",
    "string_too_long": "a shorter text",
    "int_type": "an integer",
    "int_parsing": "an integer",
    "int_parsing_size": "an integer",
    "int_from_float": "an integer",
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
KIND_KEYS = (ROBOT_KEY, ACTUATORS_KEY)
"""Keys that make a spec one of another kind."""
_CONVERSIONS = (
    ("diameter", "radius", "half of the diameter"),
    ("radius", "diameter", "twice the radius"),
    ("area", "radius", "the root of area/pi"),
    ("absolute_pressure", "gauge_pressure", "the absolute pressure less the ambient one"),
    ("period", "frequency", "one over the period"),
    ("kinematic_viscosity", "viscosity", "the kinematic viscosity times the density"),
    ("pairs", "count", "twice the number of pairs"),
)
"""Words in a key, those of the quantity that a spec has instead, and how this is computed."""
_SYNONYMS = {
    "e": ("youngs_modulus",),
    "modulus": ("youngs_modulus", "bulk_modulus"),
    "stiffness": ("youngs_modulus", "bulk_modulus"),
    "elastic_modulus": ("youngs_modulus",),
    "rho": ("density",),
    "mu": ("viscosity",),
    "nu": ("poissons_ratio",),
    "material_density": ("density",),
    "number": ("count",),
    "n": ("count",),
    "depth": ("width", "length"),
    "pressure": ("gauge_pressure", "value"),
    "dt": ("output_interval",),
    "time_step": ("output_interval",),
    "end_time": ("duration",),
    "t_end": ("duration",),
    "mass": ("payload",),
    "diameter": ("syringe_diameter",),
    "tubes": ("changes",),
}
"""Names that others give to keys, in lower case."""
_NOT_REPORTED = "default_factory_not_called"
"""A default that depends on another key, whose own fault is reported."""


def explain_validation(error: ValidationError, document: Document) -> list[Fault]:
    """Every fault within a section; of unknown keys that no message lists, the place alone."""
    faults: list[Fault] = []
    for detail in error.errors(include_url=False):
        path = _key_path(detail, document)
        if detail["type"] == "extra_forbidden" and len(faults) >= MAX_LISTED_FAULTS:
            faults.append(Fault("no such key", ".".join(path), *document.place(path)))
        elif detail["type"] != _NOT_REPORTED:
            found = _key_faults(detail, document)
            faults += [_located(f._replace(path=(*path, *f.path)), document) for f in found]
    return faults


def explain_cross_checks(
    valid: Mapping[tuple[str, str | None], Any], document: Document
) -> list[Fault]:
    """Every fault between sections that are valid by themselves."""
    return [_located(complaint, document) for complaint in cross_check(valid)]


def _located(fault: KeyFault, document: Document) -> Fault:
    file, line = document.place(fault.path)
    allowed = fault.allowed or allowed_at(fault.path, document)
    given = document.given(fault.path)
    return Fault(fault.message, ".".join(fault.path), file, line, given, allowed)


def _key_path(detail: ErrorDetails, document: Document) -> KeyPath:
    """The YAML key: pydantic's location without the tags of its unions."""
    path: KeyPath = ()
    for part in map(str, detail["loc"]):
        is_tag = part in (ONE, EACH, OWN, SAME) or part in _kinds_at(path)
        is_tag |= (*path, part) == (EFFECTS, OPTIONS)
        if not is_tag or isinstance(document.given((*path, part)), dict):
            path = (*path, part)
    return path


def _kinds_at(path: KeyPath) -> Mapping[str, Any]:
    """Kinds of the section at a key, by name; none where a section has no kinds."""
    if path == ("pump",):
        return PUMP_KINDS
    is_input = path == ("input",) or (len(path) == 2 and path[0] == "inputs")
    return INPUT_KINDS if is_input else {}


def _key_faults(detail: ErrorDetails, document: Document) -> Iterator[KeyFault]:
    context: dict[str, Any] = detail.get("ctx") or {}
    if "faults" in context:
        yield from context["faults"]
        return
    yield KeyFault((), _message(detail, context, _key_path(detail, document), document))


def _message(
    detail: ErrorDetails, context: dict[str, Any], path: KeyPath, document: Document
) -> str:
    kind, given = detail["type"], detail["input"]
    if kind == "quantity":
        return _invalid_quantity(context, path, document)
    if kind == "missing":
        pair = "; expected a pair" if path[-1].isdigit() else ""
        return "missing" + pair + _description(path, document)
    if kind == "extra_forbidden":
        return _unknown_key(path, document)
    if kind in _BOUNDS:
        return _out_of_bounds(kind, given, context, path, document)
    if kind == "literal_error":
        known = [word.strip("'\" ") for word in context["expected"].replace(" or ", ",").split(",")]
        return not_among(given, known)
    if kind == "union_tag_invalid":
        return "kind " + not_among(str(context.get("tag")), _kinds_at(path))
    if kind == "too_short" and isinstance(given, Mapping):
        return "empty; at least one is needed" + _description(path, document)
    if kind in _EXPECTED:
        expected = f"expected {_EXPECTED[kind]}, got {described(given)}"
        return expected + _description(path, document)
    return f"got {described(given)}; {detail['msg'][0].lower()}{detail['msg'][1:]}"


def _invalid_quantity(context: dict[str, Any], path: KeyPath, document: Document) -> str:
    """A problem of a value, with an example of what its key may have."""
    found = field_at(path, document)
    quantity = quantity_of(found) if found is not None else None
    if found is None or quantity is None:
        return str(context["message"])
    return quantity.explained(str(context["problem"]), example_of(found, quantity))


def _unknown_key(path: KeyPath, document: Document) -> str:
    known = keys_beside(path, document)
    if path[-1].startswith(IGNORED_PREFIX):
        return (
            f"no such key; keys that begin with '{IGNORED_PREFIX}' are ignored at the top level "
            "alone. Move it there, or make it a comment"
        )
    hint = (
        _other_quantity(path[-1], known)
        or _in_another_section(path, document)
        or did_you_mean(path[-1], [*known, *(KIND_KEYS if len(path) == 1 else ())])
        or _in_a_section(path, known, document)
    )
    odd = odd_letter(path[-1])
    stop = "" if hint else "."
    return f"no such key{f' (contains {odd})' if odd else ''}{hint}" + (
        f"{stop} Allowed here: {', '.join(known)}" if known else ""
    )


def _other_quantity(given: str, known: list[str]) -> str:
    """A hint for a key that is another quantity of the same thing, such as a diameter."""
    for word, other, words in _CONVERSIONS:
        for key in known if word in given else ():
            if key in (given.replace(word, other), other, f"tube_{other}"):
                return f"; did you mean '{key}', {words}?"
    meant = next((key for key in _SYNONYMS.get(given.lower(), ()) if key in known), None)
    return f"; did you mean '{meant}'?" if meant else ""


def _in_a_section(path: KeyPath, sections: list[str], document: Document) -> str:
    """A hint for a key that belongs into a section beside it, as it is or as another quantity."""
    for section in sections:
        known = keys_beside((*path[:-1], section, path[-1]), document)
        if path[-1] in known:
            return f"; did you mean '{section}.{path[-1]}'?"
        if hint := _other_quantity(path[-1], known):
            return hint.replace("'", f"'{section}.", 1)
    return ""


def _in_another_section(path: KeyPath, document: Document) -> str:
    """A hint for a key of this name that stands outside of its section, or in one other alone."""
    for depth in range(len(path) - 1):
        outside = (*path[:depth], path[-1])
        around = keys_beside(outside, document)
        if path[-1] in around:
            return f"; did you mean '{'.'.join(outside)}', outside of '{path[depth]}'?"
        if is_key_of_a_kind(path[-1]):  # perhaps it is left from another kind
            continue
        places = [(*path[:depth], name, path[-1]) for name in around if name != path[depth]]
        meant = [place for place in places if path[-1] in keys_beside(place, document)]
        if len(meant) == 1:
            return f"; did you mean '{'.'.join(meant[0])}'?"
    return ""


def _out_of_bounds(
    kind: str, given: Any, context: dict[str, Any], path: KeyPath, document: Document
) -> str:
    """The bound in the unit of a bare number, and the value as it was written."""
    name, words = _BOUNDS[kind]
    found = field_at(path, document)
    quantity = quantity_of(found) if found is not None else None
    is_fraction = quantity is not None and quantity.unit == "1"
    unit = f" {quantity.unit}" if quantity is not None and not is_fraction else ""
    written = document.given(path)
    is_bare = is_fraction and isinstance(written, (int, float)) and name in ("le", "lt")
    percent = f"; a percentage needs its sign, as in '{written:g} %'" if is_bare else ""
    value = written if isinstance(written, (int, float, str)) else given
    return f"must be {words} {context[name]:g}{unit}; got {value!r}{percent}"


def _description(path: KeyPath, document: Document) -> str:
    """What the key means, and an example of its value."""
    found = field_at(path, document)
    if found is None or not found.description:
        return ""
    quantity = quantity_of(found)
    example = f", such as '{example_of(found, quantity)}'" if quantity is not None else ""
    return f"; {found.description[0].lower()}{found.description[1:]}{example}"
