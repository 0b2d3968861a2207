"""The files of a saved folder as data again."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from viscodesign.errors import UsageError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.folder import SPEC
from viscodesign.scene.reading.sources import ReadSpec, text_spec

FoundT = TypeVar("FoundT")
SpecT = TypeVar("SpecT")


@dataclass(frozen=True)
class SavedTable:
    """A table of numbers."""

    names: list[str]
    values: np.ndarray
    """(n, columns)"""

    def columns(self, names: Iterable[str]) -> np.ndarray:
        """Some columns (n, names)."""
        return np.ascontiguousarray(self.values[:, [self._at(name) for name in names]])

    def _at(self, name: str) -> int:
        if name not in self.names:
            raise ValueError(f"there is no column {name}")
        return self.names.index(name)


def saved_table(file: Path, *, may_be_empty: bool = False) -> SavedTable:
    """A table of numbers; ``may_be_empty``: cells may be, which are NaN then.

    Raises `UsageError` where the file is none, or not whole.
    """
    head, _, body = _text(file).partition("\n")
    names = head.strip().split(",")
    try:
        cells = body.rstrip("\n").replace("\n", ",").split(",")
        if may_be_empty:
            cells = [cell or "nan" for cell in cells]
        values = np.array(cells, dtype=float)
        return SavedTable(names, values.reshape(-1, len(names)))
    except ValueError as error:
        raise UsageError(
            f"{file} is not a whole table ({error}). Simulate the spec again"
        ) from error


def saved_summary(file: Path) -> dict[str, Any]:
    """What `summary.json` says. Raises `UsageError` where it is none."""
    try:
        found = json.loads(_text(file))
    except json.JSONDecodeError as error:
        raise UsageError(f"{file} is not valid JSON ({error}). Simulate the spec again") from error
    if not isinstance(found, dict) or "status" not in found:
        raise UsageError(f"{file} is not the summary of a run. Give the folder of `simulate`")
    return found


def saved_spec(
    folder: Path, summary: Mapping[str, Any], read: Callable[[ReadSpec], SpecT], kind: str
) -> tuple[str, SpecT]:
    """The resolved spec as text and as ``read``, which must be the one that the run was made of.

    ``kind``: what the folder is to hold, as in "no run".
    """
    file = folder / SPEC
    text = _text(file)
    digest = hashlib.sha256(text.encode()).hexdigest()
    if summary.get("resolved_sha256", digest) != digest:
        raise UsageError(
            f"{file} was changed after the run, so the tables beside it are of another spec. "
            "Simulate it again, in a folder of its own"
        )
    try:
        return text, read(text_spec(text.encode(), str(file), file))
    except ViscodesignError as error:
        raise UsageError(f"{folder} holds no {kind} that can be read: {error}") from error


@contextmanager
def fitting_files(folder: Path, remedy: str = "Simulate the spec again") -> Iterator[None]:
    """What is read of a folder's files here must fit together, or a `UsageError` says so."""
    try:
        yield
    except (ValueError, IndexError, KeyError, TypeError) as error:
        raise UsageError(
            f"the files in {folder} do not fit together ({error}). {remedy}"
        ) from error


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")  # line ends of another system become ours
    except (FileNotFoundError, NotADirectoryError) as error:
        raise UsageError(
            f"there is no {file.name} in {file.parent}: expected the folder of a run, such as "
            "`viscodesign simulate` writes"
        ) from error
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"cannot read {file}: {error}") from error


def all_made(kind: type[FoundT], documents: Iterable[Mapping[str, Any]]) -> tuple[FoundT, ...]:
    """Findings from their documents."""
    return tuple(made(kind, document) for document in documents)


def made(kind: type[FoundT], document: Mapping[str, Any]) -> FoundT:
    """A finding from its document, where an infinite number is null."""
    known: Any = fields(kind)  # type: ignore[arg-type]
    given = {field.name: document[field.name] for field in known if field.name in document}
    given = {name: tuple(v) if isinstance(v, list) else v for name, v in given.items()}
    infinite = {
        f.name: math.inf for f in known if f.type == "float" and given.get(f.name, 0) is None
    }
    return kind(**{**given, **infinite})
