"""The rooms of the package, their layers, and the imports between them.

`tests/unit/test_architecture.py` holds the imports to this table, and
`docs/make_architecture.py` draws them.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "viscodesign"

# From the top. A module may import from its own room and from those below it. A room is a folder,
# or a module that lies loose in the package; a folder within a room may be a room of its own.
LAYERS = [
    ["cli", "__main__"],
    ["pump.sessions", "pump.report"],
    ["pump.kinds"],
    ["pump.poses"],
    ["pump.ax"],
    ["pump.plunger"],
    ["pump.planning"],
    ["pump.play", "pump.simulated"],
    ["pump.sensors", "pump.boards"],
    ["pump.ax.protocol"],
    ["pump.bus"],
    ["pump"],
    ["inverse", "calibration", "robot"],
    ["comparison"],
    ["studies", "citations"],
    ["compiled"],
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
    ["native"],
    ["storage", "physics"],
    [
        *("units", "values"),
        *("errors", "plugins", "interrupt"),
        *("lazy_dataclass", "lazy_names", "references", "_version"),
    ],
]
RANK = {name: rank for rank, layer in enumerate(LAYERS) for name in layer}
# Front doors: they import lazily, from rooms above what else stands in their folder.
FACADES = ("viscodesign", "viscodesign.pump")

Arrow = tuple[str, str]
"""A room, and another that it imports from."""


@cache
def modules() -> dict[str, Path]:
    """Every module of the package by its dotted name."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def room_of(module: str) -> str:
    """The innermost room that a module stands in; empty for the package itself."""
    parts = module.split(".")[1:]
    names = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((name for name in names if name in RANK), parts[0] if parts else "")


def imports_of(module: str) -> set[str]:
    """Modules of the package that a module imports anywhere, within functions too."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(modules()[module].read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{alias.name}" for alias in node.names} | {node.module}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    return names & set(modules())


def eager_imports_of(module: str) -> set[str]:
    """What importing a module imports at once: not in functions, not for type checks alone.

    Folders do not count, only the modules in them.
    """
    names: set[str] = set()
    for node in ast.parse(modules()[module].read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module:
            names |= {f"{node.module}.{alias.name}" for alias in node.names} | {node.module}
    known = names & set(modules()) - {module}
    return {name for name in known if modules()[name].name != "__init__.py"}


def arrows() -> Counter[Arrow]:
    """How many imports lead from one room to another."""
    found: Counter[Arrow] = Counter()
    for module in modules():
        own = room_of(module)
        if module in FACADES or not own:
            continue
        found.update(
            (own, other) for name in imports_of(module) if (other := room_of(name)) and other != own
        )
    return found


def constants() -> Iterator[tuple[str, str]]:
    """Name and module of every constant in capitals."""
    for module, path in modules().items():
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            targets = node.targets if isinstance(node, ast.Assign) else ()
            if isinstance(node, ast.AnnAssign) and node.value:
                targets = [node.target]
            for target in targets:
                for part in ast.walk(target):
                    if isinstance(part, ast.Name) and part.id.isupper():
                        yield part.id, module
