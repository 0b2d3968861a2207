"""`sections:` what single sections of an actuator have otherwise than the whole."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from pydantic import Field, field_validator, model_validator

from viscodesign.errors import not_among
from viscodesign.scene.actuator import Actuator
from viscodesign.scene.member_changes import clashes, numbers_of, values_by_member
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, invalid_at, switch
from viscodesign.units import Density, Fraction, Length, Pressure, Time

BLOCKED = "blocked"
LENGTH = "all sections of an actuator have the same length: actuator.length over their number"


class SectionChange(SpecPart):
    """What some sections have in the place of the actuator's own."""

    height: Length | None = Field(None, gt=0, description="Instead of actuator.height")
    width: Length | None = Field(None, gt=0, description="Instead of actuator.width")
    youngs_modulus: Pressure | None = Field(
        None, gt=0, description="Instead of actuator.youngs_modulus"
    )
    density: Density | None = Field(None, gt=0, description="Instead of actuator.density")
    solid_fraction: Fraction | None = Field(
        None, gt=0, le=1, description="Instead of actuator.solid_fraction"
    )
    extension_factor: Fraction | None = Field(
        None, gt=0, description="Instead of actuator.extension_factor"
    )
    bending_factor: Fraction | None = Field(
        None, gt=0, description="Instead of actuator.bending_factor"
    )
    shear_factor: Fraction | None = Field(
        None, gt=0, description="Instead of actuator.shear_factor"
    )
    damping_time: Time | None = Field(None, ge=0, description="Instead of actuator.damping_time")
    blocked: bool | None = Field(
        None,
        description="on: these sections neither bend nor stretch, as behind a pillar; their "
        "bellows fill and empty as before",
    )

    @model_validator(mode="before")
    @classmethod
    def _no_length(cls, given: Any) -> Any:
        if isinstance(given, dict) and "length" in given:
            raise invalid_at("length", f"no section has its own; {LENGTH}")
        return given

    @field_validator(BLOCKED, mode="before")
    @classmethod
    def _switched(cls, given: Any) -> Any:
        found = switch(given)
        if not isinstance(found, bool):
            raise invalid(not_among(given, ("on", "off")))
        return found


def sections_named(key: str) -> list[str]:
    """The sections, counted from 1, that a key such as '3' or '1-2' names; empty for none."""
    found = re.fullmatch(r"(\d+)(?:-(\d+))?", key)
    if found is None:
        return []
    first, last = int(found[1]), int(found[2] or found[1])
    return [str(j) for j in range(first, last + 1)] if first else []


def section_faults(sections: Mapping[str, SectionChange], count: int) -> Iterator[KeyFault]:
    """Sections that an actuator of ``count`` does not have, and clashes."""
    known = {str(j + 1) for j in range(count)}
    for key in sections:
        names = sections_named(key)
        if not names or not known.issuperset(names):
            words = "section 1" if count == 1 else f"sections 1 to {count}, counted from the clamp"
            message = f"no such section; the actuator has {words}. Write one, such as '1'"
            yield KeyFault((key,), f"{message}, or a range, such as '1-{min(2, count)}'")
    yield from clashes(sections, sections_named, "section ")
    blocked = {name for key, own in sections.items() if own.blocked for name in sections_named(key)}
    if blocked >= known:
        yield KeyFault((), "all sections are blocked, and nothing can move; leave one free")


class Sections:
    """The numbers of an actuator's sections, and which of them are blocked."""

    def __init__(
        self, actuator: Actuator, count: int, changes: Mapping[str, SectionChange] | None
    ) -> None:
        self._actuator, self._changes = actuator, changes or {}
        self._names = [str(j + 1) for j in range(count)]

    def each(self, name: str) -> Any:
        """A number of every section (S,), or that of the actuator where none has its own."""
        usual = getattr(self._actuator, name)
        return numbers_of(self._values(name, usual), usual)

    @property
    def heights(self) -> tuple[float, ...]:
        """Size along x of every section, where it is not that of the actuator [m]."""
        found = self.each("height")
        return tuple(found.tolist()) if isinstance(found, np.ndarray) else ()

    @property
    def blocked(self) -> np.ndarray | None:
        """Which sections neither bend nor stretch (S,); None where a spec names none."""
        values = self._values(BLOCKED, False)
        return None if values is None else np.array(list(values.values()), dtype=bool)

    def of_bellows(self, values: Any) -> Any:
        """Numbers of sections as those of their bellows, in the order of a graph (B,)."""
        return np.concatenate([values, values]) if isinstance(values, np.ndarray) else values

    def _values(self, name: str, usual: Any) -> dict[str, Any] | None:
        return values_by_member(self._changes, sections_named, self._names, name, usual)
