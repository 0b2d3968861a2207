"""Imports point down the layers, and there is no circle."""

from __future__ import annotations

import ast
import importlib
from collections import Counter

import pytest

from tests.architecture import (
    FACADES,
    PACKAGE,
    RANK,
    Arrow,
    constants,
    eager_imports_of,
    imports_of,
    modules,
    room_of,
)

# Arrows that still point up, to be mended; none may be added.
ALLOWED_UP: set[Arrow] = set()
# Plain data with methods that a room above carries out.
WITH_METHODS_ABOVE = {
    "viscodesign.results.notebook_view",
    "viscodesign.results.run_comparison",
    "viscodesign.results.several_runs",
    "viscodesign.results.trajectory",
    "viscodesign.scene.scene",
}


@pytest.mark.parametrize("module", [m for m in modules() if m not in FACADES])
def test_imports_point_down(module: str) -> None:
    own = room_of(module)
    assert own in RANK, f"{own} has no layer"
    for name in imports_of(module):
        other = room_of(name)
        if not other or other == own or (own, other) in ALLOWED_UP:
            continue
        assert RANK[other] >= RANK[own], f"{module} imports {name}, which stands above it"


def test_methods_that_a_room_above_carries_out_stand_in_plain_data() -> None:
    targets = {}
    for name, path in modules().items():
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "module_above":
                (target,) = node.args
                assert isinstance(target, ast.Constant), name
                targets.setdefault(name, set()).add(f"viscodesign.{target.value}")
    assert set(targets) <= WITH_METHODS_ABOVE
    assert set().union(*targets.values()) <= set(modules())


def test_every_room_is_there() -> None:
    assert {room_of(module) for module in modules()} == {*RANK, ""}


def test_there_is_no_circle() -> None:
    eager = {name: eager_imports_of(name) for name in modules() if name not in FACADES}
    done: set[str] = set()

    def visit(name: str, trail: tuple[str, ...]) -> None:
        assert name not in trail, " -> ".join((*trail, name))
        if name in done:
            return
        for other in sorted(eager.get(name, ())):
            visit(other, (*trail, name))
        done.add(name)

    for name in eager:
        visit(name, ())


def test_the_solver_and_the_balances_name_no_effect() -> None:
    from viscodesign.effects.catalogue import catalogue

    text = "".join(p.read_text() for d in ("solve", "model") for p in (PACKAGE / d).rglob("*.py"))
    assert "viscodesign.effects" not in text
    assert "viscodesign.scene" not in text
    assert not any(f'"{name}"' in text for name in catalogue())


def test_solvers_do_not_know_what_the_blocks_of_the_rod_mean() -> None:
    from viscodesign.model.rod_equations import TRAITS

    of_chain = {"position", "angle", "velocity", "acceleration", "elastic_curvature"}
    for path in (PACKAGE / "solve").rglob("*.py"):
        strings = {
            node.value
            for node in ast.walk(ast.parse(path.read_text()))
            if isinstance(node, ast.Constant)
        }
        assert not strings & (of_chain | set(TRAITS)), path
        assert "model.chain" not in path.read_text(), path


def test_class_names_are_unique() -> None:
    names = Counter(
        node.name
        for path in modules().values()
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.ClassDef)
    )
    assert [name for name, count in names.items() if count > 1] == []


def test_a_constant_with_a_number_has_a_name_of_its_own() -> None:
    """In the loops of `native.source`, constants are places in arrays; each array has its own."""
    found: dict[str, list[str]] = {}
    for name, module in constants():
        if not module.startswith("viscodesign.native.source."):
            found.setdefault(name, []).append(module)
    twice = {
        name: {module: getattr(importlib.import_module(module), name) for module in homes}
        for name, homes in found.items()
        if len(homes) > 1
    }
    numbers = {
        name: [module for module, value in values.items() if _is_number(value)]
        for name, values in twice.items()
    }
    several = {name: homes for name, homes in numbers.items() if len(homes) > 1}
    assert several == {}


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
