"""The rows of a study on a disk that takes no more of them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from viscodesign.errors import OutputError
from viscodesign.report.folder import SWEEP_ROWS
from viscodesign.results.sweep_table import DesignResult
from viscodesign.studies.journal import opened

ROWS = [DesignResult(row, "complete", frozenset({"gravity"}), [0.5], "") for row in range(3)]


@contextmanager
def room(size: int) -> Iterator[None]:
    """No file of this process grows beyond a size [byte]."""
    resource = pytest.importorskip("resource", reason="needs the limits of POSIX")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def add_beyond(folder: Path, more: int) -> None:
    """Two rows, and a third for which there are only a few bytes left."""
    with opened(folder, "study", "words") as journal:
        journal.add(ROWS[:2])
        with room((folder / SWEEP_ROWS).stat().st_size + more):
            journal.add(ROWS[2:])


def begin_without_room(folder: Path) -> None:
    with room(0), opened(folder, "study", "words"):
        pass


@pytest.mark.parametrize("more", [0, 1, 20])
def test_rows_that_find_no_room_are_told_by_their_file(tmp_path: Path, more: int) -> None:
    """The last row is written in part, or not at all; those before it are there."""
    with pytest.raises(OutputError, match=rf"cannot write .*{SWEEP_ROWS}: File too large"):
        add_beyond(tmp_path, more)
    for known in (2, 3):
        with opened(tmp_path, "study", "words") as journal:
            assert list(journal.found.values()) == ROWS[:known]
            journal.add(ROWS[known:])


def test_a_journal_that_cannot_even_begin_is_told_likewise(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=f"cannot write .*{SWEEP_ROWS}"):
        begin_without_room(tmp_path)
