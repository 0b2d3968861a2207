"""CasADi functions that are called for many rows of arguments, a block of rows at a time."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

BLOCK_ROWS = 64
"""Rows of one call of a mapped function: one such function then serves any number of rows."""


class Bound:
    """A call that reads and writes the same arrays each time, without any conversion.

    The arrays are contiguous and of `float`, each with as many entries as the function has.
    """

    def __init__(
        self, function: ca.Function, arguments: Sequence[np.ndarray], results: Sequence[np.ndarray]
    ) -> None:
        # The buffer knows no more than addresses: whoever drops an array here loses its memory.
        self._kept = (*arguments, *results)
        self._buffer, self._run = function.buffer()
        places = (self._buffer.set_arg, arguments), (self._buffer.set_res, results)
        for place, arrays in places:
            for k, array in enumerate(arrays):
                if array.size:
                    place(k, memoryview(array.reshape(-1)))  # type: ignore[call-arg, arg-type]

    def __call__(self) -> None:
        """Read the arguments, write the results."""
        self._run()


def evaluate_rows(
    many: ca.Function,
    rows: Sequence[np.ndarray],
    sizes: Sequence[int],
    at_once: int | None = None,
) -> list[np.ndarray]:
    """A function that takes so many rows at once, of arguments (m, n) each; results (m, size).

    ``at_once``: BLOCK_ROWS unless told otherwise.
    """
    count, length = len(rows[0]), at_once or BLOCK_ROWS
    given = [_in_blocks(np.asarray(row, dtype=float), length) for row in rows]
    found = [np.zeros((len(given[0]), size)) for size in sizes]
    for begin in range(0, count, length):
        block = slice(begin, begin + length)
        Bound(many, [values[block] for values in given], [values[block] for values in found])()
    return [values[:count] for values in found]


def whole_blocks(count: int) -> int:
    """The number of rows in as many whole blocks as so many rows need."""
    return -(-count // BLOCK_ROWS) * BLOCK_ROWS


def _in_blocks(rows: np.ndarray, length: int) -> np.ndarray:
    """Rows (m, ...), contiguous, the last one repeated up to whole blocks."""
    more = np.repeat(rows[-1:], -len(rows) % length, axis=0)
    return np.ascontiguousarray(np.concatenate([rows, more]))
