"""`dataclass` whose methods are written when they are first called.

The standard one writes and compiles five to seven methods of every class while a module is
imported: a sixth of a short command, most of it for classes of which that command makes nothing.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

TAKEN_NAMES = ("__module__", "__qualname__", "__post_init__")
"""What the methods take from the class besides its fields."""


class LazyMethod:
    """A method of the class ``owner``, replaced by the standard one when it is first looked up."""

    def __init__(self, owner: type, name: str) -> None:
        self._owner, self._name = owner, name

    def __get__(self, instance: object, kind: type | None = None) -> Any:
        method = self._written()
        return method if instance is None else method.__get__(instance, kind)

    def _written(self) -> Any:
        """The standard method, now an attribute of its class."""
        owner, name = self._owner, self._name
        if owner.__dict__[name] is self:  # another thread may have been faster
            setattr(owner, name, _standard(owner, name))
        return owner.__dict__[name]


def _standard(owner: Any, name: str) -> Any:
    """The standard method of a class, taken from another one with the same fields."""
    fields = [(f.name, f.type, f) for f in dataclasses.fields(owner)]
    namespace = {name: getattr(owner, name) for name in TAKEN_NAMES if hasattr(owner, name)}
    model = dataclasses.make_dataclass(
        owner.__name__,
        fields,
        namespace=namespace,
        init=name == "__init__",
        repr=name == "__repr__",
        eq=name in ("__eq__", "__hash__"),
        frozen=owner.__dataclass_params__.frozen,
    )
    return vars(model)[name]


def _lazily(cls: Any, *, frozen: bool = False, eq: bool = True, kw_only: bool = False) -> Any:
    """What the standard decorator does, without any text to compile."""
    explicit_hash = cls.__dict__.get("__hash__")
    lazy = {"__init__", "__repr__", *(["__eq__"] if eq else [])} - set(cls.__dict__)
    # A frozen class may be derived from frozen ones only, which the standard decorator checks.
    has_guards = any(dataclasses.is_dataclass(base) for base in cls.__mro__[1:])
    plain = {"init": False, "repr": False, "eq": False}
    dataclasses.dataclass(cls, **plain, frozen=frozen and has_guards, kw_only=kw_only)
    params = cls.__dataclass_params__
    params.init, params.repr, params.eq, params.frozen = True, True, eq, frozen
    if eq and explicit_hash is None:
        lazy.add("__hash__")
    for name in lazy:
        is_unhashable = name == "__hash__" and not frozen
        setattr(cls, name, None if is_unhashable else LazyMethod(cls, name))
    if frozen and not has_guards:
        _guard(cls)
    return cls


def _guard(cls: Any) -> None:
    """Let nobody set or delete attributes; subclasses may have some of their own."""
    names = {field.name for field in dataclasses.fields(cls)}

    def refuse(instance: object, name: str, verb: str) -> None:
        if type(instance) is cls or name in names:
            raise dataclasses.FrozenInstanceError(f"cannot {verb} field {name!r}")

    def set_attribute(self: object, name: str, value: object) -> None:
        refuse(self, name, "assign to")
        super(cls, self).__setattr__(name, value)

    def delete_attribute(self: object, name: str) -> None:
        refuse(self, name, "delete")
        super(cls, self).__delattr__(name)

    cls.__setattr__, cls.__delattr__ = set_attribute, delete_attribute


if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:

    def dataclass(cls: type | None = None, **options: bool) -> type | Callable[[type], type]:
        """`dataclasses.dataclass`, of whose options it takes frozen, eq and kw_only."""
        if cls is None:
            return lambda own: _lazily(own, **options)
        return _lazily(cls, **options)
