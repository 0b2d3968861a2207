"""The grammar of a value: exactly one number and at most one unit, or a refusal in plain words.

``value = number [unit]``, ``number = [sign] digits [. digits] [exponent]``, all ASCII;
``unit = ["/"] power {("*" | "/" | " ") power}``, ``power = (name | "(" unit ")") [exponent]``.
Nothing is computed: a sum, product, fraction, range or tolerance is refused, never evaluated.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from viscodesign.lazy_dataclass import dataclass
from viscodesign.values.slips import slip

MAX_CHARACTERS = 80
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_EXPONENT = r"[+-]?[1-9]"
_POWER = rf"(?:\^|\*\*)(?P<{{}}>{_EXPONENT}|\({_EXPONENT}\))"
_TOKEN = re.compile(
    r" *(?:(?P<name>(?:[^\W\d_]+_)*(?:[^\W\d_]*H2O|[^\W\d_]+)|%)"
    rf"(?:(?P<bare>[23])|{_POWER.format('power')})?(?![\w.^])|(?P<open>\()"
    rf"|(?P<close>\)(?:{_POWER.format('outer')})?)|(?P<sign>[*/])) *"
)
_SUPERSCRIPTS = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
_SAME_SIGNS = str.maketrans({"·": "*", "⋅": "*", "°": "deg", "μ": "µ"})
_BROKEN_EXPONENT = re.compile("[eE][+-]?[0-9]")
_SUPERSCRIPT = re.compile("[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")
OFFSET_UNITS = {
    **dict.fromkeys(("degC", "celsius", "degree_Celsius", "degreeC"), "K"),
    **dict.fromkeys(("degF", "fahrenheit", "degree_Fahrenheit", "degreeF"), "delta_degF"),
}
"""Units whose zero is elsewhere, and the unit of their differences."""


class GrammarError(ValueError):
    """Text that is not one number and one unit; the message says what was read and is meant."""


@dataclass(frozen=True)
class ValueText:
    """A value taken apart."""

    number: str
    """ASCII digits that `float` reads."""
    unit: str
    """A canonical product of names, such as ``m^2/(N*m)``; empty for a bare number."""
    names: tuple[str, ...]
    """The unit names in it."""
    has_difference: bool = False
    """Whether an offset unit in a compound was read as a difference."""


def parse_value_text(text: str) -> ValueText:
    """The number and the unit of a text. Raises `GrammarError`."""
    if len(text) > MAX_CHARACTERS:
        raise GrammarError(f"{len(text)} characters")
    plain = text.strip(" \t\r\n")
    found = _NUMBER.match(plain)
    if plain.lower().lstrip("+-.") in ("inf", "nan", "infinity"):
        raise GrammarError("it is not finite")
    if found is None or _continues(plain[found.end() :]):
        raise GrammarError(slip(plain))
    rest = plain[found.end() :].strip(" \t\r\n")
    try:
        if _BROKEN_EXPONENT.match(rest) or rest.startswith("("):
            raise GrammarError(f"'{rest}' is not a unit")
        unit = _unit(rest)
    except GrammarError as error:
        raise GrammarError(slip(plain) or str(error)) from None
    return ValueText(found[0], *unit)


def _continues(rest: str) -> bool:
    """Whether more of a number follows directly behind a number."""
    return rest[:1] in (".", "_", "'", ",") or rest[:1].isnumeric()


@lru_cache(maxsize=256)
def _unit(spelled: str) -> tuple[str, tuple[str, ...], bool]:
    """The canonical product, its names, and whether an offset unit was read as a difference."""
    if not spelled:
        return "", (), False
    plain = _SUPERSCRIPT.sub(lambda m: "^" + m[0].translate(_SUPERSCRIPTS), spelled)
    plain = re.sub(r"^1 */", "/", re.sub(r"\bper\b", "/", plain.translate(_SAME_SIGNS)))
    parts = list(_parts("1" + plain if plain.startswith("/") else plain))
    names = tuple(name for name, _ in parts if name)
    lone = len(parts) == 1 and "^" not in parts[0][1]
    differs = not lone and any(name in OFFSET_UNITS for name in names)
    written = [_difference(name, text) if differs else text for name, text in parts]
    if "%" in names and not lone:
        raise GrammarError("'%' must stand alone, after a number")
    return "".join(written), names, differs


def _difference(name: str, text: str) -> str:
    return OFFSET_UNITS.get(name, name) + text[len(name) :] if name else text


def _parts(spelled: str) -> Iterator[tuple[str, str]]:
    """Names with their powers, and signs; spaces between names become products."""
    place, depth, operand = 0, 0, False
    if spelled.startswith("1/"):
        yield "", "1"
        place, operand = 1, True
    while place < len(spelled):
        found = _TOKEN.match(spelled, place)
        if found is None:
            raise GrammarError(f"'{spelled}' is not a unit")
        place, group = found.end(), found.groupdict()
        starts = group["name"] or group["open"]
        if starts and operand:
            yield "", "*"
        if not starts and not operand:
            raise GrammarError(f"'{spelled}' is not a unit")
        if group["name"]:
            yield group["name"], group["name"] + _power(group["bare"] or group["power"])
        elif group["close"]:
            yield "", ")" + _power(group["outer"])
        else:
            yield "", group["open"] or group["sign"]
        depth += bool(group["open"]) - bool(group["close"])
        operand = bool(group["name"] or group["close"])
        if depth < 0:
            break
    if depth or not operand:
        raise GrammarError(f"'{spelled}' is not a unit: its brackets or signs do not match")


def _power(digits: str | None) -> str:
    return f"^{digits.strip('()+')}" if digits else ""
