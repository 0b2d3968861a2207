"""Many rows of values of a compiled function."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Any, TypeVar

import numpy as np

from viscodesign.lazy_dataclass import dataclass

Outputs = dict[str, Any]
"""Each output's array over the output times (T,), or its number."""
BatchRow = tuple[Outputs | None, str]
"""Outputs of a row, if it has any, and its status."""
COMPLETE = "complete"
MAX_TOGETHER = 32
"""Rows that are solved side by side: more share what Python costs no further, and leave the
processor's caches."""
MAX_VALUES_TOGETHER = 4_000_000
"""Unknowns at all output times of these rows."""
Row = TypeVar("Row")


@dataclass(frozen=True, eq=False)
class Batch:
    """Outputs of many rows of values."""

    outputs: Outputs
    """Each output with one more axis in front, the rows; NaN where a row failed."""
    status: list[str]
    """Status of every row: "complete", or why it failed."""

    def keys(self) -> Sequence[str]:
        """Names of the outputs."""
        return tuple(self.outputs)

    def __iter__(self) -> Iterator[str]:
        return iter(self.outputs)

    def __len__(self) -> int:
        return len(self.outputs)

    def __getitem__(self, name: str) -> np.ndarray:
        return np.asarray(self.outputs[name])


def batch_of(rows: Sequence[BatchRow], blank: Outputs) -> Batch:
    """A batch of its rows; ``blank``: outputs of one that failed."""
    outputs = {
        name: np.array([(own or blank)[name] for own, _ in rows]).reshape(-1, *np.shape(empty))
        for name, empty in blank.items()
    }
    return Batch(outputs, [status for _, status in rows])


def in_parts(rows: Sequence[Row], numbers: int, workers: int | None) -> list[Sequence[Row]]:
    """Rows in parts of equal size, at least one for each worker.

    ``numbers``: unknowns at all output times of a row.
    """
    most = max(1, min(MAX_TOGETHER, MAX_VALUES_TOGETHER // max(numbers, 1)))
    count = max(-(-len(rows) // most), min(workers or 1, len(rows)))
    ends = [k * len(rows) // count for k in range(count + 1)] if count else []
    return [rows[i:j] for i, j in itertools.pairwise(ends)]
