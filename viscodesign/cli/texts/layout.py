"""Plain text laid out for a terminal, or unwrapped for a pipe.

Not by rich: it costs 0.04 s of every command, cuts or folds words of the first columns on a
narrow terminal, and needs a width in a pipe, where a row has to stay one line.
"""

from __future__ import annotations

import math
import shutil
import sys
import textwrap
from collections.abc import Iterable, Sequence
from pathlib import Path

MIN_COLUMNS = 40
MAX_COLUMNS = 110


def width() -> int | None:
    """Columns to wrap at; None in a pipe, where lines are not wrapped."""
    if not sys.stdout.isatty():
        return None
    return min(max(shutil.get_terminal_size().columns, MIN_COLUMNS), MAX_COLUMNS)


def wrap(text: str, indent: str = "", hanging: str | None = None) -> list[str]:
    """One paragraph as indented lines, no wider than the terminal."""
    columns = width()
    if columns is None:
        return [indent + text]
    return textwrap.wrap(
        text,
        columns,
        initial_indent=indent,
        subsequent_indent=indent if hanging is None else hanging,
        break_long_words=False,
        break_on_hyphens=False,
    )


def table(rows: Sequence[Sequence[str]], indent: str = "  ") -> list[str]:
    """Rows with aligned columns; the last column wraps under itself."""
    return [line for block in blocks(rows, indent) for line in block]


def blocks(rows: Sequence[Sequence[str]], indent: str = "  ") -> list[list[str]]:
    """The lines of each row of a table."""
    sizes = [max(len(row[k]) for row in rows) for k in range(len(rows[0]) - 1)]
    return [_block(row, sizes, indent) for row in rows]


def _block(row: Sequence[str], sizes: Sequence[int], indent: str) -> list[str]:
    cells = (f"{cell:<{size}}  " for cell, size in zip(row[:-1], sizes, strict=True))
    lines = _last_column(indent + "".join(cells), row[-1])
    return [line.rstrip() for line in lines]


def _last_column(head: str, cell: str) -> list[str]:
    columns = width()
    if columns is not None and columns - len(head) >= MIN_COLUMNS // 2:
        return wrap(cell, head, " " * len(head)) or [head]
    return wrap(head + cell, hanging=" " * 6)


def number(value: float | None, unit: str = "") -> str:
    """A number to three digits, with its unit."""
    if value is None or math.isnan(value):
        return "unknown"
    if math.isinf(value):
        return "infinite" if value > 0 else "-infinite"
    return f"{value:.3g} {unit}".rstrip()


def percentage(part: float) -> str:
    """A share in percent, to two digits; in powers of ten below a millionth."""
    value = 100 * part
    return (
        f"{float(f'{value:.2g}'):.10f}".rstrip("0").rstrip(".") + " %"
        if value >= 1e-6
        else (f"{value:.1e} %")
    )


def seconds(time: float) -> str:
    """A time [s] to two digits, in ms below a second."""
    if time < 1.0:
        return f"{float(f'{1e3 * time:.2g}'):g} ms"
    return f"{float(f'{time:.2g}'):g} s"


def and_more(count: int, most: int, file: str) -> list[str]:
    """The line below a list that was cut at ``most`` of ``count``; none where it was not."""
    return [f"  and {count - most} more in {file}"] if count > most else []


def files_row(folder: Path, files: Iterable[Path]) -> tuple[str, str]:
    """What was written."""
    return "files", f"{folder}: {', '.join(file.name for file in files)}"
