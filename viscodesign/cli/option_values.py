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


def pair(option: str, text: str, unit: str, example: str) -> tuple[float, float]:
    """Two quantities [unit] given to an option, with a comma between them."""
    from pydantic_core import PydanticCustomError

    from viscodesign.units import QuantityKind

    parts = [part.strip() for part in text.strip("[]() ").split(",")]
    if len(parts) != 2:
        raise UsageError(f"{option}: expected two values, such as '{example}'; got '{text}'")
    kind = QuantityKind(f"value in {unit}", unit, example.partition(",")[0])
    try:
        return kind.parse(_number(parts[0])), kind.parse(_number(parts[1]))
    except PydanticCustomError as error:
        raise UsageError(f"{option}: {error.message()}") from error


def _number(text: str) -> str | float:
    """A bare number is SI."""
    try:
        return float(text)
    except ValueError:
        return text
