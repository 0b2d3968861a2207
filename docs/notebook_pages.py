"""A page of the site for each notebook of `examples/notebooks`: its texts, code and outputs."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

NOTEBOOKS = Path(__file__).parent.parent / "examples" / "notebooks"
PAGES = Path(__file__).parent / "notebooks"
FRAME = re.compile(r"<iframe title=\"([^\"]*)\"")
PICTURE = re.compile(r'<img alt="([^"]*)"[^>]*base64,([^"]+)">')
Keep = Callable[[str, Any], str]
"""Keeps the content of a picture, base64 or the frame of a page; returns its file's name."""


def page_of(book: Any, keep: Keep) -> str:
    """A notebook as Markdown."""
    parts = [part for cell in book.cells for part in cell_parts(cell, keep)]
    return "\n\n".join(parts) + "\n"


def cell_parts(cell: Any, keep: Keep) -> Iterator[str]:
    """Text, or code and what it shows."""
    if cell.cell_type == "markdown":
        yield page_links(cell.source)
        return
    yield f"```python\n{cell.source}\n```"
    for output in cell.get("outputs", []):
        yield from output_parts(output, keep)


def page_links(text: str) -> str:
    """Text whose links to pages of the documentation lead there from a page of a notebook."""
    return text.replace("](../../docs/", "](../")


def output_parts(output: Any, keep: Keep) -> Iterator[str]:
    """What a cell shows: printed lines, a table, a picture, or the page of a run."""
    data = output.get("data", {})
    if output.output_type == "stream":
        yield f"```text\n{output.text.rstrip()}\n```"
    elif "image/png" in data:
        yield f"![What the cell draws]({keep('png', data['image/png'])})"
    elif frame := FRAME.search(data.get("text/html", "")):
        yield f"![{frame[1]}]({keep('frame', data['text/html'])})"
    elif "text/html" in data:
        # Blank lines would end the block of HTML; pictures are files, which the site copies.
        table = re.sub(r"\n\s*", "", PICTURE.sub("", data["text/html"]))
        yield table.replace("<table", '<table class="docutils"')
        for words, content in PICTURE.findall(data["text/html"]):
            yield f"![{words}]({keep('png', content)})"
    else:
        yield f"```text\n{data['text/plain']}\n```"
