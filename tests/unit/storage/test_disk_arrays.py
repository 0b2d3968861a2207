"""Arrays that go to disk are what they were in memory, and leave nothing behind."""

from __future__ import annotations

import errno
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from viscodesign.storage.disk_arrays import (
    ArrayStore,
    GrowingArray,
    NoRoomError,
    blocks,
    extremes,
    release_pages,
)

ROWS = np.arange(60.0).reshape(20, 3)


def filled(store: ArrayStore, *sizes: int) -> GrowingArray:
    """A table of the rows above, appended in pieces."""
    table = store.growing_array(3)
    for part in np.split(ROWS, np.cumsum(sizes)):
        table.append(part)
    return table


@pytest.mark.parametrize("in_memory", [0, 100, 10_000])
@pytest.mark.parametrize("sizes", [(), (1,), (5, 5, 9), (0, 20)])
def test_rows_come_back_as_they_were(in_memory: int, sizes: tuple[int, ...]) -> None:
    table = filled(ArrayStore(in_memory=in_memory), *sizes)
    assert (table._file is not None) == (in_memory < ROWS.nbytes)
    assert len(table) == 20
    assert np.array_equal(table.array(), ROWS)


def test_what_is_appended_may_change_afterwards() -> None:
    table, rows = ArrayStore().growing_array(3), ROWS.copy()
    table.append(rows)
    rows[:] = 0.0
    assert np.array_equal(table.array(), ROWS)


def test_rows_without_columns_need_no_disk() -> None:
    table = ArrayStore(in_memory=0).growing_array(0)
    table.append(np.zeros((5, 0)))
    assert table.array().shape == (5, 0)


@pytest.mark.parametrize("in_memory", [0, 10_000])
def test_an_array_that_was_cut_can_grow_again(in_memory: int) -> None:
    table = filled(ArrayStore(in_memory=in_memory))
    table.cut(7)
    table.append(ROWS[:2])
    assert np.array_equal(table.array(), np.concatenate([ROWS[:7], ROWS[:2]]))


def test_the_file_is_invisible_in_its_folder(tmp_path: Path) -> None:
    table = filled(ArrayStore(tmp_path, in_memory=0))
    found = table.array()
    del table
    assert not list(tmp_path.iterdir())
    assert np.array_equal(found, ROWS)
    with pytest.raises(ValueError, match="read-only"):
        found[0] = 1.0


def test_released_pages_are_read_again() -> None:
    found = filled(ArrayStore(in_memory=0)).array()
    for array in (found, found[3:].T, ROWS):
        before = array.copy()
        release_pages(array)
        assert np.array_equal(array, before)


def test_blocks_cover_all_rows_once() -> None:
    for count in (0, 1, 6, 7, 20):
        seen = [k for rows in blocks(count, ROWS, rows=7) for k in range(count)[rows]]
        assert seen == list(range(count))


def test_extremes_are_those_of_the_columns() -> None:
    many = np.random.default_rng(1).normal(size=(10_000, 3))
    low, high = extremes(many)
    assert np.array_equal(low, many.min(axis=0))
    assert np.array_equal(high, many.max(axis=0))


MAKE_FILE = tempfile.TemporaryFile


class Full:
    """A disk with room for so many bytes."""

    def __init__(self, room: int) -> None:
        self.room = room
        self.file: Any = None

    def __call__(self, **_: Any) -> Full:
        self.file = MAKE_FILE(buffering=0)
        return self

    def write(self, content: memoryview) -> int:
        fits = min(len(content), self.room)
        if not fits:
            raise OSError(errno.ENOSPC, "No space left on device")
        self.room -= fits
        return self.file.write(content[:fits])

    def __getattr__(self, name: str) -> Any:
        return getattr(self.file, name)


def test_a_full_disk_keeps_the_rows_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("viscodesign.storage.disk_arrays.tempfile.TemporaryFile", Full(300))
    table = ArrayStore(Path("somewhere"), in_memory=0).growing_array(3)
    table.append(ROWS[:10])
    with pytest.raises(NoRoomError, match=r"in somewhere: No space left.*Free some space"):
        table.append(ROWS[10:])
    assert np.array_equal(table.array(), ROWS[:10])
