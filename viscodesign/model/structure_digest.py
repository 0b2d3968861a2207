"""One name for a structure in every process, made of its key and of the code that formulates."""

from __future__ import annotations

import hashlib
import platform
import sys
from collections.abc import Hashable, Iterator
from enum import Enum
from functools import cache
from numbers import Number
from pathlib import Path
from types import CodeType, FunctionType, ModuleType

import casadi as ca
import numpy as np

from viscodesign._version import __version__
from viscodesign.model.structure import ModuleName

PACKAGE = __name__.partition(".")[0]
ROOMS = ("model", "physics", "solve", "postprocess")
"""Whose code makes formulas of a system, or functions of formulas."""
TRUSTED = frozenset({PACKAGE, "casadi", "numpy"}) | sys.stdlib_module_names
"""Packages whose code is told by a version, or by its source."""


class UnnamedPartError(Exception):
    """A structure contains something that has no name outside this process."""


def structure_digest(key: Hashable) -> str | None:
    """The name of the structure with this key (see `structure_of`).

    None where it cannot have one, since it holds code of other packages, or since the package's
    own code is not what its files say.
    """
    source = source_digest()
    if source is None or not is_as_written():
        return None
    versions = (__version__, ca.CasadiMeta.version(), np.__version__, platform.python_version())
    try:
        return hashlib.sha256(repr((versions, source)).encode() + _joined(key)).hexdigest()
    except UnnamedPartError:
        return None


@cache
def source_digest() -> str | None:
    """Digest of the files whose code makes formulas; None where they cannot be read."""
    whole, found = hashlib.sha256(), 0
    try:
        for room in ROOMS:
            for path in sorted((Path(__file__).parents[1] / room).rglob("*.py")):
                whole.update(repr((room, path.name)).encode() + path.read_bytes())
                found += 1
    except OSError:
        return None
    return whole.hexdigest() if found else None


def is_as_written() -> bool:
    """Whether no function of the modules that formulate was replaced from outside."""
    rooms = tuple(f"{PACKAGE}.{room}." for room in ROOMS)
    modules = [m for name, m in tuple(sys.modules.items()) if name.startswith(rooms)]
    return all(_is_trusted(f.__module__) for module in modules for f in _functions(module))


def _functions(module: ModuleType) -> Iterator[FunctionType]:
    """Functions in a module, and in classes of its own."""
    for value in tuple(vars(module).values()):
        is_own = isinstance(value, type) and value.__module__ == module.__name__
        for thing in tuple(vars(value).values()) if is_own else (value,):
            function = thing.fget if isinstance(thing, property) else thing
            if isinstance(function, FunctionType):
                yield function


def _is_trusted(module: str | None) -> bool:
    return module is not None and module.partition(".")[0] in TRUSTED


def _gather(value: object, parts: list[bytes]) -> None:
    """Append bytes that tell a part of a key from every other. Raises `UnnamedPartError`."""
    kind = type(value)
    if kind is tuple:
        parts.append(b"(%d" % len(value))  # type: ignore[arg-type]
        for item in value:  # type: ignore[attr-defined]
            _gather(item, parts)
    elif kind is str or kind is int or (kind is float and value == value) or value is None:
        parts.append(f"{kind.__name__} {value!r}".encode())
    elif isinstance(value, type) and _is_trusted(value.__module__):
        parts.append(f"type {value.__module__} {value.__qualname__}".encode())
    else:
        _gather_others(value, parts)


def _gather_others(value: object, parts: list[bytes]) -> None:
    if isinstance(value, bytes):
        parts += b"bytes", value
    elif isinstance(value, frozenset):
        parts += b"{%d" % len(value), *sorted(_joined(item) for item in value)
    elif isinstance(value, CodeType):
        names = value.co_name, value.co_names, value.co_varnames, value.co_freevars
        _gather((names, value.co_firstlineno, value.co_code, value.co_consts), parts)
    elif isinstance(value, Enum):
        _gather((type(value), value.name), parts)
    elif isinstance(value, ModuleName) and _is_trusted(value):
        _gather(str(value), parts)
    elif value is Ellipsis or (isinstance(value, Number) and value == value):
        parts.append(f"{type(value).__name__} {value!r}".encode())
    else:
        raise UnnamedPartError


def _joined(value: object) -> bytes:
    """The parts as one, from which each can be told."""
    parts: list[bytes] = []
    _gather(value, parts)
    return b"".join(b"%d:" % len(part) + part for part in parts)
