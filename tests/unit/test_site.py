"""The site builds without a warning, and the tutorial can be followed word by word."""

from __future__ import annotations

import importlib
import inspect
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

import viscodesign
import viscodesign.pump
from tests.scenes import ROOT

DOCS = ROOT / "docs"
NOT_LISTED = {"SpecPart", "ViscodesignError"}
"""Bases whose members are no matter of a user's."""
BLOCK = re.compile(r"```(sh|text|python)\n(.*?)```", re.DOTALL)


def test_the_site_builds_without_a_warning(tmp_path: Path) -> None:
    pytest.importorskip("furo", reason="the site needs the extra docs")
    words = ["-W", "--keep-going", "-q", "-b", "html", "-d", str(tmp_path / "trees")]
    site = tmp_path / "site"
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", *words, str(DOCS), str(site)],
        cwd=ROOT, capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert {page.stem for page in DOCS.glob("*.md")} <= {page.stem for page in site.glob("*.html")}
    reference = (site / "api.html").read_text(encoding="utf-8")
    public = [name for name in viscodesign.__all__ if name[0] != "_"]
    assert all(f'id="viscodesign.{name}"' in reference for name in public)
    assert [name for name in _members(public) if f'id="viscodesign.{name}"' not in reference] == []
    assert not re.search(r'(?:src|href)="https?:[^"]*\.(?:js|css|woff2?|png)', reference)


def _members(public: list[str]) -> Iterator[str]:
    """Fields, properties and methods of our own classes, with those of their bases of ours."""
    things = {name: getattr(viscodesign, name) for name in public}
    for name, thing in things.items():
        for base in thing.__mro__ if inspect.isclass(thing) else ():
            if base.__module__.startswith("viscodesign") and base.__name__ not in NOT_LISTED:
                own = (*vars(base).get("__annotations__", {}), *vars(base))
                yield from (f"{name}.{m}" for m in own if m[0] != "_" and "model_" not in m)


def test_every_public_name_is_documented() -> None:
    for module in (viscodesign, viscodesign.pump):
        for name in module.__all__:
            thing = getattr(module, name)
            if inspect.isclass(thing) or inspect.isfunction(thing):
                assert (thing.__doc__ or "").strip(), name


@pytest.mark.parametrize(("page", "block"), [("commands", "commands"), ("api", "names")])
def test_a_page_of_reference_is_up_to_date(
    page: str, block: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Filled anew by `python docs/make_pages.py commands api`."""
    monkeypatch.syspath_prepend(DOCS)
    make_pages: ModuleType = importlib.import_module("make_pages")
    table: ModuleType = importlib.import_module("commands_table")
    made = {"commands": table.commands, "names": table.public_names}[block]
    text = (DOCS / f"{page}.md").read_text(encoding="utf-8")
    blocks = {name: content for _, name, content in make_pages.blocks_of(text)}
    assert blocks[block] == "\n\n".join(made()).strip()


def test_the_tutorial_can_be_followed(tmp_path: Path) -> None:
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    text = (DOCS / "tutorial.md").read_text(encoding="utf-8")
    found = BLOCK.findall(text)
    assert [kind for kind, _ in found].count("sh") > 6
    for kind, block in found:
        if kind == "text":
            (tmp_path / "trace.csv").write_text(block)
            continue
        lines = [["-c", block]] if kind == "python" else []
        if kind == "sh":
            lines = [["-m", *shlex.split(line)] for line in block.strip().splitlines()]
        for words in lines:
            done = subprocess.run(
                [sys.executable, *words], cwd=tmp_path, env=env, capture_output=True, text=True
            )
            assert done.returncode == 0, (words, done.stdout, done.stderr)
            assert "Traceback" not in done.stderr
