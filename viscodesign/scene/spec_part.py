"""Base of all parts of a spec, and the errors that their validators raise."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, ClassVar, NamedTuple, Self, TypeVar

from pydantic import (
    BaseModel,
    ConfigDict,
    SerializerFunctionWrapHandler,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_serializer,
)
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError

from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.scene.field_names import refuse_shadowing
from viscodesign.scene.read_only import UnchangeableError, read_only
from viscodesign.storage.cached_property import cached_property

KeyPath = tuple[str, ...]

VALID_FIELDS = "valid"
"""Key of the validation context under which valid fields are kept: (class name, field): value."""
MAX_FAULTS_OF_A_KIND = 20

_SWITCH = {"on": True, "yes": True, "true": True, "off": False, "no": False, "false": False}


class KeyFault(NamedTuple):
    """An error and the key that it concerns, relative to the part being validated."""

    path: KeyPath
    message: str
    allowed: str = ""
    """What the key may have, where its field does not say so."""


class SpecPart(BaseModel):
    """A part of a spec: immutable, without unknown keys.

    Its mappings are read-only ones, so that no change escapes what was computed of them. Its
    sequences are tuples.
    """

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        allow_inf_nan=False,
        defer_build=True,
        ignored_types=(cached_property,),
    )

    section: ClassVar[str] = "SECTION."
    """Where its keys stand, for a message that does not know which part it is."""

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        refuse_shadowing(cls)

    def model_post_init(self, context: Any, /) -> None:
        """Make its mappings read-only; those of defaults and of own validators as well."""
        _protect(self)

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            raise self._unchangeable(name, repr(value))
        super().__setattr__(name, value)

    def __delattr__(self, name: str) -> None:
        raise self._unchangeable(name, "None")

    def _unchangeable(self, name: str, value: str) -> UnchangeableError:
        fields = type(self).model_fields
        keys = {own: found.alias or own for own, found in fields.items()}
        if name not in keys:
            known = did_you_mean(name, keys.values())
            return UnchangeableError(f"{name}: {type(self).__name__} has no such key{known}")
        return UnchangeableError(
            f"{keys[name]}: a scene is not changed but replaced: "
            f"scene.replace({{'{self.section}{keys[name]}': {value}}}) is a new one, checked like "
            "a loaded one"
        )

    def keyed_fields(self) -> Iterator[tuple[str, Any, FieldInfo]]:
        """Every key below this part, with its value and the field that says what this may be."""
        for name, found in type(self).model_fields.items():
            yield found.alias or name, getattr(self, name), found

    def with_keys(self, values: Mapping[str, Any]) -> Self:
        """A copy with other values of some keys, not validated. Raises `KeyError` for others."""
        names = {found.alias or name: name for name, found in type(self).model_fields.items()}
        return copied(self, {names[key]: value for key, value in values.items()})

    def unwritten(self) -> tuple[str, ...]:
        """Names of fields that a resolved spec leaves out, since another field overrides them."""
        return ()

    def model_dump(self, **options: Any) -> dict[str, Any]:
        """The part as plain data in SI, under the keys of a spec: `load` reads a scene's again.

        ``options`` are pydantic's. What is not set is left out.
        """
        return super().model_dump(**{"by_alias": True, **options})

    def model_dump_json(self, **options: Any) -> str:
        """The same as JSON text."""
        return super().model_dump_json(**{"by_alias": True, **options})

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """A copy; with ``update``, fields and their new values, it is checked like a new one.

        Raises `SpecError` where a value is not allowed.
        """
        if not update:
            return super().model_copy(deep=deep)
        fields = type(self).model_fields
        keys = {found.alias or name: name for name, found in fields.items()}
        if unknown := [key for key in update if key not in {*fields, *keys}]:
            raise SpecError(
                [Fault(f"no such key{did_you_mean(key, keys)}", key) for key in unknown]
            )
        return self._updated({keys.get(key, key): value for key, value in update.items()})

    def copy(self, **options: Any) -> Self:
        """The same as `model_copy`."""
        return self.model_copy(**options)

    def _updated(self, fields: Mapping[str, Any]) -> Self:
        """A checked copy with these fields."""
        try:
            return type(self).model_validate(self._keys_with(fields))
        except ValidationError as error:
            raise SpecError(list(_plain_faults(error))) from None

    def _keys_with(self, fields: Mapping[str, Any]) -> dict[str, Any]:
        """All keys that are set, as they are validated, with other values of these fields."""
        return {
            found.alias or name: fields[name] if name in fields else getattr(self, name)
            for name, found in type(self).model_fields.items()
            if name in fields or not is_unset(self, name)
        }

    @model_serializer(mode="wrap")
    def _without_unset(self, plain: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """All fields but those that are not set."""
        data: dict[str, Any] = plain(self)
        for name, found in type(self).model_fields.items():
            if is_unset(self, name):
                data.pop(name, None)
                data.pop(found.alias or name, None)
        return data

    @field_validator("*", mode="after")
    @classmethod
    def _keep_valid_field(cls, value: Any, info: ValidationInfo) -> Any:
        """Keep a valid field for the cross-checks, which run even if another part is invalid.

        Runs before the field validators of a subclass, so a check that cross-checks rely on
        belongs in the field's annotation.
        """
        valid = (info.context or {}).get(VALID_FIELDS)
        if valid is not None:
            valid[cls.__name__, info.field_name] = value
        return value


PartT = TypeVar("PartT", bound=BaseModel)


def is_unset(part: SpecPart, name: str) -> bool:
    """Whether a field has nothing to say: it is None as by default, or another one replaces it."""
    found = type(part).model_fields[name]
    is_default = getattr(part, name) is None and found.default is None
    return is_default or name in part.unwritten()


def copied(part: PartT, changes: Mapping[str, Any]) -> PartT:
    """A copy with other values, not validated, without what followed from its former ones."""
    copy = BaseModel.model_copy(part, update=changes)
    for derived in set(vars(copy)) - set(type(part).model_fields):
        del vars(copy)[derived]
    _protect(copy)
    return copy


def _protect(part: BaseModel) -> None:
    """Make the mappings of a part read-only in place."""
    kept = vars(part)
    for name, value in kept.items():
        if type(value) is dict:
            kept[name] = read_only(value)


def _plain_faults(error: ValidationError) -> Iterator[Fault]:
    """The faults of a part by itself, which has no file."""
    for detail in error.errors(include_url=False):
        path = tuple(map(str, detail["loc"]))
        told = (detail.get("ctx") or {}).get("faults") or [KeyFault((), detail["msg"])]
        for fault in told:
            yield Fault(fault.message, ".".join((*path, *fault.path)))


def invalid(message: str) -> PydanticCustomError:
    """The error to raise for the part itself; the loader adds file, line and key."""
    return _error([KeyFault((), message)])


def invalid_at(key: str, message: str) -> PydanticCustomError:
    """The error to raise for one of its keys."""
    return _error([KeyFault((key,), message)])


def raise_faults(faults: Iterable[KeyFault]) -> None:
    """Raise all faults as one error, if there are any."""
    found = list(faults)
    if not found:
        return
    rest = len(found) - MAX_FAULTS_OF_A_KIND
    more = (
        [KeyFault(found[-1].path[:1], f"and {rest} more errors of this kind")] if rest > 0 else []
    )
    raise _error(found[:MAX_FAULTS_OF_A_KIND] + more)


def faults_of(error: PydanticCustomError) -> list[KeyFault]:
    """The faults that an error of this module holds."""
    return list((error.context or {})["faults"])


def faults_below(path: KeyPath, error: PydanticCustomError) -> PydanticCustomError:
    """The error of a part as one of the whole, in which the part stands at ``path``."""
    return _error([found._replace(path=(*path, *found.path)) for found in faults_of(error)])


def switch(given: Any) -> Any:
    """True or False for on, off, yes and no, as text or as booleans; else the given value."""
    return _SWITCH.get(given.lower(), given) if isinstance(given, str) else given


def _error(faults: list[KeyFault]) -> PydanticCustomError:
    message = "; ".join(fault.message for fault in faults)
    return PydanticCustomError("spec", "{message}", {"message": message, "faults": faults})
