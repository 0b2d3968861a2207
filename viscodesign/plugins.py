"""Families whose members are files: a new file in the family's folder is a new member.

An installed package adds members as well, by entry points that name a module. Their group
is the dotted name of the folder: ``[project.entry-points."viscodesign.effects"]``.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from functools import cache
from importlib import metadata
from types import ModuleType
from typing import Any, TypeVar

T = TypeVar("T")


def members(package: str, base: type[T]) -> dict[str, type[T]]:
    """Concrete classes of ``base`` defined in the modules of a family, by their `name`.

    Sorted by the class attribute `order` where there is one, then by name. Raises
    `ValueError` where two have the same name.
    """
    found = [
        kind
        for module in _modules(package)
        for _, kind in inspect.getmembers(module, inspect.isclass)
        if issubclass(kind, base)
        and kind.__module__ == module.__name__
        and not inspect.isabstract(kind)
        and "name" in vars(kind)
    ]
    ranked = sorted(found, key=lambda kind: (vars(kind).get("order", 50), vars(kind)["name"]))
    catalogue = {vars(kind)["name"]: kind for kind in ranked}
    if len(catalogue) < len(found):
        listed = ", ".join(f"{kind.__module__}: {vars(kind)['name']}" for kind in ranked)
        raise ValueError(f"two members of {package} have the same name ({listed})")
    return catalogue


def _modules(package: str) -> Iterator[ModuleType]:
    """Modules in a family's folder, then those that installed packages declare."""
    for module in pkgutil.iter_modules(importlib.import_module(package).__path__):
        yield importlib.import_module(f"{package}.{module.name}")
    for point in _entry_points().select(group=package):
        yield importlib.import_module(point.module)


@cache
def _entry_points() -> Any:  # of a type that differs between versions of Python
    """Those of all installed packages: reading them takes as long as importing a family."""
    return metadata.entry_points()
