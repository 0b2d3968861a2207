"""What all parts of a spec share."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any, NamedTuple

from pydantic import BaseModel, ConfigDict, ValidationInfo, field_validator
from pydantic_core import PydanticCustomError

KeyPath = tuple[str, ...]

VALID = "valid"
"""Where the loader's context keeps the fields that passed: (class name, field): value."""
MOST_COMPLAINTS = 20

_SWITCH = {"on": True, "yes": True, "true": True, "off": False, "no": False, "false": False}


class Complaint(NamedTuple):
    """What is wrong, and with which key below the part that is being validated."""

    path: KeyPath
    message: str


class Part(BaseModel):
    """A section of a spec: frozen, and no unknown key passes."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @field_validator("*", mode="after")
    @classmethod
    def _remember(cls, value: Any, info: ValidationInfo) -> Any:
        """Keep what passed, so that parts are compared even where another part is at fault.

        It runs before the field validators of a subclass: a check that others rely on
        belongs into the field's annotation.
        """
        valid = (info.context or {}).get(VALID)
        if valid is not None:
            valid[cls.__name__, info.field_name] = value
        return value


def refuse(message: str) -> PydanticCustomError:
    """A fault in words of the user; the loader adds file, line and key."""
    return _error([Complaint((), message)])


def refuse_at(key: str, message: str) -> PydanticCustomError:
    """A fault that belongs to a key below the one being validated."""
    return _error([Complaint((key,), message)])


def refuse_any(complaints: Iterable[Complaint]) -> None:
    """Raise all complaints as one error, if there are any."""
    found = list(complaints)
    if found:
        rest = len(found) - MOST_COMPLAINTS
        more = (
            [Complaint(found[-1].path[:1], f"and {rest} faults more of this kind")]
            if rest > 0
            else []
        )
        raise _error(found[:MOST_COMPLAINTS] + more)


def complaints_of(error: PydanticCustomError) -> list[Complaint]:
    """What a fault of this module says, key by key."""
    return list((error.context or {})["complaints"])


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """'; did you mean 'x'?' for the nearest known word, or nothing."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f"; did you mean '{near[0]}'?" if near else ""


def switch(given: Any) -> Any:
    """True or False for on and off, yes and no, however YAML left them; else what was given."""
    return _SWITCH.get(given.lower(), given) if isinstance(given, str) else given


def _error(complaints: list[Complaint]) -> PydanticCustomError:
    message = "; ".join(c.message for c in complaints)
    return PydanticCustomError("spec", "{message}", {"message": message, "complaints": complaints})
