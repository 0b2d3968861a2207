"""A key of effects and inputs by their options and their code.

A name does not tell what was formulated: the class behind it may be defined anew in a notebook, or
hold options that no spec states.
"""

from __future__ import annotations

import operator
from collections.abc import Hashable, Iterable, Iterator
from types import CodeType, FunctionType, ModuleType
from typing import Any

from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import every_effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.structure import Walk
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

PACKAGE = __name__.partition(".")[0]
"""Whose own functions are as they are written; what replaces one is another object."""

INTERNAL = ("__", "_abc_")
"""Beginnings of names that Python itself gives to members of classes."""


def effects_key(quantities: SceneQuantities, effects: Iterable[Effect]) -> Hashable:
    """A key that two sets of effects of equal scenes share exactly if they say the same.

    It has every key of the spec, every option of the effects, and the members of their classes and
    of the scene's kinds of input: a function of this package by its identity, any other one by its
    code, with whatever that names in its own package. Code of third packages counts by its names.
    """
    scene = quantities.scene
    kinds = list(map(type, scene.inputs.values()))
    return scene.digest, _part(quantities, kinds), *(_part(quantities, own) for own in effects)


def _part(quantities: SceneQuantities, own: Effect | list[type[Input]]) -> Hashable:
    """The key of one effect, or of all kinds of input: found once for some quantities."""

    def made() -> tuple[Hashable, object]:
        # Kept beside it, or something else might come to have the same identity.
        return _CodeWalk(quantities, quantities.scene).whole(own), own

    name = "inputs" if isinstance(own, list) else id(own)
    return quantities.remembered(("key", name), made)[0]


def scene_key(scene: Scene) -> Hashable:
    """The key of a scene with all effects of this version, whichever it calls for."""
    quantities = SceneQuantities(scene)
    return effects_key(quantities, every_effect(quantities).values())


class _CodeWalk(Walk):
    """A walk whose key also covers the code of effects and inputs, and all numbers by value."""

    def _numbers(self, kind: type) -> dict[str, bool]:
        del kind
        return {}

    def _class(self, kind: type) -> Hashable:
        """By identity; effects and inputs with the members of all classes that make them up."""
        if not issubclass(kind, Effect | Input):
            return super()._class(kind)
        return self._met_before(kind) or (kind, tuple(map(self._members, kind.__mro__)))

    def _members(self, kind: type) -> Hashable:
        if not issubclass(kind, Effect | Input):
            return _Same((kind,))
        found = vars(kind).copy()  # another thread may write a lazy method
        now = _Same(tuple(found.values()))
        known = _known_members.get(kind)
        if known is not None and known[0] == now:
            return known[1]
        members = {name: own for name, own in found.items() if not name.startswith(INTERNAL)}
        if _package(kind.__module__) != PACKAGE:
            return tuple((name, self.key_of(_plain(own))) for name, own in members.items())
        code = [own for own in map(_plain, members.values()) if type(own) is FunctionType]
        foreign = [self.key_of(own) for own in code if _package(own.__module__) != PACKAGE]
        key = _Same(tuple(members.values())), tuple(foreign)
        if not foreign:
            _known_members[kind] = now, key
        return key

    def _function(self, function: FunctionType) -> Hashable:
        package = _package(function.__module__)
        if package == PACKAGE:
            return _Same((function,))
        named = tuple((name, self._named(value, package)) for name, value in _named_by(function))
        return super()._function(function), named

    def _named(self, value: object, package: str) -> Hashable:
        """The key of what the code of a package names; of a third package its name alone."""
        if isinstance(value, ModuleType):
            return value.__name__
        home = getattr(value, "__module__", None)
        if isinstance(home, str) and _package(home) not in (PACKAGE, package):
            return home, getattr(value, "__qualname__", type(value).__qualname__)
        return self.key_of(value)


@dataclass(frozen=True, eq=False)
class _Same:
    """The key of objects whatever they equal; they live as long as it does."""

    values: tuple[object, ...]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _Same) or len(self.values) != len(other.values):
            return False
        return all(map(operator.is_, self.values, other.values))

    def __hash__(self) -> int:
        return hash(tuple(map(id, self.values)))


_known_members: dict[type, tuple[_Same, Hashable]] = {}
"""Classes of this package whose code is their own: their members, and the key of these."""


def _package(module: str) -> str:
    return module.partition(".")[0]


def _plain(member: Any) -> Any:
    """The function behind a member of a class, or the member itself where there is none."""
    if isinstance(member, classmethod | staticmethod):
        return member.__func__
    if isinstance(member, property):
        return member.fget
    return member.func if isinstance(member, cached_property) else member


def _named_by(function: FunctionType) -> Iterator[tuple[str, Any]]:
    """Globals that the code of a function names, and attributes of modules of its own package."""
    names = sorted(set(_names(function.__code__)))
    for name in names:
        if name in function.__globals__:
            value = function.__globals__[name]
            yield name, value
            if isinstance(value, ModuleType):
                own = {PACKAGE, _package(function.__module__)}
                known = vars(value) if _package(value.__name__) in own else {}
                yield from ((other, known[other]) for other in names if other in known)


def _names(code: CodeType) -> Iterator[str]:
    """Names in the code of a function and of those inside it."""
    yield from code.co_names
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _names(inner)
