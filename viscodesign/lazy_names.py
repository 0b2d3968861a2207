"""Imports when something is first asked for: public names of a package, rooms above a method."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping
from typing import Any


def lazy_names(
    package: str, homes: Mapping[str, str]
) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """`__getattr__` and `__dir__` of a package.

    ``homes``: the module that each name comes from, relative to the package.
    """

    def get(name: str) -> object:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = getattr(importlib.import_module(homes[name], package), name)
        setattr(sys.modules[package], name, value)
        return value

    def names() -> list[str]:
        return sorted(sys.modules[package].__all__)

    return get, names


def module_above(name: str) -> Any:
    """A module of the package by its name in it, such as ``report.run_folder``.

    For methods of plain data that a room above carries out, and that a user looks for where the
    data are: `Trajectory.save`. `tests/unit/test_architecture.py` lists the modules that have some.
    """
    return importlib.import_module(f"viscodesign.{name}")
