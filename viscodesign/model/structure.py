"""The structure of a system: everything but the values of its scene's numbers.

Formulas are made once for a structure and serve every scene that has it, so whatever they are
made of must be part of its key. No list of that is kept: the key covers every attribute that
can be reached from a system, except for fields marked as `SCENE_NUMBER`. Formulas are then
made from a copy in which these fields are NaN, so that none can be used by mistake.
"""

from __future__ import annotations

import copy
import copyreg
import math
from collections.abc import Hashable, Mapping
from dataclasses import fields, is_dataclass, replace
from enum import Enum
from functools import cache
from numbers import Number
from types import FunctionType, MappingProxyType, MethodType
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.model.scene_number import PARAMETER_VALUE, SCENE_NUMBER
from viscodesign.storage.cached_property import cached_property

SX = ca.SX


def structure_of(system: object) -> Hashable:
    """A key that two systems share exactly if they have the same formulas."""
    return Walk().whole(system)


def without_numbers(thing: Any) -> Any:
    """A copy in which scene numbers are NaN; objects without any are not copied."""
    if is_dataclass(thing) and not isinstance(thing, type):
        numbers = _number_fields(thing.__class__)
        held = {f.name: getattr(thing, f.name) for f in fields(thing) if f.init}
        changes = {n: _blank(v) if n in numbers else without_numbers(v) for n, v in held.items()}
        same = all(changes[name] is held[name] for name in held)
        return thing if same else replace(thing, **changes)
    if type(thing) in (tuple, list):
        return type(thing)(without_numbers(item) for item in thing)
    if type(thing) is dict:
        return {key: without_numbers(item) for key, item in thing.items()}
    if type(thing).__module__.partition(".")[0] == __name__.partition(".")[0] and vars(thing):
        blind = copy.copy(thing)
        held = vars(thing).copy()  # another thread may add a cached property
        vars(blind).update((name, without_numbers(value)) for name, value in held.items())
        return blind
    return thing


def _blank(number: Any) -> Any:
    if isinstance(number, np.ndarray):
        return np.array([_blank(own) for own in number.tolist()])
    return math.nan if _counts(number) is None else number


def _counts(number: Any) -> Hashable:
    """The structural part of a scene's number: whether it is absent, zero or infinite.

    Of an array the structural part of every entry.
    """
    if number is None:
        return "absent"
    if isinstance(number, np.ndarray):
        return tuple(_counts(own) for own in number.tolist())
    is_finite = number - number == 0.0  # for any kind of number
    found: Hashable = number if number == 0.0 or not is_finite else None
    return found


class Walk:
    """One pass over everything that can be reached from an object.

    ``known``: objects that need no key, since the caller's own says what they are.
    """

    def __init__(self, *known: object) -> None:
        self._expressions: list[SX] = []
        self._met = {id(thing): -1 - k for k, thing in enumerate(known)}
        self._alive = list(known)

    def whole(self, value: Any) -> Hashable:
        """A key for a value with the expressions in it."""
        key = self.key_of(value)
        if not self._expressions:
            return key, ""
        expressions = SX(ca.veccat(*self._expressions))
        function = ca.Function("all", ca.symvar(expressions), [expressions])
        return key, function.serialize()

    def key_of(self, value: Any) -> Hashable:
        """A key for a value; expressions are gathered, and represented by their sparsity."""
        if isinstance(value, type):
            return self._class(value)
        if value is None or isinstance(value, str | bytes | Number | Enum):
            return type(value), value
        if isinstance(value, SX):
            self._expressions.append(value)
            return SX, _pattern(value)
        if isinstance(value, ca.Function | ca.DM):
            return type(value), value.serialize()
        if type(value) is np.ndarray and not value.dtype.hasobject:
            return np.ndarray, value.dtype.str, value.shape, value.tobytes()
        if type(value) in (dict, MappingProxyType):
            return dict, tuple((self.key_of(k), self.key_of(v)) for k, v in value.items())
        if type(value) in (set, frozenset):
            return set, frozenset(self.key_of(item) for item in value)
        if type(value) in (list, tuple):
            return type(value), tuple(self.key_of(item) for item in value)
        return self._object(value)

    def _class(self, kind: type) -> Hashable:
        return type(kind), kind

    def _function(self, function: FunctionType) -> Hashable:
        parts = (function.__defaults__, function.__kwdefaults__, _closure(function))
        module = ModuleName(function.__module__)
        return FunctionType, module, function.__code__, self.key_of(parts)

    def _met_before(self, value: object) -> Hashable | None:
        """The key of what has one already; None at the first time."""
        if id(value) in self._met:
            return "met", self._met[id(value)]
        self._met[id(value)] = len(self._met)
        self._alive.append(value)
        return None

    def _object(self, value: Any) -> Hashable:
        before = self._met_before(value)
        if before is not None:
            return before
        if isinstance(value, FunctionType):
            return self._function(value)
        if isinstance(value, MethodType):
            return MethodType, self.key_of((value.__func__, value.__self__))
        return self._state(value)

    def _state(self, value: Any) -> Hashable:
        """The key of an object's whole state: what a copy of it would be made of."""
        kind: Any = type(value)
        for name in _derived(kind):
            getattr(value, name)  # or the key would depend on what had been computed before
        try:
            made = value.__reduce_ex__(4)
        except Exception:  # whatever its class raises where it cannot be copied
            return _Unlike()
        if isinstance(made, str):
            return type(value), ModuleName(value.__module__), made
        make, given, state, *items = (*made, None, None, None)[:5]
        if make is copyreg.__newobj__ and isinstance(state, dict):  # type: ignore[attr-defined]
            state = self._attributes(kind, state)
        else:
            state = self.key_of(state)
        listed = [tuple(part) if part is not None else None for part in items]
        return type(value), self.key_of(make), self.key_of((given, *listed)), state

    def _attributes(self, kind: Any, state: Mapping[str, Any]) -> Hashable:
        """Those of a plain object of a class, of which scene numbers do not count."""
        numbers = self._numbers(kind)
        return tuple(
            (name, self.key_of(own) if name not in numbers else numbers[name] and _counts(own))
            for name, own in sorted(state.items())
        )

    def _numbers(self, kind: type) -> dict[str, bool]:
        """The fields of a class that do not count as structure (see `_number_fields`)."""
        return _number_fields(kind)


class ModuleName(str):
    """Where code comes from."""


class _Unlike:
    """The key of what nothing is known to equal: its formulas are never used again."""


def _closure(function: FunctionType) -> tuple[Any, ...]:
    return tuple(cell.cell_contents for cell in function.__closure__ or ())


def _pattern(value: SX) -> Hashable:
    if value.is_scalar(True):
        return (1, 1)
    if value.is_dense():
        return value.shape
    pattern = value.sparsity()
    return value.shape, tuple(pattern.row()), tuple(pattern.colind())


@cache
def _number_fields(kind: type) -> dict[str, bool]:
    """Names of a dataclass' fields of scene numbers, and whether being absent or zero counts."""
    if not is_dataclass(kind):
        return {}
    kinds = {f.name: f.metadata for f in fields(kind)}
    marked = (SCENE_NUMBER, PARAMETER_VALUE)
    return {name: kind == SCENE_NUMBER for name, kind in kinds.items() if kind in marked}


@cache
def _derived(kind: type) -> list[str]:
    """Names of the cached properties of a class."""
    # Copies: another thread may write a lazy method of a base class at this moment.
    bases = [vars(base).copy() for base in reversed(kind.__mro__)]
    named = {name: value for members in bases for name, value in members.items()}
    return sorted(name for name, value in named.items() if isinstance(value, cached_property))
