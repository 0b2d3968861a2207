"""What the pages under docs say of the catalogue is what the catalogue says."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType

import pytest

from tests.scenes import ROOT

DOCS = ROOT / "docs"


@pytest.fixture
def make_pages(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(DOCS)
    return importlib.import_module("make_pages")


def test_the_table_of_effects_is_the_catalogues(make_pages: ModuleType) -> None:
    page = (DOCS / "effects.md").read_text(encoding="utf-8")
    blocks = {name: text for _, name, text in make_pages.blocks_of(page)}
    assert blocks["effects"] == make_pages.effects_table()


def test_every_block_is_filled_and_every_picture_is_there(make_pages: ModuleType) -> None:
    for page in DOCS.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        assert all(block for _, _, block in make_pages.blocks_of(text)), page.name
        for picture in make_pages.PICTURE.findall(text):
            assert (DOCS / picture).is_file(), picture


def test_a_block_that_nobody_makes_is_refused(make_pages: ModuleType, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("<!-- made: nothing -->\n<!-- made: end -->\n")
    with pytest.raises(ValueError, match="asks for nothing"):
        make_pages.fill(page, {})


def test_a_block_is_replaced_and_the_rest_stays(make_pages: ModuleType, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("a\n\n<!-- made: one -->\nold\n<!-- made: end -->\n\nb\n")
    for _ in range(2):
        make_pages.fill(page, {"one": "new"})
        assert page.read_text() == "a\n\n<!-- made: one -->\n\nnew\n\n<!-- made: end -->\n\nb\n"


@pytest.mark.parametrize(
    ("length", "words"),
    [(0.0, "0 mm"), (1e-10, "0 mm"), (1.234e-6, "0.00123 mm"), (0.5, "500 mm"), (0.01234, "12.3 mm")],
)  # fmt: skip
def test_millimetres(make_pages: ModuleType, length: float, words: str) -> None:
    assert make_pages.millimetres(length) == words
