"""Rows of a table on disk as they are computed, so that a study can go on wherever it ended.

One line of JSON a row, appended and never changed; the first line says whose rows they are. A
line that was being written when the process was killed is cut off when the file is opened again.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import time as clock
from collections.abc import Iterable, Iterator
from io import FileIO
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.report.folder import SWEEP_ROWS
from viscodesign.results.sweep_table import DesignResult
from viscodesign.storage import file_locks
from viscodesign.storage.atomic_files import write_errors_as_usage

LOCK_S = 3.0
"""How long a process that was killed may take to let go of its file [s]."""


class Journal:
    """The rows of one study in its folder; one process at a time."""

    def __init__(self, file: FileIO, path: Path, found: dict[int, DesignResult]) -> None:
        self._file, self._path = file, path
        self.found = found
        """Rows that were there, by their numbers."""

    def add(self, results: Iterable[DesignResult]) -> None:
        """Append rows; they are on the disk when this returns."""
        with write_errors_as_usage(self._path):
            _append(self._file, b"".join(map(_line, results)))
            os.fsync(self._file.fileno())


@contextlib.contextmanager
def opened(folder: Path, study: str, words: str, *, replace: bool = False) -> Iterator[Journal]:
    """The journal of a study; ``study``: what identifies it, ``words``: what it is.

    Raises `UsageError` where the folder holds another study, unless it is to be replaced, or
    where another process is at work on it.
    """
    path = folder / SWEEP_ROWS
    with write_errors_as_usage(path):
        file = path.open("a+b", buffering=0)
    with file:
        _lock(file, folder)
        file.seek(0)
        lines = file.read().splitlines(keepends=True)
        if lines and not lines[-1].endswith(b"\n"):
            lines.pop()
        head = _parsed(lines[0]) if lines else None
        if not isinstance(head, dict) or (head.get("study") != study and replace):
            lines = []
        elif head.get("study") != study:
            raise UsageError(
                f"{folder} holds another sweep: {head.get('words', 'unknown')}. Use another "
                "folder with -o DIR, or --force to replace it"
            )
        # A line that a disk has spoilt is not a row: it is computed again.
        parsed = (_parsed(line) for line in lines[1:])
        results = [_result(line) for line in parsed if _is_row(line)]
        with write_errors_as_usage(path):
            file.truncate(sum(map(len, lines)))
            if not lines:
                _append(file, _json({"study": study, "words": words}))
        yield Journal(file, path, {found.row: found for found in results})


def _append(file: FileIO, text: bytes) -> None:
    """Write all of a text.

    Without a buffer: after a full disk it would be written once more as the file is closed.
    """
    while text:
        text = text[file.write(text) :]


def _lock(file: FileIO, folder: Path) -> None:
    until = clock.monotonic() + LOCK_S
    while True:
        try:
            file_locks.lock_free(file.fileno())
        except OSError:
            if clock.monotonic() >= until:
                raise UsageError(
                    f"{folder}: another process is at work on this sweep; wait for it, or use "
                    "another folder with -o DIR"
                ) from None
            clock.sleep(0.1)
        else:
            return


def _parsed(line: bytes) -> Any:
    try:
        return json.loads(line)
    except ValueError:
        return None


def _line(found: DesignResult) -> bytes:
    metrics = [None if math.isnan(value) else value for value in found.metrics]
    return _json([found.row, found.status, sorted(found.effects), metrics, found.failure])


def _json(document: Any) -> bytes:
    return json.dumps(document, separators=(",", ":")).encode() + b"\n"


def _is_row(line: Any) -> bool:
    return isinstance(line, list) and len(line) == 5 and isinstance(line[3], list)


def _result(line: Any) -> DesignResult:
    row, status, effects, metrics, failure = line
    values = [math.nan if value is None else value for value in metrics]
    return DesignResult(row, status, frozenset(effects), values, failure)
