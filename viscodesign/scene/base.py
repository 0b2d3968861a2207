"""What all parts of a spec share."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from pydantic import BaseModel, ConfigDict
from pydantic_core import PydanticCustomError


class Part(BaseModel):
    """A section of a spec: frozen, and no unknown key passes."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


def refuse(message: str) -> PydanticCustomError:
    """A fault in words of the user; the loader adds file, line and key."""
    return PydanticCustomError("spec", "{message}", {"message": message})


def refuse_at(key: str, message: str) -> PydanticCustomError:
    """A fault that belongs to a key below the one being validated."""
    return PydanticCustomError("spec", "{message}", {"message": message, "below": key})


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """'; did you mean 'x'?' for the nearest known word, or nothing."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f"; did you mean '{near[0]}'?" if near else ""
