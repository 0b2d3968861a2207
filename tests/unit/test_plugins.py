"""Families whose members are files."""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path

import pytest

from viscodesign.plugins import members

BASE = """
from abc import ABC, abstractmethod

class Shape(ABC):
    @abstractmethod
    def area(self): ...
"""
MEMBER = """
from {package}.base import Shape

class {kind}(Shape):
    name = "{name}"
    {order}
    def area(self): return 1
"""


def write_family(folder: Path, package: str) -> None:
    family = folder / package
    family.mkdir()
    (family / "__init__.py").write_text("")
    (family / "base.py").write_text(BASE)
    for name, order in (("late", ""), ("alike", ""), ("first", "order = 1")):
        text = MEMBER.format(package=package, kind=name.title(), name=name, order=order)
        (family / f"{name}.py").write_text(text)
    (family / "half.py").write_text(
        f"from {package}.base import Shape\nclass Half(Shape):\n    name = 'half'\n"
    )


def test_concrete_classes_are_found_in_order(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_family(tmp_path, "family_of_shapes")
    monkeypatch.syspath_prepend(str(tmp_path))
    from family_of_shapes.base import Shape  # type: ignore[import-not-found]

    assert list(members("family_of_shapes", Shape)) == ["first", "alike", "late"]


def test_inputs_and_fluids_are_plugin_families() -> None:
    from viscodesign.scene.fluid import named_fluids
    from viscodesign.scene.input import INPUT_KINDS

    assert set(named_fluids()) == {"air", "glycerol", "glycerol-water", "silicone oil", "water"}
    assert {"constant", "step", "sine", "square", "table"} < set(INPUT_KINDS)


class _Base(ABC):
    @abstractmethod
    def act(self) -> None: ...


def test_a_folder_without_members_is_empty() -> None:
    assert members("viscodesign.scene.fluids", _Base) == {}  # type: ignore[type-abstract]
