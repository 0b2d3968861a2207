"""What a spec says of how well its numbers are known, as standard deviations."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.free_number import FreeNumber
from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.scene.uncertainty import ALLOWED, FORM, TYPICAL, Spread
from viscodesign.studies.tolerances import SpreadWords, deviation
from viscodesign.studies.typical_uncertainties import typical_of
from viscodesign.units import QuantityKind

SECTION = "uncertainty"
WORDS = SpreadWords("standard deviation", FORM)


@dataclass(frozen=True)
class StatedDeviation:
    """One standard deviation of a number [SI]."""

    deviation: float
    assumed: bool
    """Whether the spec leaves it to what is typical."""


def stated_deviations(scene: Scene) -> dict[str, StatedDeviation]:
    """By the keys of free numbers; empty where the spec says nothing.

    What is typical is assumed of coefficients that are not zero. Raises `SpecError` for keys that
    are none or that overlap, and for spreads that are none.
    """
    stated = scene.uncertainty
    if stated is None:
        return {}
    typical = typical_of(scene, set(stated.spreads)) if stated.others == TYPICAL else {}
    given: dict[str, Spread] = {**stated.spreads, **typical}
    if not given:
        return {}
    try:
        keys = FreeKeys(scene, list(given))  # refuses keys that overlap
    except SpecError as error:
        raise SpecError([_located(scene, f, f.key, given) for f in error.faults]) from None
    found: dict[str, StatedDeviation] = {}
    faults: list[Fault] = []
    for (key, spread), numbers in zip(given.items(), keys.numbers_of, strict=True):
        counted = [n for n in numbers if n.value or key not in typical]
        try:
            own = _deviations(keys, counted, spread)
        except SpecError as error:
            faults += [_located(scene, fault, key, given) for fault in error.faults]
            continue
        found |= {name: StatedDeviation(sd, key in typical) for name, sd in own.items()}
    if faults:
        raise SpecError(faults)
    return found


def _located(scene: Scene, fault: Fault, key: str, given: dict[str, Spread]) -> Fault:
    """The fault of a key where the spec states it."""
    file, line = scene.source.place(f"{SECTION}.{key}")
    own = given.get(key)
    return replace(
        fault,
        key=f"{SECTION}.{fault.key}",
        file=file,
        line=line,
        given=list(own) if isinstance(own, tuple) else own,
        allowed=ALLOWED,
    )


def _deviations(keys: FreeKeys, numbers: Iterable[FreeNumber], spread: Spread) -> dict[str, float]:
    if isinstance(spread, tuple):
        return {number.name: _rms(number, *_ends(keys, number, spread)) for number in numbers}
    return {number.name: deviation(number, spread, WORDS) for number in numbers}


def _ends(keys: FreeKeys, number: FreeNumber, given: tuple[Any, ...]) -> list[float]:
    """Both ends [SI], each a value that the spec could have."""
    found, place = [_end(number, end) for end in given], keys.names.index(number.name)
    for end in found:
        values = keys.values
        values[place] = end
        try:
            keys.validated(values)
        except SpecError as error:
            message = f"a range has values that are possible: {error.faults[0].message}"
            raise SpecError([Fault(message, number.name)]) from None
    return found


def _end(number: FreeNumber, given: Any) -> float:
    try:
        return QuantityKind("end of a range", number.unit, "").parse(given)
    except PydanticCustomError as error:
        raise SpecError([Fault(error.message(), number.name)]) from None


def _rms(number: FreeNumber, low: float, high: float) -> float:
    """Root mean square distance from the value, of numbers spread evenly between two ends."""
    unit = "" if number.unit == "1" else f" {number.unit}"
    if not low < high:
        message = f"a range ascends; got [{low:g}, {high:g}]{unit}"
        raise SpecError([Fault(message, number.name)])
    if not low <= number.value <= high:
        message = f"[{low:g}, {high:g}]{unit} leaves out the value itself, {number.value:g}{unit}"
        raise SpecError([Fault(message, number.name)])
    return math.hypot((high - low) / math.sqrt(12), (high + low) / 2 - number.value)
