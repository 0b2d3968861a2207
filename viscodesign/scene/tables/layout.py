"""How the text of a table is laid out: comments, header, delimiter."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator

from viscodesign.lazy_dataclass import dataclass

COMMENT_SIGNS = ("#", "%")
DELIMITERS = (";", "\t", "|", ",")
"""Tried in this order; a text without any has columns between spaces."""
SPACES = ""
NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?", re.ASCII)
_NUMERIC = re.compile(r"[-+]?[0-9.,]*[0-9][0-9.,]*(?:[eE][-+]?[0-9]+)?", re.ASCII)
_COMMENT_LINE = re.compile(r"^[ \t]*[#%].*$", re.MULTILINE)
_BRACKETS = re.compile(r"[\[(][^\])]*[\])]")


@dataclass(frozen=True)
class TableText:
    """The text of a table, taken apart."""

    header: tuple[str, ...]
    """Cells of the header; none if the first line has numbers alone."""
    header_line: int
    body: str
    """All lines behind the header; comments in it are empty lines."""
    first_line: int
    """Number of the body's first line in the file."""
    delimiter: str
    """One character, or `SPACES`."""
    columns: int
    """Number of columns of the header, or else of the first line."""


def taken_apart(text: str) -> TableText:
    """A text as a table: its first line that is no comment is the header, unless it is numeric.

    Then the comment right above it may be the header, as numpy writes it.
    """
    place, number, last_comment = 0, 1, ""
    for start, end in _lines(text):
        line, place = text[start:end].strip(), start
        if line and not line.startswith(COMMENT_SIGNS):
            break
        last_comment = line or last_comment
        number += 1
    else:
        return TableText((), 1, "", 1, ",", 0)
    delimiter = _delimiter(line)
    cells = split(line, delimiter)
    if all(_NUMERIC.fullmatch(cell.strip()) for cell in cells if cell.strip()):
        named = split(last_comment.lstrip("#% \t"), delimiter)
        header = tuple(named) if len(named) == len(cells) else ()
        return TableText(
            header, max(number - 1, 1), _bare(text[place:]), number, delimiter, len(cells)
        )
    behind = text.find("\n", place) + 1 or len(text)
    header = tuple(_joined(cells) if delimiter == SPACES else cells)
    return TableText(header, number, _bare(text[behind:]), number + 1, delimiter, len(header))


def _delimiter(line: str) -> str:
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


def _lines(text: str) -> Iterator[tuple[int, int]]:
    """Where each line starts and ends."""
    start = 0
    while start < len(text):
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        yield start, end
        start = end + 1


def _bare(body: str) -> str:
    """A body without its comments, with as many lines."""
    return _COMMENT_LINE.sub("", body) if any(sign in body for sign in COMMENT_SIGNS) else body


def _joined(cells: list[str]) -> list[str]:
    """Words of a header between spaces, each unit in brackets joined to its name."""
    found: list[str] = []
    for cell in cells:
        if found and _BRACKETS.fullmatch(cell):
            found[-1] += f" {cell}"
        else:
            found.append(cell)
    return found
