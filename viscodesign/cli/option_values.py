"""Values of options that are quantities."""

from __future__ import annotations

from viscodesign.errors import UsageError


def positive_time(option: str, text: str) -> float:
    """The positive time [s] given to an option."""
    from pydantic_core import PydanticCustomError

    from viscodesign.units import QuantityKind

    try:
        value = QuantityKind("time", "s", "20 ms").parse(text)
    except PydanticCustomError as error:
        raise UsageError(f"{option}: {error.message()}") from error
    if value <= 0.0:
        raise UsageError(f"{option}: must be above zero, such as '20 ms'; got '{text}'")
    return value
