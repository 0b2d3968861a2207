"""`loads.ground`: a rigid surface that the actuator may touch."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from viscodesign.scene.spec_part import KeyFault, SpecPart, raise_faults
from viscodesign.units import Angle, Fraction, Length

TIP = "tip"
"""Name of the tip among the points that may touch a ground."""


class GroundPoint(SpecPart):
    """A point of the plane in which the actuator bends."""

    x: Length = Field(0.0, description="To the right")
    z: Length = Field(0.0, description="Away from the clamp")


class Ground(SpecPart):
    """A straight or a round surface, rigid and at rest, with Coulomb friction."""

    kind: Literal["line", "circle"] = Field(
        description="A straight surface, such as a floor or a wall, or a round one, such as a pin"
    )
    point: GroundPoint | None = Field(None, description="Any point of a line")
    normal: Angle | None = Field(
        None,
        description="Direction in which a line pushes, from +z towards +x: 180 deg for a floor "
        "below a hanging actuator, -90 deg for a wall on its right",
    )
    centre: GroundPoint | None = Field(None, description="Centre of a circle")
    radius: Length | None = Field(None, gt=0, description="Radius of a circle")
    friction: Fraction = Field(ge=0, description="Coefficient of friction; 0 where it is smooth")
    foot_radius: Length = Field(
        0.0, ge=0, description="Radius of a round tip, which rolls; 0 for a point"
    )
    touches: Literal["tip", "sections"] = Field(
        "tip", description="What may touch it: the tip, or the axis at the end of every section"
    )

    @model_validator(mode="after")
    def _one_kind(self) -> Ground:
        raise_faults(self._faults())
        return self

    def points(self, sections: int) -> tuple[str, ...]:
        """Names of the points that may touch it, of an actuator of so many sections; the tip last.

        Section k of ``sections`` ends at its point ``section_k``.
        """
        inner = range(1, sections if self.touches == "sections" else 1)
        return (*(f"section_{k}" for k in inner), TIP)

    def _faults(self) -> list[KeyFault]:
        """Keys that its kind needs and does not have, or the other way round."""
        keys = {"line": ("point", "normal"), "circle": ("centre", "radius")}
        own, other = keys[self.kind], keys["circle" if self.kind == "line" else "line"]
        missing = [key for key in own if getattr(self, key) is None]
        foreign = [key for key in other if getattr(self, key) is not None]
        return [
            *(KeyFault((), f"a {self.kind} needs {key}") for key in missing),
            *(
                KeyFault((key,), f"a {self.kind} has no {key}; it has {own[0]} and {own[1]}")
                for key in foreign
            ),
        ]
