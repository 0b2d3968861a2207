"""From a YAML file to a scene; all faults of the file are reported at once."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.reading.document import Document, parse_value, read_document
from viscodesign.scene.reading.fault_messages import explain_cross_checks, explain_validation
from viscodesign.scene.run import OUTPUT_KEYS
from viscodesign.scene.scene import Provenance, Scene
from viscodesign.scene.spec_part import VALID_FIELDS, KeyPath

MAX_SPEC_BYTES = 4 << 20
"""Enough for the rows of a table in a resolved spec."""


@dataclass(frozen=True)
class KnownEffects:
    """Names that `effects:` may contain."""

    names: tuple[str, ...]


def load_scene(
    path: str | Path, overrides: Sequence[str] = (), known: KnownEffects | None = None
) -> Scene:
    """Read a file, apply overrides and validate. Raises `SpecError` with all faults."""
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
    """The scene of a spec's text; ``shown`` names it in faults, ``folder`` has its tables."""
    document = read_document(text, shown)
    for override in overrides:
        _override(document, override)
    valid: dict[tuple[str, str | None], Any] = {}
    context: dict[str, Any] = {"folder": folder or Path(), VALID_FIELDS: valid}
    if known is not None:
        context |= {"effect_names": known.names}
    try:
        scene = Scene.model_validate(document.data, context=context)
    except ValidationError as error:
        faults = explain_validation(error, document)
        faults += explain_cross_checks(_with_defaults(valid, document), document)
        raise SpecError(_in_order([*document.faults, *faults])) from None
    if document.faults:
        raise SpecError(_in_order(document.faults))
    return scene.with_source(Provenance(shown, hashlib.sha256(text).hexdigest()))


def _in_order(faults: Sequence[Fault]) -> list[Fault]:
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


def _read(file: Path) -> bytes:
    try:
        with file.open("rb") as stream:
            content = stream.read(MAX_SPEC_BYTES + 1)
    except IsADirectoryError:
        raise SpecError([Fault("is a folder; expected a YAML file", file=str(file))]) from None
    except FileNotFoundError:
        message = "No such file; create one with 'viscodesign init'"
        raise SpecError([Fault(message, file=str(file))]) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or "not a file name"
        raise SpecError([Fault(f"cannot be read: {reason}", file=str(file))]) from error
    if len(content) > MAX_SPEC_BYTES:
        raise SpecError([Fault(f"is larger than {MAX_SPEC_BYTES >> 20} MiB", file=str(file))])
    return content


def _override(document: Document, override: str) -> None:
    """Apply `key.path=value`; faults below that key name the override instead of a line."""
    key, equals, value = override.partition("=")
    place = f"--set {override}"
    parts = tuple(key.strip().split("."))
    if not equals or not all(parts):
        raise SpecError([Fault("must have the form key.path=value", file=place)])
    here: Any = document.data
    for depth, part in enumerate(parts[:-1], start=1):
        here = _entry(here, part, place)
        if not isinstance(here, (dict, list)):
            # A word such as `gravity: on` is replaced by the mapping that it abbreviates.
            here = _put(document, parts[:depth], {}, place)
    if isinstance(here, list):
        _entry(here, parts[-1], place)
    for other in _replaced_by(parts):
        _remove(document, other)
    _put(document, parts, parse_value(value.strip(), place), place)


def _replaced_by(path: KeyPath) -> list[KeyPath]:
    """Keys of the file that an override takes the place of."""
    if path[:-1] != ("run",) or path[-1] not in OUTPUT_KEYS:
        return []
    return [("run", key) for key in OUTPUT_KEYS if key != path[-1]]


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
