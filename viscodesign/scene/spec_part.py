"""Base of all parts of a spec, and the errors that their validators raise."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from pydantic import BaseModel, ConfigDict, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

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


class SpecPart(BaseModel):
    """A part of a spec: immutable, without unknown keys."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        allow_inf_nan=False,
        defer_build=True,
        ignored_types=(cached_property,),
    )

    def unwritten(self) -> tuple[str, ...]:
        """Fields that another one replaces, which a resolved spec leaves out."""
        return ()

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


def switch(given: Any) -> Any:
    """True or False for on, off, yes and no, as text or as booleans; else the given value."""
    return _SWITCH.get(given.lower(), given) if isinstance(given, str) else given


def _error(faults: list[KeyFault]) -> PydanticCustomError:
    message = "; ".join(fault.message for fault in faults)
    return PydanticCustomError("spec", "{message}", {"message": message, "faults": faults})
