"""Arrays that grow row by row: in memory while they are small, on disk beyond that.

The file of an array has no name: it vanishes with the last view of it, however the process
ends. What is read is an ordinary numpy array, read-only and memory-mapped.
"""

from __future__ import annotations

import mmap
import os
import tempfile
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import IO

import numpy as np

from viscodesign.errors import OutputError

MAX_BYTES_IN_MEMORY = 8 * 2**20
"""Bytes up to which an array stays in memory."""
DISK_ROWS = 4096
"""Rows that are processed at once."""
FLOAT = np.dtype(float)


class NoRoomError(OutputError):
    """The disk is full; the rows written before are complete."""


class ArrayStore:
    """Where the arrays of a run are stored.

    ``folder``: for their files, the system's temporary folder by default; ``in_memory``:
    bytes up to which an array needs no file.
    """

    def __init__(self, folder: Path | None = None, in_memory: int = MAX_BYTES_IN_MEMORY) -> None:
        self.folder = folder
        self.in_memory = in_memory

    def growing_array(self, *row: int) -> GrowingArray:
        """An empty array whose rows have this shape."""
        return GrowingArray(row, self)


class GrowingArray:
    """Rows (n, *row) of floats."""

    def __init__(self, row: tuple[int, ...], store: ArrayStore) -> None:
        self._row = row
        self._store = store
        self._row_bytes = int(np.prod(row, dtype=int)) * FLOAT.itemsize
        self._blocks: list[np.ndarray] = []
        self._file: IO[bytes] | None = None
        self._count = 0

    def __len__(self) -> int:
        return self._count

    def append(self, rows: np.ndarray) -> None:
        """Add rows (m, *row), all or none; raises `NoRoomError` where they do not fit."""
        block = np.array(rows, dtype=FLOAT, order="C")
        if self._file is None and self._bytes(len(block)) > self._store.in_memory:
            self._move_out()
        if self._file is None:
            self._blocks.append(block)
        else:
            self._write(self._file, block)
        self._count += len(block)

    def cut(self, count: int) -> None:
        """Drop all rows after the first ``count``."""
        if self._file is None:
            self._blocks = [self._joined()[:count]]
        self._count = min(count, self._count)

    def array(self) -> np.ndarray:
        """All rows (n, *row); read-only where they are on disk."""
        if self._file is None:
            return self._joined()
        whole = mmap.mmap(self._file.fileno(), self._bytes(), access=mmap.ACCESS_READ)
        return np.ndarray((self._count, *self._row), FLOAT, buffer=whole)

    def _bytes(self, more: int = 0) -> int:
        return (self._count + more) * self._row_bytes

    def _joined(self) -> np.ndarray:
        if len(self._blocks) != 1:
            self._blocks = [np.concatenate([np.zeros((0, *self._row)), *self._blocks])]
        return self._blocks[0]

    def _move_out(self) -> None:
        """Move the rows from memory to a file without a name."""
        try:
            file = tempfile.TemporaryFile(dir=self._store.folder, buffering=0)  # noqa: SIM115
        except OSError as error:
            raise self._no_room(error) from error
        weakref.finalize(self, file.close)
        self._write(file, self._joined())
        self._file, self._blocks = file, []

    def _write(self, file: IO[bytes], block: np.ndarray) -> None:
        """Write after the valid rows, over whatever an earlier failure left there."""
        try:
            file.seek(self._bytes() if self._file is not None else 0)
            left = block.reshape(-1).view(np.uint8).data
            while left:
                left = left[file.write(left) :]
        except OSError as error:
            raise self._no_room(error) from error

    def _no_room(self, error: OSError) -> NoRoomError:
        folder = self._store.folder or tempfile.gettempdir()
        return NoRoomError(
            f"no space for the arrays of the run in {folder}: {error.strerror or error}. Free some "
            "space, use another folder, or use a larger run.output_interval."
        )


def blocks(count: int, *arrays: np.ndarray, rows: int = DISK_ROWS) -> Iterator[slice]:
    """Consecutive slices of up to ``rows`` of ``count`` rows.

    Pages of ``arrays`` on disk that a step has read are released after it.
    """
    for first in range(0, count, rows):
        yield slice(first, min(first + rows, count))
        for array in arrays:
            release_pages(array)


def release_pages(array: np.ndarray) -> None:
    """Release the memory of an array on disk; its pages are read again when they are needed."""
    base = array.base
    while isinstance(base, np.ndarray):
        base = base.base
    if isinstance(base, mmap.mmap) and os.name == "posix":
        base.madvise(mmap.MADV_DONTNEED)


def rows_at(array: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Copy scattered rows of an array, releasing the pages of one that is on disk."""
    parts = []
    for some in blocks(len(rows), array, rows=SCATTERED_ROWS):
        parts.append(array[rows[some]])
    return np.concatenate([array[:0], *parts])


SCATTERED_ROWS = 256
"""Scattered rows that are read at once; each one brings its neighbours into memory."""


def extremes(array: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Smallest and largest value of every column of rows (n, ...), n > 0."""
    found = [
        (part.min(axis=0), part.max(axis=0))
        for part in (array[rows] for rows in blocks(len(array), array))
    ]
    return np.min([low for low, _ in found], axis=0), np.max([high for _, high in found], axis=0)
