"""The library as a user meets it: its names, what they document, and the page about it."""

from __future__ import annotations

import ast
import dataclasses
import importlib
import inspect
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import viscodesign
from tests.scenes import CONFIGS, ROOT

PAGE = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
DATA = [
    getattr(viscodesign, name)
    for name in viscodesign.__all__
    if dataclasses.is_dataclass(getattr(viscodesign, name))
]


def test_the_public_names_are_listed() -> None:
    assert {"load", "simulate", "Trajectory", "Scene", "SpecError"} <= set(dir(viscodesign))
    assert set(dir(viscodesign)) == set(viscodesign.__all__)


def test_a_fresh_import_lists_them_too_and_loads_nothing() -> None:
    program = "import sys, viscodesign; print(dir(viscodesign)); print('numpy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines() == [str(sorted(viscodesign.__all__)), "False"]


@pytest.mark.parametrize("name", viscodesign.__all__)
def test_every_public_name_is_there_and_documented(name: str) -> None:
    found = getattr(viscodesign, name)
    assert name == "__version__" or (inspect.getdoc(found) or "").strip()


def test_names_that_do_not_exist_are_refused() -> None:
    with pytest.raises(AttributeError, match="no attribute 'simulat'"):
        viscodesign.simulat  # noqa: B018


def parts_of(kind: Any) -> Iterator[Any]:
    """A dataclass and all that its fields hold."""
    pending, found = [kind], []
    while pending:
        one = pending.pop()
        if one in found:
            continue
        found.append(one)
        module = importlib.import_module(one.__module__)
        words = " ".join(str(f.type) for f in dataclasses.fields(one))
        for word in set(re.findall(r"[A-Z]\w+", words)):
            part = getattr(module, word, None)
            if inspect.isclass(part) and dataclasses.is_dataclass(part):
                pending.append(part)
    return iter(found)


def undocumented(kind: Any) -> list[str]:
    """Fields of a dataclass without a text below them, or a remark beside them."""
    source = inspect.getsource(kind)
    body = ast.parse(inspect.cleandoc("\n" + source)).body[0]
    assert isinstance(body, ast.ClassDef)
    lines = source.splitlines()
    missing = []
    for node, after in zip(body.body, [*body.body[1:], None], strict=True):
        if not isinstance(node, ast.AnnAssign):
            continue
        is_told = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
        if not is_told and "#" not in lines[node.lineno - 1]:
            missing.append(ast.unparse(node.target))
    return missing


@pytest.mark.parametrize(
    "kind", [k for k in DATA if k.__name__ in ("Trajectory", "AccuracyStudy", "Check", "Batch")]
)
def test_every_field_says_what_it_is(kind: Any) -> None:
    for part in parts_of(kind):
        if part.__module__.startswith("viscodesign.results") or part is kind:
            assert undocumented(part) == [], part.__name__


def test_types_are_shipped() -> None:
    assert (Path(viscodesign.__file__).parent / "py.typed").is_file()


def test_the_examples_of_the_page_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from matplotlib import pyplot

    spec = (CONFIGS / "leg_4_air.yaml").read_text(encoding="utf-8")
    (tmp_path / "leg.yaml").write_text(spec, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert len(BLOCKS) >= 8
    known: dict[str, Any] = {}
    for block in BLOCKS:
        exec(compile(block, "docs/library.md", "exec"), known)
    pyplot.close("all")
    assert (tmp_path / "runs" / "mine" / "summary.json").exists()
    assert (tmp_path / "tip.pdf").exists()
