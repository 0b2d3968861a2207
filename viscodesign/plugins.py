"""Families whose members are files: whoever adds a file adds a member."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from typing import TypeVar

T = TypeVar("T")


def members(package: str, base: type[T]) -> dict[str, type[T]]:
    """Concrete classes of ``base`` defined in the modules of a package, by their `name`.

    Sorted by the class attribute `order` where there is one, then by name.
    """
    found: list[type[T]] = []
    for module in pkgutil.iter_modules(importlib.import_module(package).__path__):
        loaded = importlib.import_module(f"{package}.{module.name}")
        found += [
            kind
            for _, kind in inspect.getmembers(loaded, inspect.isclass)
            if issubclass(kind, base)
            and kind.__module__ == loaded.__name__
            and not inspect.isabstract(kind)
            and "name" in vars(kind)
        ]
    ranked = sorted(found, key=lambda kind: (vars(kind).get("order", 50), vars(kind)["name"]))
    return {vars(kind)["name"]: kind for kind in ranked}
