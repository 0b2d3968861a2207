"""Tables as CSV, with every digit: reading one gives the same numbers again."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from viscodesign.report.folder import text_bytes


def csv_table(names: Sequence[str], rows: Iterable[Iterable[Any]]) -> bytes:
    """A table of numbers, texts and yes-or-no; NaN is an empty cell."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    writer.writerows([_cell(value) for value in row] for row in rows)
    return text_bytes(text.getvalue())


def _cell(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float) and math.isnan(value):
        return ""
    return value if isinstance(value, str) else repr(value)


def csv_rows(values: np.ndarray) -> bytes:
    """Rows (n, columns) of numbers alone, each a line; much faster than `csv_table`."""
    return "".join([",".join(map(repr, row)) + "\n" for row in values.tolist()]).encode()
