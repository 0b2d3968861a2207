"""How the text of a table is laid out: comments, header, delimiter."""

from __future__ import annotations

import re

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.tables.cells import (
    COMMENT_SIGNS,
    SPACES,
    delimiter_of,
    is_numeric,
    lines_of,
    split,
)
from viscodesign.scene.tables.preamble import header_below, says_units

NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?", re.ASCII)
_COMMENT_LINE = re.compile(r"^[ \t]*[#%].*$", re.MULTILINE)
_SEPARATOR = re.compile(r"sep=.", re.IGNORECASE)
"""What a spreadsheet writes above a table."""
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
    """A text as a table: its first line that is not a comment is the header, unless it is numeric.

    Then the comment right above it may be the header, as numpy writes it. Where it names no unit,
    the lines right above the first numbers may be the header.
    """
    place, number, last_comment = 0, 1, ""
    for start, end in lines_of(text):
        line, place = text[start:end].strip(), start
        if line and not line.startswith(COMMENT_SIGNS) and not _SEPARATOR.fullmatch(line):
            break
        last_comment = line or last_comment
        number += 1
    else:
        return TableText((), 1, "", 1, ",", 0)
    delimiter = delimiter_of(line)
    cells = split(line, delimiter)
    if is_numeric(cells):
        named = split(last_comment.lstrip("#% \t"), delimiter)
        header = tuple(named) if len(named) == len(cells) else ()
        return TableText(
            header, max(number - 1, 1), _bare(text[place:]), number, delimiter, len(cells)
        )
    if not says_units(cells) and (found := header_below(text[place:])) is not None:
        line_number, body = number + found.line - 1, text[place + found.end :]
        behind_it = number + text.count("\n", place, place + found.end)
        given = (line_number, _bare(body), behind_it, found.delimiter, len(found.cells))
        return TableText(found.cells, *given)
    behind = text.find("\n", place) + 1 or len(text)
    header = tuple(_joined(cells) if delimiter == SPACES else cells)
    return TableText(header, number, _bare(text[behind:]), number + 1, delimiter, len(header))


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
