"""No module but its own imports an effect or quotes its name."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.architecture import PACKAGE
from viscodesign.effects.catalogue import catalogue

TIES = {"name", "needs", "companion", "free_with", "replaced_by", "considers"}
"""Attributes by which an effect declares itself and its ties to others."""


def quoted(path: Path) -> Iterator[str]:
    """Texts of a module that are neither documentation nor the declared ties of an effect."""
    tree = ast.parse(path.read_text())
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign) and getattr(node.target, "id", "") in TIES:
            silent |= {id(part) for part in ast.walk(node.value or node)}
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and id(node) not in silent
        ):
            yield node.value


def named_in(text: str, name: str) -> bool:
    """Whether a text names an effect, rather than using its words in a sentence."""
    if text == name or re.search(rf"\beffects\.{name}\b", text):
        return True
    return "_" in name and re.search(rf"\b{name}\b", text) is not None


MODULES = [
    path for path in sorted(PACKAGE.rglob("*.py")) if path.relative_to(PACKAGE).parts[0] != "scene"
]


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(PACKAGE)))
def test_no_other_module_names_an_effect(path: Path) -> None:
    place = path.relative_to(PACKAGE).as_posix()
    others = [name for name in catalogue() if place != f"effects/{name}.py"]
    texts = list(quoted(path))
    assert not {name for name in others for text in texts if named_in(text, name)}


@pytest.mark.parametrize("path", MODULES, ids=lambda p: str(p.relative_to(PACKAGE)))
def test_no_other_module_imports_an_effect(path: Path) -> None:
    imported: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            imported |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
    assert not imported & {f"viscodesign.effects.{name}" for name in catalogue()}
