"""Tables that grow row by row: in memory while they are small, on the disk beyond.

A file of a table has no name: it vanishes with the last array that reads it, however
the process ends. Its arrays are ordinary ones, read-only, whose pages the system fetches.
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

from viscodesign.errors import ViscodesignError

IN_MEMORY = 8 * 2**20
"""Bytes of one table up to which it stays in memory."""
BLOCK = 4096
"""Rows that are read at once."""
NUMBER = np.dtype(float)


class NoRoomError(ViscodesignError):
    """The disk takes no more rows; those that it took are whole."""


class Shelf:
    """Where the tables of a run go when they are large.

    ``folder``: for their files, the system's own if not given; ``in_memory``: bytes of
    one table up to which it needs no file.
    """

    def __init__(self, folder: Path | None = None, in_memory: int = IN_MEMORY) -> None:
        self.folder = folder
        self.in_memory = in_memory

    def table(self, *row: int) -> Table:
        """An empty table whose rows have this shape."""
        return Table(row, self)


class Table:
    """Rows (n, *row) of numbers."""

    def __init__(self, row: tuple[int, ...], shelf: Shelf) -> None:
        self._row = row
        self._shelf = shelf
        self._row_bytes = int(np.prod(row, dtype=int)) * NUMBER.itemsize
        self._blocks: list[np.ndarray] = []
        self._file: IO[bytes] | None = None
        self._count = 0

    def __len__(self) -> int:
        return self._count

    @property
    def is_on_disk(self) -> bool:
        """Whether it has grown beyond what stays in memory."""
        return self._file is not None

    def append(self, rows: np.ndarray) -> None:
        """Add rows (m, *row), all or none; raises `NoRoomError` where they do not fit."""
        block = np.array(rows, dtype=NUMBER, order="C")
        if self._file is None and self._bytes(len(block)) > self._shelf.in_memory:
            self._move_out()
        if self._file is None:
            self._blocks.append(block)
        else:
            self._write(self._file, block)
        self._count += len(block)

    def cut(self, count: int) -> None:
        """Forget all rows behind the first ``count``."""
        if self._file is None:
            self._blocks = [self._joined()[:count]]
        self._count = min(count, self._count)

    def array(self) -> np.ndarray:
        """All rows (n, *row), read-only where they are on the disk."""
        if self._file is None:
            return self._joined()
        whole = mmap.mmap(self._file.fileno(), self._bytes(), access=mmap.ACCESS_READ)
        return np.ndarray((self._count, *self._row), NUMBER, buffer=whole)

    def _bytes(self, more: int = 0) -> int:
        return (self._count + more) * self._row_bytes

    def _joined(self) -> np.ndarray:
        if len(self._blocks) != 1:
            self._blocks = [np.concatenate([np.zeros((0, *self._row)), *self._blocks])]
        return self._blocks[0]

    def _move_out(self) -> None:
        """From memory to a file without a name."""
        try:
            file = tempfile.TemporaryFile(dir=self._shelf.folder, buffering=0)  # noqa: SIM115
        except OSError as error:
            raise self._no_room(error) from error
        weakref.finalize(self, file.close)
        self._write(file, self._joined())
        self._file, self._blocks = file, []

    def _write(self, file: IO[bytes], block: np.ndarray) -> None:
        """Behind the rows that count, whatever an earlier failure left there."""
        try:
            file.seek(self._bytes() if self._file is not None else 0)
            left = block.reshape(-1).view(np.uint8).data
            while left:
                left = left[file.write(left) :]
        except OSError as error:
            raise self._no_room(error) from error

    def _no_room(self, error: OSError) -> NoRoomError:
        folder = self._shelf.folder or tempfile.gettempdir()
        return NoRoomError(
            f"no room for the run's numbers in {folder}: {error.strerror or error}. Free some "
            "space, use another folder, or write down fewer outputs (run.output_interval)."
        )


def blocks(count: int, *arrays: np.ndarray, rows: int = BLOCK) -> Iterator[slice]:
    """Consecutive slices of up to ``rows`` of ``count`` rows.

    What a step read of these arrays leaves the memory behind it, where it is on the disk.
    """
    for first in range(0, count, rows):
        yield slice(first, min(first + rows, count))
        for array in arrays:
            let_go(array)


def let_go(array: np.ndarray) -> None:
    """Drop the pages of a table on the disk that were read; they come again when asked for."""
    base = array.base
    while isinstance(base, np.ndarray):
        base = base.base
    if isinstance(base, mmap.mmap) and os.name == "posix":
        base.madvise(mmap.MADV_DONTNEED)


def picked(array: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Some rows of a table: wherever they lie, their pages leave the memory again."""
    parts = []
    for some in blocks(len(rows), array, rows=SCATTERED):
        parts.append(array[rows[some]])
    return np.concatenate([array[:0], *parts])


SCATTERED = 256
"""Rows apart from each other that are read at once: each comes with all that is near it."""


def extremes(array: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Smallest and largest of every column of rows (n, ...), n > 0."""
    found = [
        (part.min(axis=0), part.max(axis=0))
        for part in (array[rows] for rows in blocks(len(array), array))
    ]
    return np.min([low for low, _ in found], axis=0), np.max([high for _, high in found], axis=0)
