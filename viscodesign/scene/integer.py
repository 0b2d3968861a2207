"""Integers of a spec."""

from __future__ import annotations

import re
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

MAX_INTEGER_DIGITS = 18
"""More than any key allows, and few enough to be read at once."""


def as_integer(given: Any) -> Any:
    """An integer as text, or as a number with a zero after its point, as an integer.

    Anything else as it is given, to be refused; on and off are not numbers.
    """
    if isinstance(given, str) and re.fullmatch(
        rf"[+-]?[0-9]{{1,{MAX_INTEGER_DIGITS}}}", given.strip()
    ):
        return int(given)
    if isinstance(given, float) and given.is_integer() and abs(given) < 10**MAX_INTEGER_DIGITS:
        return int(given)
    return given


Integer = Annotated[int, Field(strict=True), BeforeValidator(as_integer)]
"""An integer, whoever wrote it: a spec, an override as text, or an array of numbers."""
