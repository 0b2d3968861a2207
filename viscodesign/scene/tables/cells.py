"""The lines of a table, and the cells of a line."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence

COMMENT_SIGNS = ("#", "%")
DELIMITERS = (";", "\t", "|", ",")
"""Tried in this order; a text without any has columns between spaces."""
SPACES = ""
_NUMERIC = re.compile(r"[-+]?[0-9.,]*[0-9][0-9.,]*(?:[eE][-+]?[0-9]+)?", re.ASCII)


def lines_of(text: str) -> Iterator[tuple[int, int]]:
    """Where each line starts and ends."""
    start = 0
    while start < len(text):
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        yield start, end
        start = end + 1


def delimiter_of(line: str) -> str:
    """What separates the cells of a line: one character, or `SPACES`."""
    words = line.split()
    if len(words) > 1 and all(_NUMERIC.fullmatch(w) and not w.endswith(",") for w in words):
        return SPACES  # commas between digits are decimal signs
    return next((sign for sign in DELIMITERS if sign in line), SPACES)


def split(line: str, delimiter: str) -> list[str]:
    """The cells of a line."""
    if delimiter == SPACES:
        return line.split()
    if '"' not in line:
        return line.split(delimiter)
    return next(csv.reader([line], delimiter=delimiter), [])


def is_numeric(cells: Sequence[str]) -> bool:
    """Whether all cells that are not empty are numbers."""
    return all(_NUMERIC.fullmatch(cell.strip()) for cell in cells if cell.strip())
