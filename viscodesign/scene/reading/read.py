"""From a YAML file to a scene, with every fault of the file told at once."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.reading.fault_messages import explain, explain_disagreements
from viscodesign.scene.reading.yaml_nodes import Document, parse_scalar, read_document
from viscodesign.scene.scene import Provenance, Scene
from viscodesign.scene.section import VALID, KeyPath

LARGEST_SPEC = 4 << 20
"""In bytes: room for the rows of a table that a resolved spec lists."""


@dataclass(frozen=True)
class KnownEffects:
    """Names that `effects:` may use."""

    names: tuple[str, ...]


def load_scene(
    path: str | Path, overrides: Sequence[str] = (), known: KnownEffects | None = None
) -> Scene:
    """Read, override, validate. Raises `SpecError` with all faults of the file."""
    file = Path(path)
    text = _read(file)
    return parse_scene(text, str(path), file.parent, overrides, known)


def parse_scene(
    text: bytes,
    shown: str = "",
    folder: Path | None = None,
    overrides: Sequence[str] = (),
    known: KnownEffects | None = None,
) -> Scene:
    """The same from the text of a spec; ``folder`` is where its tables lie."""
    document = read_document(text, shown)
    for override in overrides:
        _override(document, override)
    valid: dict[tuple[str, str | None], Any] = {}
    context: dict[str, Any] = {"folder": folder or Path(), VALID: valid}
    if known is not None:
        context |= {"effect_names": known.names}
    try:
        scene = Scene.model_validate(document.data, context=context)
    except ValidationError as error:
        faults = explain(error, document)
        faults += explain_disagreements(_with_defaults(valid, document), document)
        raise SpecError(_in_order([*document.faults, *faults])) from None
    if document.faults:
        raise SpecError(_in_order(document.faults))
    return scene.with_source(Provenance(shown, hashlib.sha256(text).hexdigest()))


def _in_order(faults: Sequence[Fault]) -> list[Fault]:
    """Each fault once, by line."""
    return sorted(dict.fromkeys(faults), key=lambda fault: fault.line or 0)


def _with_defaults(
    valid: dict[tuple[str, str | None], Any], document: Document
) -> dict[tuple[str, str | None], Any]:
    """Valid fields, and the defaults of keys that the spec leaves out."""
    defaults = {
        ("Scene", name): found.get_default(call_default_factory=True)
        for name, found in Scene.model_fields.items()
        if not found.is_required() and (found.alias or name) not in document.data
    }
    return defaults | valid


def _read(file: Path) -> bytes:
    try:
        with file.open("rb") as stream:
            content = stream.read(LARGEST_SPEC + 1)
    except IsADirectoryError:
        raise SpecError([Fault("is a folder; a YAML file is wanted", file=str(file))]) from None
    except FileNotFoundError:
        message = "No such file; write one with 'viscodesign init'"
        raise SpecError([Fault(message, file=str(file))]) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or "no name of a file"
        raise SpecError([Fault(f"cannot be read: {reason}", file=str(file))]) from error
    if len(content) > LARGEST_SPEC:
        raise SpecError([Fault(f"is larger than {LARGEST_SPEC >> 20} MiB", file=str(file))])
    return content


def _override(document: Document, override: str) -> None:
    """Apply `key.path=value`; faults below that key then name the override, not a line."""
    key, equals, value = override.partition("=")
    place = f"--set {override}"
    parts = tuple(key.strip().split("."))
    if not equals or not all(parts):
        raise SpecError([Fault("is not of the form key.path=value", file=place)])
    here: Any = document.data
    for depth, part in enumerate(parts[:-1], start=1):
        here = _entry(here, part, place)
        if not isinstance(here, (dict, list)):
            # A word such as `gravity: on` gives way to the mapping that it stands for.
            here = _put(document, parts[:depth], {}, place)
    if isinstance(here, list):
        _entry(here, parts[-1], place)
    _put(document, parts, parse_scalar(value.strip(), place), place)


def _entry(here: Any, part: str, place: str) -> Any:
    """What a mapping or a list holds there; None where a mapping has no such key."""
    if isinstance(here, dict):
        return here.get(part)
    if not part.isdigit() or int(part) >= len(here):
        raise SpecError([Fault(f"'{part}' is no place in a list of {len(here)}", file=place)])
    return here[int(part)]


def _put(document: Document, path: KeyPath, value: Any, place: str) -> Any:
    """Write a value into the document, in the name of an override."""
    parent = document.given(path[:-1])
    parent[int(path[-1]) if isinstance(parent, list) else path[-1]] = value
    document.overrides[path] = place
    return value
