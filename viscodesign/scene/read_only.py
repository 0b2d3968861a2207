"""Mappings of a spec: dictionaries that are read, copied and written, but not changed in place."""

from __future__ import annotations

from typing import Any, NoReturn, TypeVar

from viscodesign.errors import UsageError

KeyT = TypeVar("KeyT")
ValueT = TypeVar("ValueT")


class UnchangeableError(UsageError, AttributeError):
    """A scene, or a part of one, is not changed but replaced."""


class ReadOnlyDict(dict[KeyT, ValueT]):
    """A dictionary that refuses every change: what was computed of a scene holds for good.

    It equals a plain one, and ``dict(...)``, ``copy()`` and ``|`` make a plain one of it.
    """

    def _refuse(self, *_given: Any, **_named: Any) -> NoReturn:
        raise UnchangeableError(
            "a mapping of a scene is not changed but replaced: scene.replace({'KEY': VALUE}), such "
            "as scene.replace({'effects.gravity': 'off'}), is a new scene, checked like a loaded "
            "one; dict(...) of the mapping is a copy that may be changed"
        )

    __setitem__ = __delitem__ = __ior__ = _refuse
    update = setdefault = pop = popitem = clear = _refuse

    def __reduce__(self) -> tuple[type, tuple[dict[KeyT, ValueT]]]:
        """By its plain copy, as it could not be filled item by item."""
        return type(self), (dict(self),)


def read_only(value: Any) -> Any:
    """A dictionary, and those in it, as ones that refuse a change; any other value as it is."""
    if not isinstance(value, dict):
        return value
    return ReadOnlyDict({key: read_only(own) for key, own in value.items()})
