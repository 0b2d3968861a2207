"""From a spec to a scene; all faults of the file are reported at once."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from pydantic import ValidationError

from viscodesign.errors import Fault, SpecError, described
from viscodesign.scene.effects_choice import (
    KNOWN_EFFECTS,
    MODE,
    KnownEffects,
    is_effect,
    mapping_of,
)
from viscodesign.scene.reading.document import (
    ACTUATORS_KEY,
    IGNORED_PREFIX,
    ROBOT_KEY,
    Document,
    parse_value,
)
from viscodesign.scene.reading.fault_messages import explain_cross_checks, explain_validation
from viscodesign.scene.reading.sources import (
    ReadSpec,
    SpecSource,
    plain_value_of,
    read_spec,
    text_spec,
)
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.run import OUTPUT_KEYS
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import VALID_FIELDS, KeyPath
from viscodesign.scene.spec_version import version_problem
from viscodesign.scene.table_file import FILE_KEYS
from viscodesign.scene.whole_spec import Provenance, WholeSpec

OVERRIDE_FORM = "must have the form key.path=value"
PYTHON_OVERRIDES = "overrides"
"""Where faults of values are that a script gave."""
Overrides = Sequence[str] | Mapping[str, Any]
"""Texts 'key.path=value', or values by key."""


def load_scene(
    source: SpecSource, overrides: Overrides = (), known: KnownEffects | None = None
) -> Scene:
    """Read a spec, apply overrides and validate. Raises `SpecError` with all faults."""
    return scene_of(read_spec(source), overrides, known)


def parse_scene(
    text: bytes,
    shown: str = "",
    folder: Path | None = None,
    overrides: Overrides = (),
    known: KnownEffects | None = None,
) -> Scene:
    """The scene of a spec's text; ``shown`` names it in faults, ``folder`` has its tables."""
    file = (folder or Path()) / shown if shown else None
    return scene_of(text_spec(text, shown, file), overrides, known)


def scene_of(spec: ReadSpec, overrides: Overrides = (), known: KnownEffects | None = None) -> Scene:
    """The scene of a spec with some keys overridden. Raises `SpecError` with all faults."""
    document = spec.document
    apply_overrides(document, overrides)
    refuse_other_version(document)
    _refuse_other_kinds(document)
    valid: dict[tuple[str, str | None], Any] = {}
    context = {**context_of(spec, known), VALID_FIELDS: valid}
    data = read_keys(document)
    try:
        scene = Scene.model_validate(data, context=context)
    except ValidationError as error:
        faults = explain_validation(error, document)
        faults += explain_cross_checks(_with_defaults(valid, document), document)
        raise SpecError(in_order([*document.faults, *faults])) from None
    if document.faults:
        raise SpecError(in_order(document.faults))
    return with_provenance(scene, spec)


def context_of(spec: ReadSpec, known: KnownEffects | None) -> dict[str, Any]:
    """What validators are told of a spec and of the effects that it may name."""
    if known is None:
        return {"folder": spec.folder}
    spec.document.effects = known
    return {"folder": spec.folder, KNOWN_EFFECTS: known}


def read_keys(document: Document) -> dict[str, Any]:
    """All keys but those that a spec keeps for itself."""
    return {k: v for k, v in document.data.items() if not k.startswith(IGNORED_PREFIX)}


SpecT = TypeVar("SpecT", bound=WholeSpec)


def with_provenance(scene: SpecT, spec: ReadSpec) -> SpecT:
    """A scene with what it was read from, and where its keys stand there.

    Of a scene that no file has, the resolved spec is the first text.
    """
    source = spec.provenance
    if source is None:
        source = Provenance("", resolved_sha256(scene) if isinstance(scene, Scene) else "")
    return scene.with_source(replace(source, places=spec.document.places(source.places)))


def refuse_other_version(document: Document) -> None:
    """Raise `SpecError` for keys of another version: faults of single keys would mislead."""
    problem = version_problem(document.data["spec"]) if "spec" in document.data else ""
    if problem:
        file, line = document.place(("spec",))
        raise SpecError([Fault(problem, "spec", file, line)])


def _refuse_other_kinds(document: Document) -> None:
    """Raise `SpecError` for the spec of a robot or of several actuators.

    Every key of it would be a fault.
    """
    if ROBOT_KEY in document.data:
        file, line = document.place((ROBOT_KEY,))
        message = (
            "this is the spec of a robot; `viscodesign stand`, `walk`, `check`, `classify` and "
            "`simulate` take it (in Python: load_robot)"
        )
        raise SpecError([Fault(message, ROBOT_KEY, file, line)])
    if ACTUATORS_KEY in document.data:
        file, line = document.place((ACTUATORS_KEY,))
        message = (
            "this spec has several actuators; `viscodesign simulate`, `check` and `classify` take "
            "it (in Python: load_several)"
        )
        raise SpecError([Fault(message, ACTUATORS_KEY, file, line)])


def in_order(faults: Sequence[Fault]) -> list[Fault]:
    """Each fault once, sorted by line."""
    return sorted(dict.fromkeys(faults), key=lambda fault: fault.line or 0)


def _with_defaults(
    valid: dict[tuple[str, str | None], Any], document: Document
) -> dict[tuple[str, str | None], Any]:
    """Valid fields, and the defaults of missing keys."""
    defaults = {
        ("Scene", name): found.get_default(call_default_factory=True)
        for name, found in Scene.model_fields.items()
        if not found.is_required() and (found.alias or name) not in document.data
    }
    return defaults | valid


def apply_overrides(document: Document, overrides: Overrides) -> None:
    """Lay overrides over a document, in order."""
    if isinstance(overrides, Mapping):
        for key, value in overrides.items():
            _override(document, str(key), plain_value_of(value, str(key)), PYTHON_OVERRIDES)
        return
    is_one = isinstance(overrides, str) or not isinstance(overrides, Iterable)
    for text in [overrides] if is_one else overrides:
        if not isinstance(text, str):
            raise SpecError([Fault(f"{OVERRIDE_FORM}; got {described(text)}", file="overrides")])
        key, equals, value = text.partition("=")
        place = f"--set {text}"
        if not equals:
            raise SpecError([Fault(OVERRIDE_FORM, file=place)])
        _override(document, key, parse_value(value.strip(), place), place)


def _override(document: Document, key: str, value: Any, place: str) -> None:
    """Set the value at `key.path`; faults below that key name the override instead of a line."""
    parts = tuple(key.strip().split("."))
    if not all(parts):
        raise SpecError([Fault(OVERRIDE_FORM, file=place)])
    if _is_mode_beside_options(document, parts, value):
        parts = (*parts, MODE)
    here: Any = document.data
    for depth, part in enumerate(parts[:-1], start=1):
        here = _entry(here, part, place)
        if not isinstance(here, (dict, list)):
            # A word such as `gravity: on` is replaced by the mapping that it abbreviates.
            here = _put(document, parts[:depth], mapping_of(parts[:depth], here), place)
    if isinstance(here, list):
        _entry(here, parts[-1], place)
    for other in _replaced_by(parts):
        _remove(document, other)
    _put(document, parts, value, place)


def _is_mode_beside_options(document: Document, parts: KeyPath, value: Any) -> bool:
    """Whether a value is an effect's mode alone, and the document states options of the effect."""
    is_mode = is_effect(parts) and not isinstance(value, dict)
    return is_mode and isinstance(document.given(parts), dict)


EXCLUDED_BY = {
    "file": ("rows", "speeds", "measured"),
    "rows": (*FILE_KEYS, "speeds", "measured"),
    "speeds": (*FILE_KEYS, "rows", "measured"),
}
"""Where the rows of a table come from: a loaded scene has them listed, whatever file it had."""


def _replaced_by(path: KeyPath) -> list[KeyPath]:
    """Keys of the file that an override takes the place of."""
    if path[:-1] == ("run",) and path[-1] in OUTPUT_KEYS:
        return [("run", key) for key in OUTPUT_KEYS if key != path[-1]]
    return [(*path[:-1], key) for key in EXCLUDED_BY.get(path[-1], ())] if path[:-1] else []


def _remove(document: Document, path: KeyPath) -> None:
    """Take a key out of the document, unless another override has set it."""
    parent = document.given(path[:-1])
    if isinstance(parent, dict) and path not in document.overrides:
        parent.pop(path[-1], None)


def _entry(here: Any, part: str, place: str) -> Any:
    """The entry of a mapping or a list; None if a mapping has no such key."""
    if isinstance(here, dict):
        return here.get(part)
    if not part.isdigit() or int(part) >= len(here):
        raise SpecError([Fault(f"'{part}' is not an index of a list of {len(here)}", file=place)])
    return here[int(part)]


def _put(document: Document, path: KeyPath, value: Any, place: str) -> Any:
    """Set a value of the document on behalf of an override."""
    parent = document.given(path[:-1])
    parent[int(path[-1]) if isinstance(parent, list) else path[-1]] = value
    document.overrides[path] = place
    return value
