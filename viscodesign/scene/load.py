"""From a YAML file to a scene, with every fault of the file told at once."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.explain import explain
from viscodesign.scene.scene import Provenance, Scene
from viscodesign.scene.yaml_text import Document, parse_scalar, read_document

LARGEST_SPEC = 1 << 20


@dataclass(frozen=True)
class KnownEffects:
    """Names that `effects:` may use: of this version, and reserved ones that may be off."""

    names: tuple[str, ...]
    reserved: tuple[str, ...] = ()


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
    context: dict[str, Any] = {"folder": folder or Path()}
    if known is not None:
        context |= {"effect_names": known.names, "reserved_effect_names": known.reserved}
    try:
        scene = Scene.model_validate(document.data, context=context)
    except ValidationError as error:
        raise SpecError(explain(error, document)) from None
    return scene.with_source(Provenance(shown, hashlib.sha256(text).hexdigest()))


def _read(file: Path) -> bytes:
    try:
        if file.is_dir():
            raise SpecError([Fault("is a folder; a YAML file is wanted", file=str(file))])
        if file.stat().st_size > LARGEST_SPEC:
            raise SpecError([Fault("is larger than 1 MiB; no spec is", file=str(file))])
        return file.read_bytes()
    except OSError as error:
        reason = error.strerror or "cannot be read"
        raise SpecError(
            [Fault(f"{reason}; write one with 'viscodesign init'", file=str(file))]
        ) from (error)


def _override(document: Document, override: str) -> None:
    """Apply `key.path=value`; faults below that key then name the override, not a line."""
    key, equals, value = override.partition("=")
    place = f"--set {override}"
    if not equals or not key.strip():
        raise SpecError([Fault("is not of the form key.path=value", file=place)])
    parts = key.strip().split(".")
    here: Any = document.data
    for depth, part in enumerate(parts[:-1]):
        if isinstance(here, list):
            index = int(part) if part.isdigit() else -1
            if not 0 <= index < len(here):
                raise SpecError(
                    [Fault(f"'{part}' is no place in a list of {len(here)}", file=place)]
                )
            here = here[index]
            continue
        if not isinstance(here.get(part), (dict, list)):
            # A word such as `gravity: on` gives way to the mapping that it stands for.
            here[part] = {}
            document.lines.pop(tuple(parts[: depth + 1]), None)
        here = here[part]
    if isinstance(here, list):
        raise SpecError([Fault("a list entry needs its key, like tubes.0.length", file=place)])
    here[parts[-1]] = parse_scalar(value.strip(), place)
    document.overrides[tuple(parts)] = place
