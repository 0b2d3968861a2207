"""Numbers with the common units of `units.txt`, read without pint.

Importing pint takes longer than reading a whole spec. What is not a number and a product of
common units, or is anything but exactly of the unit that is asked for, is left to pint.
"""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from functools import cache, lru_cache
from pathlib import Path

from viscodesign.lazy_dataclass import dataclass

NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
MAX_FLOAT_DIGITS = 300
"""Digits before or after the point up to which a number surely fits into a `float`."""

_TOKEN = re.compile(rf"\s*({NUMBER}|[^\W\d]+|%|\*\*|[-^*/()])\s*")


class _NotCommonError(ValueError):
    """Text that is not a product of common units."""


@dataclass(frozen=True)
class CommonUnit:
    """A unit: its size in base units, and the powers of these in it."""

    size: Fraction
    powers: tuple[tuple[str, int], ...] = ()
    """Base units by name with their powers, none of which is zero, in alphabetical order."""
    offset: Fraction = Fraction(0)
    """Where its zero is, in base units."""

    def times(self, other: CommonUnit, power: int = 1) -> CommonUnit:
        """The product with a power of another unit."""
        if self.offset or other.offset:
            raise _NotCommonError
        powers = dict(self.powers)
        for name, own in other.powers:
            powers[name] = powers.get(name, 0) + power * own
        kept = tuple(sorted((name, own) for name, own in powers.items() if own))
        return CommonUnit(self.size * other.size**power, kept)


ONE = CommonUnit(Fraction(1))


def value_in_si(number: str, spelled: str, unit: str) -> float | None:
    """The value of a number with a spelled unit, in an SI unit; None where pint is to be asked."""
    if not spelled:
        return float(number)
    try:
        given, wanted = _unit(spelled), _unit(unit)
    except _NotCommonError:
        return None
    value = Fraction(number)
    if given.powers != wanted.powers or not _fits(value):
        return None
    if not value and not given.offset:
        return float(number)  # a zero may have a sign
    return float((value * given.size + given.offset) / wanted.size)


def _fits(value: Fraction) -> bool:
    return (
        not value
        or Fraction(10) ** -MAX_FLOAT_DIGITS < abs(value) < Fraction(10) ** MAX_FLOAT_DIGITS
    )


@lru_cache(maxsize=256)
def _unit(spelled: str) -> CommonUnit:
    """The unit that a product like ``m^2/(N*m)`` is."""
    return _evaluated(spelled, _table())


def _evaluated(spelled: str, table: _Table | _Names) -> CommonUnit:
    tokens = _tokens(spelled)
    found = _product(tokens, table)
    if tokens:
        raise _NotCommonError
    return found


def _tokens(spelled: str) -> list[str]:
    """Names, numbers and signs, the last one first."""
    tokens, place = [], 0
    while place < len(spelled):
        found = _TOKEN.match(spelled, place)
        if found is None:
            raise _NotCommonError
        tokens.append(found[1])
        place = found.end()
    return tokens[::-1]


def _product(tokens: list[str], table: _Table | _Names) -> CommonUnit:
    """Consume ``unit * unit / unit ...``."""
    found = _power(tokens, table)
    while tokens and tokens[-1] in "*/":
        sign = 1 if tokens.pop() == "*" else -1
        found = found.times(_power(tokens, table), sign)
    return found


def _power(tokens: list[str], table: _Table | _Names) -> CommonUnit:
    """Consume a unit or a product in parentheses, with its power."""
    token = tokens.pop() if tokens else ""
    if token == "(":
        found = _product(tokens, table)
        if not tokens or tokens.pop() != ")":
            raise _NotCommonError
    elif re.fullmatch(NUMBER, token):
        found = CommonUnit(Fraction(token))
    else:
        found = table.unit(token)
    if tokens and tokens[-1] in ("^", "**"):
        tokens.pop()
        found = ONE.times(found, _exponent(tokens))
    return found


def _exponent(tokens: list[str]) -> int:
    sign = 1
    if tokens and tokens[-1] == "-":
        tokens.pop()
        sign = -1
    if not tokens or not re.fullmatch("[1-9]", tokens[-1]):
        raise _NotCommonError
    return sign * int(tokens.pop())


class _Table:
    """Units and prefixes by all of their names."""

    def __init__(self) -> None:
        self._units: dict[str, CommonUnit] = {}
        self._prefixes: dict[str, Fraction] = {}

    def add(self, definition: str) -> None:
        """Add a line of the table: ``name = value = symbol = other names``."""
        first, value, *others = (part.strip() for part in definition.split("="))
        names = [first, *others]
        if first.endswith("-"):
            self._prefixes |= dict.fromkeys((name[:-1] for name in names), Fraction(value))
        elif value.startswith("["):
            # Radians count as well, so that an angular speed is not a frequency.
            self._units |= dict.fromkeys(names, CommonUnit(Fraction(1), ((first, 1),)))
        else:
            self._units |= dict.fromkeys(names, self._derived(value))

    def _derived(self, value: str) -> CommonUnit:
        product, _, offset = value.partition("; offset:")
        found = _evaluated(product, self)
        return replace(found, offset=Fraction(offset.strip())) if offset else found

    def unit(self, name: str) -> CommonUnit:
        """A unit by its name, which may have a prefix."""
        if name in self._units:
            return self._units[name]
        for prefix, size in self._prefixes.items():
            rest = name[len(prefix) :]
            if name.startswith(prefix) and rest in self._units:
                return CommonUnit(size).times(self._units[rest])
        raise _NotCommonError


@cache
def _table() -> _Table:
    table = _Table()
    for line in definitions():
        if line.strip() and not line.startswith("#"):
            table.add(line)
    return table


def definitions() -> list[str]:
    """The lines of the table of common units, as pint reads them too."""
    return Path(__file__).with_name("units.txt").read_text(encoding="utf-8").splitlines()


class _Names:
    """A table in which every name is a unit of its own."""

    def unit(self, name: str) -> CommonUnit:
        return CommonUnit(Fraction(1), ((name, 1),))


def powers_of_names(spelled: str) -> dict[str, int]:
    """The power of every name that is left in a product like ``m^2/(N*m)``; empty for others."""
    try:
        return dict(_evaluated(spelled, _Names()).powers)
    except _NotCommonError:
        return {}


def dimensions(name: str) -> tuple[tuple[str, int], ...]:
    """Base units of a common unit, with their powers; empty for any other name."""
    try:
        return _table().unit(name).powers
    except _NotCommonError:
        return ()
