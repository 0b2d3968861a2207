"""What a spec is read from: a path, an open file, its text, or a mapping."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePath
from typing import Any, Protocol, runtime_checkable

import numpy as np

from viscodesign.errors import Fault, SpecError, described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.reading.document import Document, read_document
from viscodesign.scene.reading.write import plain_part
from viscodesign.scene.reading.yaml_events import MAX_DEPTH, TOO_DEEP
from viscodesign.scene.spec_part import KeyPath, SpecPart
from viscodesign.scene.whole_spec import Provenance

MAX_SPEC_BYTES = 4 << 20
"""Enough for the rows of a table in a resolved spec."""
TEXT = "<text>"
"""What messages call a spec that has no file."""


@runtime_checkable
class OpenFile(Protocol):
    """Anything that is read like a file, as text or as bytes."""

    def read(self, size: int, /) -> str | bytes: ...


SpecSource = str | PurePath | bytes | OpenFile | Mapping[str, Any]
"""A path, text (a string with a line break, or in braces), an open file, or a mapping."""


@dataclass(frozen=True)
class ReadSpec:
    """A spec as it was read, and where from."""

    document: Document
    folder: Path
    """To which the names of its tables are relative."""
    provenance: Provenance | None
    """None where only the resolved spec has a text."""


def read_spec(source: SpecSource) -> ReadSpec:
    """Read a spec from wherever it is. Raises `SpecError`."""
    if isinstance(source, Mapping):
        return ReadSpec(Document("", plain_data(source)), Path(), None)
    if isinstance(source, bytes):
        return text_spec(source, TEXT)
    if isinstance(source, str) and is_text(source):
        return text_spec(source.encode("utf-8", "surrogateescape"), TEXT)
    if isinstance(source, str | PurePath):
        file = Path(source)
        return text_spec(_content(file), str(source), file)
    if isinstance(source, OpenFile):
        return _from_open(source)
    expected = "expected a path, an open file, the text of a spec, or a mapping"
    raise SpecError.plain(f"{expected}; got {described(source)}")


def text_spec(text: bytes, shown: str, file: Path | None = None) -> ReadSpec:
    """A spec from its text, which messages call ``shown``."""
    _check_size(text, shown)
    provenance = Provenance("" if file is None else shown, hashlib.sha256(text).hexdigest())
    folder = Path() if file is None else file.parent
    return ReadSpec(read_document(text, shown), folder, provenance)


def is_text(source: str) -> bool:
    """Whether a string is a spec itself and not the path of one."""
    return not source or "\n" in source or "\r" in source or source.lstrip().startswith("{")


def _from_open(stream: OpenFile) -> ReadSpec:
    name = getattr(stream, "name", "")
    file = Path(name) if isinstance(name, str) and name and not name.startswith("<") else None
    shown = str(name) if file is not None else "standard input" if name == "<stdin>" else TEXT
    try:
        text = stream.read(MAX_SPEC_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: a closed file, or not text
        raise SpecError([Fault(f"cannot be read: {error}", file=shown)]) from error
    content = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else text
    return text_spec(content, shown, file)


def _content(file: Path) -> bytes:
    try:
        with file.open("rb") as stream:
            return stream.read(MAX_SPEC_BYTES + 1)
    except IsADirectoryError:
        raise SpecError([Fault("is a folder; expected a YAML file", file=str(file))]) from None
    except FileNotFoundError:
        message = "No such file; create one with 'viscodesign init'"
        raise SpecError([Fault(message, file=str(file))]) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or "not a file name"
        raise SpecError([Fault(f"cannot be read: {reason}", file=str(file))]) from error


def _check_size(text: bytes, shown: str) -> None:
    if len(text) > MAX_SPEC_BYTES:
        raise SpecError([Fault(f"is larger than {MAX_SPEC_BYTES >> 20} MiB", file=shown)])


def plain_data(given: Mapping[Any, Any]) -> dict[str, Any]:
    """A mapping as YAML would give it: arrays as lists, parts of a scene as mappings."""
    return {key: _plain(value, (key,)) for key, value in _entries(given, ())}


def plain_value_of(value: Any, key: str) -> Any:
    """A value of a key likewise."""
    return _plain(value, (key,))


def _entries(given: Mapping[Any, Any], path: KeyPath) -> list[tuple[str, Any]]:
    for key in given:
        if isinstance(key, bool) or not isinstance(key, str | int):
            raise SpecError([Fault(f"a key must be a word; got {described(key)}", ".".join(path))])
    return [(str(key), value) for key, value in given.items()]


def _plain(value: Any, path: KeyPath) -> Any:
    if len(path) > MAX_DEPTH:
        raise SpecError([Fault(TOO_DEEP, ".".join(path[:4]))])
    if isinstance(value, SpecPart):
        return plain_part(value)
    if isinstance(value, Mapping):
        return {key: _plain(inner, (*path, key)) for key, inner in _entries(value, path)}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, str | bytes):
        return [_plain(inner, (*path, str(k))) for k, inner in enumerate(value)]
    return str(value) if isinstance(value, PurePath) else value
