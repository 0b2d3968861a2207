"""Tables as CSV, with every digit: reading one gives the same numbers again."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from pydantic_core import to_json

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
    """Rows (n, columns) of numbers alone, each a line; much faster than `csv_table`.

    As JSON writes them, with the fewest digits that give the same number again.
    """
    if not len(values):
        return b""
    text = to_json(values.tolist(), inf_nan_mode="constants")
    return text[2:-2].replace(b"],[", b"\n") + b"\n"
