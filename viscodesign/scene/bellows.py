"""`bellows:` number, size and measured coefficients of the bellows."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AfterValidator, Field, field_validator, model_validator

from viscodesign.model.graph import bellow_names
from viscodesign.scene.bellow_changes import BellowChange, bellow_change_faults, bellows_named
from viscodesign.scene.bellow_curve import BellowCurve, falls
from viscodesign.scene.integer import Integer
from viscodesign.scene.member_changes import numbers_of, values_by_member
from viscodesign.scene.spec_part import SpecPart, invalid, invalid_at, raise_faults
from viscodesign.units import (
    Angle,
    AreaPerForce,
    AreaPerMoment,
    AreaPerPressure,
    Fraction,
    Length,
)

MAX_BELLOWS = 4096


def _paired(count: int) -> int:
    if count < 2 or count > MAX_BELLOWS:
        raise invalid(f"must be an even number from 2 to {MAX_BELLOWS}; got {count}")
    if count % 2:
        raise invalid(
            f"{count} is odd; bellows come in pairs, one left and one right. "
            f"Use {count - 1} or {count + 1}"
        )
    return count


class Bellows(SpecPart):
    """Bellows in pairs, one right and one left of the axis in every section."""

    count: Annotated[Integer, AfterValidator(_paired)] = Field(
        description="Number of bellows, even"
    )
    height: Length = Field(gt=0, description="Size along x", examples=["10 mm"])
    width: Length = Field(gt=0, description="Size along z", examples=["12 mm"])
    length: Length = Field(gt=0, description="Size along the flow", examples=["18 mm"])
    area_per_pressure: AreaPerPressure = Field(
        gt=0, description="Growth of one bellow's section (height x width) per pressure, da1/dp"
    )
    angle_per_pressure: Angle = Field(
        description="Turn of a section per (left minus right pressure)/E, dpsi/d(p'/E)",
        examples=["10.266 rad"],
    )
    extension_per_pressure: Length = Field(
        description="Lengthening of a section per (left plus right pressure)/E, dzeta/d(pbar/E)",
        examples=["47 mm"],
    )
    area_per_force: AreaPerForce = Field(
        0.0, description="Growth of a bellow's section per tension of the rod, da1/dN_e"
    )
    area_per_moment: AreaPerMoment = Field(
        0.0, description="Growth of a left bellow's section per moment of the rod, da1/dM_e"
    )
    collapse_fraction: Fraction = Field(
        0.1,
        ge=0,
        lt=1,
        description="Minimum volume of a bellow relative to its rest volume",
        examples=["10 %"],
    )
    curve: BellowCurve | None = Field(
        None, description="Measured curve of one bellow, replaces the linear coefficients"
    )
    changes: dict[str, BellowChange] | None = Field(
        None,
        description="Bellows that differ, by name or range: R3, L1-L4, or 3 and 1-4 for both "
        "bellows of these sections",
    )

    @field_validator("changes", mode="before")
    @classmethod
    def _named(cls, given: Any) -> Any:
        return {str(key): own for key, own in given.items()} if isinstance(given, dict) else given

    @model_validator(mode="after")
    def _check_changes(self) -> Bellows:
        if self.changes is None:
            return self
        found = bellow_change_faults(self.changes, self.count // 2)
        raise_faults(f._replace(path=("changes", *f.path)) for f in found)
        curves = (self._by_name("curve") or {}).values()
        if any(curve is None for curve in curves):
            raise invalid_at(
                "curve",
                "missing; some bellows have a curve by 'changes', and others have none. Give one "
                "here, which all others then follow",
            )
        return self

    def each(self, name: str) -> Any:
        """A number of every bellow in the order of a graph (B,), or one where none has its own."""
        return numbers_of(self._by_name(name), getattr(self, name))

    def _by_name(self, name: str) -> dict[str, Any] | None:
        names, usual = bellow_names(self.count // 2), getattr(self, name)
        return values_by_member(self.changes or {}, bellows_named, names, name, usual)

    @property
    def curves(self) -> tuple[BellowCurve, ...]:
        """The measured curves: none, one for all bellows, or one of each in the graph's order."""
        own = self._by_name("curve")
        if own is None:
            return () if self.curve is None else (self.curve,)
        return tuple(own.values())


def snaps(bellows: Bellows) -> bool:
    """Whether a measured curve makes a bellow snap through."""
    return any(falls(curve.rows or ()) for curve in bellows.curves)
