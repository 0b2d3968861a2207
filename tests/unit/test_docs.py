"""The pages agree with the code, and everything they point to exists."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path
from types import ModuleType

import pytest

from tests.architecture import modules, room_of
from tests.scenes import ROOT
from viscodesign.effects.catalogue import catalogue

DOCS = ROOT / "docs"
PAGES = [*ROOT.glob("*.md"), *DOCS.glob("*.md"), ROOT / "tests" / "fuzz" / "README.md"]
PAGES.remove(ROOT / "CHANGELOG.md")  # names what was there once
LINK = re.compile(r"\]\(((?!https?:)[^)#]+)[^)]*\)")
PATH = re.compile(r"`((?:viscodesign|tests|docs|examples|benchmarks|configs)/[\w./]+)`")
PYTHON = re.compile(r"```python\n(.*?)```", re.DOTALL)


@pytest.fixture
def make_pages(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(DOCS)
    return importlib.import_module("make_pages")


def test_the_table_of_effects_lists_the_catalogue(make_pages: ModuleType) -> None:
    page = (DOCS / "effects.md").read_text(encoding="utf-8")
    blocks = {name: text for _, name, text in make_pages.blocks_of(page)}
    assert blocks["effects"] == make_pages.effects_table()


def test_the_page_of_keys_lists_the_models(make_pages: ModuleType) -> None:
    """Filled anew by `python docs/make_pages.py keys`."""
    page = (DOCS / "keys.md").read_text(encoding="utf-8")
    blocks = {name: text for _, name, text in make_pages.blocks_of(page)}
    assert blocks["keys"] == make_pages.keys_tables()


def test_every_key_says_what_it_means(make_pages: ModuleType) -> None:
    rows = [row for _, _, rows in make_pages.sections() for row in rows]
    assert len(rows) > 100
    assert [row[0] for row in rows if not row[1]] == []


def test_keys_that_effects_read_exist(make_pages: ModuleType) -> None:
    keys = {row[0].strip("`") for _, _, rows in make_pages.sections() for row in rows}
    assert {key for effect in catalogue().values() for key in effect.keys} <= keys


def test_every_block_is_filled_and_every_picture_exists(make_pages: ModuleType) -> None:
    for page in DOCS.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        assert all(block for _, _, block in make_pages.blocks_of(text)), page.name
        for picture in make_pages.PICTURE.findall(text):
            assert (DOCS / picture).is_file(), picture


def test_a_block_that_no_code_makes_is_refused(make_pages: ModuleType, tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text("<!-- made: nothing -->\n<!-- made: end -->\n")
    with pytest.raises(ValueError, match="no code makes: nothing"):
        make_pages.fill(page, {})


def test_a_block_is_replaced_and_the_rest_kept(make_pages: ModuleType, tmp_path: Path) -> None:
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


def test_links_lead_to_files() -> None:
    for page in PAGES:
        for target in LINK.findall(page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_paths_that_pages_name_exist() -> None:
    for page in PAGES:
        for path in PATH.findall(page.read_text(encoding="utf-8")):
            assert (ROOT / path).exists(), f"{page.name}: {path}"


def test_what_pages_import_can_be_imported() -> None:
    for page in PAGES:
        for block in PYTHON.findall(page.read_text(encoding="utf-8")):
            for node in ast.walk(ast.parse(block)):
                if isinstance(node, ast.ImportFrom) and str(node.module).startswith("viscodesign"):
                    exec(ast.unparse(node), {})


def test_the_table_of_rooms_lists_every_room(make_pages: ModuleType) -> None:
    page = (DOCS / "architecture.md").read_text(encoding="utf-8")
    blocks = {name: text for _, name, text in make_pages.blocks_of(page)}
    listed = re.findall(r"^\| `([\w.]+)` \|", blocks["rooms"], re.MULTILINE)
    assert set(listed) == {room_of(module) for module in modules()} - {""}
