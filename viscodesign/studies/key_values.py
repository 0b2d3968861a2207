"""What a key of the spec takes in a study: a list of values, or a range with bounds."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.errors import Fault, SpecError, described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.units import QuantityKind
from viscodesign.values.grammar import GrammarError, parse_value_text

RANGE = re.compile(r"\s*(?P<low>[+-]?\.?\d.*?)\s*\.\.\s*(?P<high>[^:]*?)\s*(?P<tail>(?::[^:]*)*)")
LOG = "log"
MAX_VALUES = 1_000_000
"""Values of one range."""
FORMS = "write KEY=a,b,c or KEY=low..high:n, with :log for equal ratios"


@dataclass(frozen=True)
class KeyValues:
    """What one key takes: values one by one, or a range."""

    key: str
    unit: str | None
    """SI unit of its numbers, "1" for a ratio; None for words and other settings."""
    listed: tuple[Any, ...] = ()
    low: float = math.nan
    high: float = math.nan
    """Bounds of a range [unit]."""
    count: int | None = None
    """Values of a range in a grid."""
    is_log: bool = False
    is_bare: bool = False
    """Whether its numbers have a unit, and came without."""

    @property
    def is_range(self) -> bool:
        """Whether it takes all values between two bounds."""
        return not self.listed

    def grid(self) -> tuple[Any, ...]:
        """Its values in a grid. Raises `SpecError` for a range without a count."""
        if self.listed:
            return self.listed
        if self.count is None:
            message = f"a grid needs the number of values: {self.key}=low..high:n"
            raise refused(
                self.key, f"{message}; or draw designs at random by --sample N (sample=N in Python)"
            )
        if self.count == 1:
            return (self.low,)
        found = self.at(np.linspace(0.0, 1.0, self.count))
        return (self.low, *found[1:-1], self.high)

    def at(self, shares: np.ndarray) -> list[Any]:
        """Values at shares (n,) of its range, from 0 to 1; of a list, each has an equal part."""
        if self.listed:
            places = np.minimum((shares * len(self.listed)).astype(int), len(self.listed) - 1)
            return [self.listed[k] for k in places]
        if self.is_log:
            low, high = math.log(self.low), math.log(self.high)
            return [float(value) for value in np.exp(low + shares * (high - low))]
        return [float(value) for value in self.low + shares * (self.high - self.low)]


def refused(key: str, message: str) -> SpecError:
    """An error that names the key."""
    return SpecError([Fault(message, key)])


def split_choice(text: str, forms: str = FORMS) -> tuple[str, str]:
    """Key and values of a text KEY=VALUES; ``forms`` tells what such texts look like."""
    key, equals, values = text.partition("=")
    if not equals or not key.strip():
        raise SpecError.plain(f"'{text}' names no key; {forms}")
    return key.strip(), values.strip()


def choices_of(over: Mapping[str, Any] | Sequence[str] | str, forms: str = FORMS) -> dict[str, Any]:
    """What each key takes, unread, from a mapping or texts KEY=VALUES."""
    if isinstance(over, Mapping):
        return dict(over)
    found: dict[str, Any] = {}
    for text in [over] if isinstance(over, str) else over:
        key, values = split_choice(text, forms)
        if key in found:
            raise refused(key, "is given twice; give all its values at once")
        found[key] = values
    return found


def read_values(key: str, unit: str | None, given: Any) -> KeyValues:
    """What a key takes, from text such as ``0.2 mm..1 mm:9:log`` or a sequence of values.

    ``unit``: SI unit of its numbers, None where it takes none. Raises `SpecError`.
    """
    if isinstance(given, str):
        found = RANGE.fullmatch(given)
        if found is not None:
            return _range(key, unit, found["low"], found["high"], found["tail"])
        parts: list[Any] = _split(given)
    else:
        parts = list(given) if isinstance(given, (Sequence, np.ndarray)) else [given]
    if not parts or parts == [""]:
        raise refused(key, f"has no values; {FORMS}")
    if any(isinstance(part, str) and not part for part in parts):
        raise refused(key, f"has an empty value in '{given}'; {FORMS}")
    if unit is None:
        words = (part if isinstance(part, (str, bool, int, float)) else str(part) for part in parts)
        return KeyValues(key, None, tuple(words))
    return KeyValues(key, unit, tuple(_numbers(key, unit, parts)), is_bare=_are_bare(unit, parts))


def _split(text: str) -> list[str]:
    """Parts between commas that stand in no brackets."""
    parts, depth = [""], 0
    for char in text:
        depth += (char in "{[(") - (char in "}])")
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts]


def _range(key: str, unit: str | None, low: str, high: str, tail: str) -> KeyValues:
    if not high:
        raise refused(key, f"the range '{low}..' has no upper bound; {FORMS}")
    words = [word.strip() for word in tail.split(":")[1:]]
    is_log = LOG in words
    counts = [word for word in words if word != LOG]
    if len(counts) > 1 or len(words) - len(counts) > 1:
        raise refused(key, f"'{tail}' behind a range: expected :n, :log or :n:log")
    first, last = _numbers(key, unit or "1", [low, high])
    if not first < last:
        wrong = "are reversed" if first > last else "are equal"
        raise refused(key, f"the bounds {low}..{high} {wrong}; write the smaller one first")
    if is_log and first <= 0.0:
        raise refused(key, f"a logarithmic range needs bounds above 0; got {low}..{high}")
    count = _count(key, counts[0]) if counts else None
    is_bare = _are_bare(unit or "1", [low, high])
    return KeyValues(key, unit or "1", (), first, last, count, is_log, is_bare)


def _count(key: str, text: str) -> int:
    if not text.isascii() or not text.isdigit() or not 1 <= int(text) <= MAX_VALUES:
        raise refused(
            key,
            f"the number of values must be a whole number from 1 to {MAX_VALUES:,}; got '{text}'",
        )
    return int(text)


def _numbers(key: str, unit: str, parts: Sequence[Any]) -> list[float]:
    """Values in SI. A bare number is SI, but not beside one with a unit."""
    kind = QuantityKind(f"value in {unit}" if unit != "1" else "number", unit, f"1 {unit}")
    try:
        found = [kind.parse(_plain(part)) for part in parts]
    except PydanticCustomError as error:
        raise refused(key, error.message()) from None
    bare = [p for p, value in zip(parts, found, strict=True) if value and not _has_unit(p)]
    if unit != "1" and bare and any(map(_has_unit, parts)):
        other = next(part for part in parts if _has_unit(part))
        raise refused(
            key, f"{described(bare[0])} has no unit beside '{other}'; give every value its unit"
        )
    return found


def _are_bare(unit: str, parts: Sequence[Any]) -> bool:
    return unit != "1" and not any(map(_has_unit, parts))


def _plain(part: Any) -> Any:
    """numpy's numbers as Python's."""
    return part.item() if isinstance(part, np.generic) else part


def _has_unit(part: Any) -> bool:
    try:
        return isinstance(part, str) and bool(parse_value_text(part).unit)
    except GrammarError:
        return False
