"""Where a record goes: never over one of a real pump, and into no folder that stays empty."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from viscodesign.errors import PumpError, UsageError
from viscodesign.report.folder import without_empty
from viscodesign.storage.atomic_files import write_errors_as_usage

TABLE, LOG = "record.csv", "log.jsonl"
"""Names of a stream's record and of the log of its bytes."""


def refuse_measured(table: Path, *, force: bool) -> None:
    """Raise `UsageError` where a record of a real pump would be replaced, which no run makes again.

    What a simulated board recorded is replaced, as every result that can be computed again is.
    """
    if not force and is_measured(table):
        raise UsageError(
            f"{table} exists and may hold what a real pump's sensors showed; choose another place, "
            "or overwrite it with --force (force=True in Python)"
        )


def is_measured(table: Path) -> bool:
    """Whether a table is there that no simulated board recorded, as far as is known."""
    # One without a byte is what a full disk left before anything moved.
    holds_any = table.exists() and table.stat().st_size > 0
    return holds_any and _document(table).get("simulated") is not True


def is_of_another(table: Path, resolved_sha256: str) -> bool:
    """Whether a record has to be kept beside one of the resolved spec of this SHA-256."""
    known = _document(table).get("resolved_sha256")
    return is_measured(table) or (table.exists() and known != resolved_sha256)


def _document(table: Path) -> dict[str, Any]:
    """What stands beside a table; empty where nothing does."""
    try:
        found = json.loads(table.with_suffix(".json").read_bytes())
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


class Attempt:
    """A session that is to write a record, and whether it came so far."""

    def __init__(self, folder: Path, log: Path | None) -> None:
        self.log = log or folder / LOG
        self.recording = False
        self._own = log is None
        self._size = self._logged()

    def _logged(self) -> int:
        return self.log.stat().st_size if self.log.exists() else 0

    def clear(self, error: BaseException) -> None:
        """What remains of one that failed: a log of what went over the line, or nothing.

        The message then says where the log is.
        """
        if self.recording or not self._own:
            return
        if isinstance(error, PumpError) and self._logged() > self._size:
            error.args = (f"{error}\nevery byte of this attempt is in {self.log}",)
        elif not self._size:
            self.log.unlink(missing_ok=True)


@contextlib.contextmanager
def attempt(folder: Path, log: Path | None) -> Iterator[Attempt]:
    """A folder for a record and for the log of its bytes, which may be kept elsewhere.

    Where what happens within fails before it records, nothing is left that would not help.
    """
    with without_empty(folder):
        with write_errors_as_usage(folder):
            folder.mkdir(parents=True, exist_ok=True)
        begun = Attempt(folder, log)
        try:
            yield begun
        except BaseException as error:
            begun.clear(error)
            raise
