"""Which keys of a spec a study varies: numbers of the equations, and settings that rebuild them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.scene_fields import number_fields
from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.reading.document import parse_value
from viscodesign.scene.scene import Scene
from viscodesign.studies.key_values import KeyValues, read_values, refused

INERT = {"name": "it changes no number of a run", "pump": "a run does not contain the pump",
         "uncertainty": "it changes no number of a run"}  # fmt: skip
"""Sections of a spec that a study cannot vary, and why."""


@dataclass(frozen=True)
class SweptKey:
    """One column of a table of designs."""

    values: KeyValues
    is_free: bool
    """Whether it is a number that a compiled function can free; else the scene is read again."""

    @property
    def name(self) -> str:
        """Its key, which stands for one number or setting."""
        return self.values.key

    def written(self, value: Any) -> Any:
        """A value as a spec has it: a whole number is not a fraction, and text is read as YAML."""
        if isinstance(value, str):
            return parse_value(value, self.name)
        return int(value) if self.values.unit == "1" and float(value).is_integer() else value


def changed(scene: Scene, values: Mapping[SweptKey, Any]) -> Scene:
    """A scene with other values of keys. Raises `SpecError` with faults by their keys alone."""
    if not values:
        return scene
    try:
        return scene.replace({key.name: key.written(value) for key, value in values.items()})
    except SpecError as error:
        raise SpecError([replace(fault, file="") for fault in error.faults]) from None


def swept_keys(scene: Scene, choices: Mapping[str, Any]) -> list[SweptKey]:
    """The keys of a study, in order; one that stands for several numbers becomes as many.

    ``choices``: what each key takes, as `read_values` reads it. Raises `SpecError` for keys that
    are unknown or cannot vary, and for values that are none.
    """
    if not choices:
        raise SpecError.plain("no key varies; name at least one, such as network.tube_length")
    found = [own for key, given in choices.items() for own in _keys_of(scene, key, given)]
    free = [own.name for own in found if own.is_free]
    if free:
        FreeKeys(scene, free)  # refuses keys that overlap
    return found


def _keys_of(scene: Scene, key: str, given: Any) -> list[SweptKey]:
    if reason := INERT.get(key.partition(".")[0]):
        raise refused(key, f"cannot vary: {reason}")
    try:
        numbers = FreeKeys(scene, [key]).numbers
    except SpecError:
        if "[" in key:
            raise
        return [_setting(scene, key, given)]
    values = read_values(key, numbers[0].unit, given)
    return [SweptKey(replace(values, key=number.name), True) for number in numbers]


def _setting(scene: Scene, key: str, given: Any) -> SweptKey:
    """A key whose values make other equations; refused where no value of it can be read."""
    units = {".".join(found.path): found.unit for found in number_fields(scene)}
    own = SweptKey(read_values(key, units.get(key), given), False)
    values = own.values.listed or (own.values.low, own.values.high)
    faults: list[Fault] = []
    for value in values:
        try:
            changed(scene, {own: value})
        except SpecError as error:
            faults += error.faults
        else:
            return own
    raise SpecError(faults[:1])
