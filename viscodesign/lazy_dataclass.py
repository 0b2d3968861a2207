"""`dataclass` whose methods are written when they are first called.

The standard one writes and compiles five to seven methods of every class while a module is
imported: a sixth of a short command, most of it for classes of which that command makes nothing.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any


class LazyMethod:
    """A method of the class ``owner``, written when it is first looked up."""

    def __init__(self, owner: type, name: str) -> None:
        self._owner, self._name = owner, name

    def __get__(self, instance: object, kind: type | None = None) -> Any:
        method = self._written()
        return method if instance is None else method.__get__(instance, kind)

    def _written(self) -> Any:
        """The standard method, now an attribute of its class."""
        owner, name = self._owner, self._name
        if owner.__dict__[name] is self:  # another thread may have been faster
            setattr(owner, name, _method(owner, name))
        return owner.__dict__[name]


def _method(owner: Any, name: str) -> Any:
    """A method of a class: `__init__`, or a standard one of another class with the same fields."""
    if name == "__init__":
        return _init(owner)
    fields = [(f.name, f.type, f) for f in dataclasses.fields(owner)]
    model = dataclasses.make_dataclass(
        owner.__name__,
        fields,
        namespace={"__qualname__": owner.__qualname__, "__module__": owner.__module__},
        init=False,
        repr=name == "__repr__",
        eq=name in ("__eq__", "__hash__"),
        unsafe_hash=name == "__hash__",
    )
    return vars(model)[name]


def _init(owner: Any) -> Any:
    """What the standard decorator writes, at a fifth of its price."""
    fields = [field for field in dataclasses.fields(owner) if field.init]
    known: dict[str, Any] = {"_set": object.__setattr__, "_made": dataclasses.MISSING}
    ordered = sorted(fields, key=lambda field: bool(field.kw_only))
    given = [_parameter(field, known) for field in ordered]
    if any(field.kw_only for field in fields):
        given.insert(sum(not field.kw_only for field in fields), "*")
    is_frozen = owner.__dataclass_params__.frozen
    form = "_set(self, {name!r}, {value})" if is_frozen else "self.{name} = {value}"
    body = []
    for field in dataclasses.fields(owner):
        value = _value(field, known)
        if value:
            body.append(form.format(name=field.name, value=value))
    if hasattr(owner, "__post_init__"):
        body.append("self.__post_init__()")
    text = f"def __init__({', '.join(['self', *given])}):\n " + "\n ".join(body or ["pass"])
    exec(text, known)
    method = known["__init__"]
    method.__qualname__ = f"{owner.__qualname__}.__init__"
    method.__module__ = owner.__module__
    method.__annotations__ = {**{f.name: f.type for f in fields}, "return": None}
    return method


def _parameter(field: dataclasses.Field[Any], known: dict[str, Any]) -> str:
    """A field among the parameters; what it needs to be known."""
    if field.default is not dataclasses.MISSING:
        known[f"_default_{field.name}"] = field.default
        return f"{field.name}=_default_{field.name}"
    is_made = field.default_factory is not dataclasses.MISSING
    return f"{field.name}=_made" if is_made else field.name


def _value(field: dataclasses.Field[Any], known: dict[str, Any]) -> str:
    """What is assigned to a field; empty where nothing is."""
    if field.default_factory is not dataclasses.MISSING:
        known[f"_make_{field.name}"] = field.default_factory
        made = f"_make_{field.name}()"
        return f"{made} if {field.name} is _made else {field.name}" if field.init else made
    return field.name if field.init else ""


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
