"""Imports point down the layers, and there is no circle."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.scenes import ROOT

PACKAGE = ROOT / "viscodesign"
# From the top. A module may import from its own room and from those below it. A room is a folder,
# or a module that lies loose in the package; a folder within a room may be a room of its own.
LAYERS = [
    ["cli", "__main__"],
    ["pump.sessions", "pump.report"],
    ["pump.poses", "pump.planning"],
    ["pump.play", "pump.simulated"],
    ["pump.sensors", "pump.boards"],
    ["pump.bus"],
    ["pump"],
    ["studies"],
    ["simulation"],
    ["checks", "loading"],
    ["effects"],
    ["postprocess"],
    ["estimate"],
    ["report"],
    ["scene.reading", "solve"],
    ["scene"],
    ["model"],
    ["results"],
    ["storage", "physics"],
    ["units", "errors", "plugins", "interrupt", "_version"],
]
RANK = {name: rank for rank, layer in enumerate(LAYERS) for name in layer}
# Front doors: they import lazily, from rooms above what else stands in their folder.
FACADES = ("viscodesign", "viscodesign.pump")
# Arrows that still point up, to be mended; none may be added.
ALLOWED_UP: set[tuple[str, str]] = set()


def modules() -> dict[str, Path]:
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports_of(path: Path, known: set[str]) -> set[str]:
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{alias.name}" for alias in node.names} | {node.module}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    return {name for name in names if name in known}


def room_of(module: str) -> str:
    """The innermost room that a module stands in."""
    parts = module.split(".")[1:]
    names = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((name for name in names if name in RANK), parts[0] if parts else "")


@pytest.mark.parametrize("module", [m for m in modules() if m not in FACADES])
def test_imports_point_down(module: str) -> None:
    own = room_of(module)
    assert own in RANK, f"{own} has no layer"
    for name in imports_of(modules()[module], set(modules())):
        other = room_of(name)
        if not other or other == own or (own, other) in ALLOWED_UP:
            continue
        assert RANK[other] >= RANK[own], f"{module} imports {name}, which stands above it"


def test_there_is_no_circle() -> None:
    known = modules()
    eager = {
        name: {n for n in _eager_imports(path, set(known)) if n != name}
        for name, path in known.items()
        if name not in FACADES
    }
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


def _eager_imports(path: Path, known: set[str]) -> set[str]:
    """What a module imports when it is imported: neither in functions nor for types alone."""
    names: set[str] = set()
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.ImportFrom) and node.module in known:
            names.add(node.module)
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{a.name}" for a in node.names} & known
    packages = {n for n in names if (PACKAGE.parent / n.replace(".", "/")).is_dir()}
    return names - packages


def test_the_solver_and_the_balances_name_no_effect() -> None:
    from viscodesign.effects.select import catalogue

    text = "".join(p.read_text() for d in ("solve", "model") for p in (PACKAGE / d).rglob("*.py"))
    assert "viscodesign.effects" not in text
    assert "viscodesign.scene" not in text
    assert not any(f'"{name}"' in text for name in catalogue() if name != "feedback")
