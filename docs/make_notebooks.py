"""Make `docs/notebooks`: run every notebook of `examples/notebooks`, and write it as a page.

Run `python docs/make_notebooks.py [NUMBER ...]`; it needs playwright and Chromium, as
`make_report.py` does.
"""

from __future__ import annotations

import base64
import html
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

import nbformat
from make_report import screenshot
from nbclient import NotebookClient
from notebook_pages import NOTEBOOKS, PAGES, page_of

LONGEST_CELL_S = 300
FRAME = {"width": 900, "height": 720}
"""Size that the page of a run is shown at [pixel]."""


def main(numbers: list[str]) -> None:
    """Write the pages of notebooks with these numbers, or of all."""
    PAGES.mkdir(exist_ok=True)
    for file in sorted(NOTEBOOKS.glob("*.ipynb")):
        if not numbers or file.stem.partition("_")[0] in numbers:
            write_page(file)


def write_page(file: Path) -> None:
    """Run a notebook in its folder, and write its page and pictures."""
    book = nbformat.read(file, as_version=4)
    client = NotebookClient(
        book, timeout=LONGEST_CELL_S, kernel_name="python3",
        resources={"metadata": {"path": str(NOTEBOOKS)}},
    )  # fmt: skip
    client.execute()
    number = file.stem.partition("_")[0]
    for old in PAGES.glob(f"{number}_*"):
        old.unlink()
    kept: list[Path] = []

    def keep(kind: str, content: Any) -> str:
        picture = PAGES / f"{number}_{len(kept) + 1}.png"
        kept.append(picture)
        if kind == "frame":
            draw_frame(content, picture)
        else:
            picture.write_bytes(base64.b64decode(content))
        return picture.name

    (PAGES / f"{file.stem}.md").write_text(page_of(book, keep), encoding="utf-8")


def draw_frame(frame: str, picture: Path) -> None:
    """The page within a frame, as a browser shows it."""
    (page,) = re.findall(r'srcdoc="([^"]*)"', frame)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "page.html"
        file.write_text(html.unescape(page), encoding="utf-8")
        screenshot(file, picture, FRAME)


if __name__ == "__main__":
    main(sys.argv[1:])
