"""What a spec says of how well its numbers are known, as standard deviations."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.free_number import FreeNumber
from viscodesign.errors import Fault, SpecError
from viscodesign.exploration.tolerances import SpreadWords, deviations
from viscodesign.exploration.typical_uncertainties import typical_of
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.scene.uncertainty import FORM, TYPICAL
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

    Raises `SpecError` for keys that are none or that overlap, and for spreads that are none.
    """
    stated = scene.uncertainty
    if stated is None:
        return {}
    found: dict[str, StatedDeviation] = {}
    faults: list[Fault] = []
    for key, spread in stated.spreads.items():
        try:
            own = _of_range(scene, key, spread) if isinstance(spread, tuple) else (
                deviations(scene, {key: spread}, WORDS)
            )  # fmt: skip
        except SpecError as error:
            faults += [replace(f, key=f"{SECTION}.{f.key or key}") for f in error.faults]
            continue
        found |= {name: StatedDeviation(sd, False) for name, sd in own.items()}
    if faults:
        raise SpecError(faults)
    if stated.others == TYPICAL:
        found |= _typical(scene, found)
    if found:
        FreeKeys(scene, list(found))  # refuses keys that overlap
    return found


def _typical(scene: Scene, stated: dict[str, StatedDeviation]) -> dict[str, StatedDeviation]:
    """Those assumed of the coefficients of a scene that are not zero."""
    found: dict[str, StatedDeviation] = {}
    for key, spread in typical_of(scene, set(stated)).items():
        (number,) = FreeKeys(scene, [key]).numbers
        if number.value:
            found[key] = StatedDeviation(deviations(scene, {key: spread})[key], True)
    return found


def _of_range(scene: Scene, key: str, ends: tuple[Any, ...]) -> dict[str, float]:
    """Root mean square distance from the value, of numbers spread evenly between two ends."""
    return {n.name: _rms(n, *_ends(scene, n, ends)) for n in FreeKeys(scene, [key]).numbers}


def _ends(scene: Scene, number: FreeNumber, given: tuple[Any, ...]) -> list[float]:
    """Both ends [SI], each a value that the spec could have."""
    keys, found = FreeKeys(scene, [number.name]), [_end(number, end) for end in given]
    for end in found:
        try:
            keys.validated([end])
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
    unit = "" if number.unit == "1" else f" {number.unit}"
    if not low < high:
        message = f"a range ascends; got [{low:g}, {high:g}]{unit}"
        raise SpecError([Fault(message, number.name)])
    if not low <= number.value <= high:
        message = f"[{low:g}, {high:g}]{unit} leaves out the value itself, {number.value:g}{unit}"
        raise SpecError([Fault(message, number.name)])
    return math.hypot((high - low) / math.sqrt(12), (high + low) / 2 - number.value)
