"""Methods of plain data that a room above carries out, imported when they are first called."""

from __future__ import annotations

import importlib
from typing import Any


def module_above(name: str) -> Any:
    """A module of the package by its name in it, such as ``report.run_folder``.

    For a method like `Trajectory.save` alone, which a user looks for where the data are:
    `tests/unit/test_architecture.py` lists the classes that may have some.
    """
    return importlib.import_module(f"viscodesign.{name}")
