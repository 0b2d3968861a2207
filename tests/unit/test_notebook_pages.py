"""The pages of notebooks have the texts and the code of the notebooks, and what these show."""

from __future__ import annotations

import importlib
import json
import re
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from tests.scenes import ROOT
from tests.trajectories import made_run

DOCS = ROOT / "docs"
NOTEBOOKS = sorted((ROOT / "examples" / "notebooks").glob("*.ipynb"))
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")


@pytest.fixture
def pages(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(DOCS)
    return importlib.import_module("notebook_pages")


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_page_is_its_notebook(pages: ModuleType, file: Path) -> None:
    """Made anew by `python docs/make_notebooks.py`."""
    page = (pages.PAGES / f"{file.stem}.md").read_text(encoding="utf-8")
    at = 0
    for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
        source = "".join(cell["source"])
        is_code = cell["cell_type"] == "code"
        told = f"```python\n{source}\n```" if is_code else pages.page_links(source)
        assert told in page[at:], told
        at = page.index(told, at) + len(told)
    pictures = PICTURE.findall(page)
    assert pictures
    assert all((pages.PAGES / picture).is_file() for picture in pictures)
    assert "base64" not in page
    assert f"](notebooks/{file.stem}.md)" in (DOCS / "notebooks.md").read_text(encoding="utf-8")


def test_no_picture_of_a_page_is_left_behind(pages: ModuleType) -> None:
    texts = "".join(own.read_text(encoding="utf-8") for own in pages.PAGES.glob("*.md"))
    assert {own.name for own in pages.PAGES.glob("*.png")} == set(PICTURE.findall(texts))


def _shown(kind: str, content: str) -> Any:
    return SimpleNamespace(output_type="display_data", get={"data": {kind: content}}.get)


def test_every_kind_of_output_is_shown(pages: ModuleType) -> None:
    kept: list[tuple[str, Any]] = []

    def keep(kind: str, content: Any) -> str:
        kept.append((kind, content))
        return f"{len(kept)}.png"

    study = '<div><table><tr></tr>\n\n  </table><img alt="a study" src="data:image/png;base64,QQ=="></div>'
    outputs = [
        SimpleNamespace(output_type="stream", text="two\nlines\n", get=lambda *_: {}),
        _shown("image/png", "QQ=="),
        _shown("text/html", made_run().page()._repr_html_()),
        _shown("text/html", study),
        _shown("text/plain", "('complete', 61)"),
    ]
    cell = SimpleNamespace(cell_type="code", source="run", get=lambda *_: outputs)
    text = SimpleNamespace(cell_type="markdown", source="[a](../../docs/measuring.md)")
    page = pages.page_of(SimpleNamespace(cells=[text, cell]), keep)
    assert page.split("\n\n") == [
        "[a](../measuring.md)",
        "```python\nrun\n```",
        "```text\ntwo\nlines\n```",
        "![What the cell draws](1.png)",
        "![page of the run leg_made_up](2.png)",
        '<div><table class="docutils"><tr></tr></table></div>',
        "![a study](3.png)",
        "```text\n('complete', 61)\n```\n",
    ]
    assert [kind for kind, _ in kept] == ["png", "frame", "png"]
    assert kept[2][1] == "QQ=="
