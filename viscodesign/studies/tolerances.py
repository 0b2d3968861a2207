"""Tolerances of numbers of a spec: one standard deviation each, in percent or in their unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.free_number import FreeNumber
from viscodesign.errors import SpecError, described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.studies.key_values import choices_of, refused
from viscodesign.units import QuantityKind
from viscodesign.values.grammar import GrammarError, parse_value_text

FORM = "write KEY=5% of its value, or one with its unit, such as KEY=0.01 mm"


@dataclass(frozen=True)
class SpreadWords:
    """What a standard deviation is called where it is given, and how it is written there."""

    noun: str = "tolerance"
    form: str = FORM


TOLERANCE = SpreadWords()


def deviations(
    scene: Scene,
    tolerances: Mapping[str, Any] | Sequence[str] | str,
    words: SpreadWords = TOLERANCE,
) -> dict[str, float]:
    """Standard deviations [SI] by the keys of free numbers.

    A tolerance of a key that stands for several numbers is that of each, independently. A number
    without a unit, from Python, is a part of the value: 0.05 for 5 %. Raises `SpecError`.
    """
    given = choices_of(tolerances, words.form)
    if not given:
        raise SpecError.plain(f"no {words.noun} is given; {words.form}")
    own = zip(given.values(), FreeKeys(scene, list(given)).numbers_of, strict=True)
    return {
        number.name: deviation(number, spread, words)
        for spread, numbers in own
        for number in numbers
    }


def deviation(number: FreeNumber, given: Any, words: SpreadWords) -> float:
    """One standard deviation [SI] as it is given of a number. Raises `SpecError`."""
    unit = _unit_of(number.name, given, words)
    is_part = unit in ("", "%")
    kind = QuantityKind(words.noun, "1" if is_part else number.unit, "5 %")
    try:
        value = kind.parse(given)
    except PydanticCustomError as error:
        raise refused(number.name, f"{error.message()}; {words.form}") from None
    if is_part and not number.value:
        message = f"is 0, of which {given} is nothing; give its {words.noun} with a unit"
        raise refused(number.name, message)
    found = value * abs(number.value) if is_part else value
    if not found > 0.0 or (is_part and value >= 1.0):
        raise refused(
            number.name, f"a {words.noun} must be above 0 and below 100 %; got {described(given)}"
        )
    return found


def _unit_of(key: str, given: Any, words: SpreadWords) -> str:
    """The unit of a text; empty for a number, which is a part."""
    if not isinstance(given, str):
        return ""
    try:
        unit = parse_value_text(given).unit
    except GrammarError:
        return "%"  # reading it says what is wrong
    if not unit:
        raise refused(key, f"the {words.noun} '{given}' has no unit; {words.form}")
    return unit
