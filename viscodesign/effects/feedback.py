"""Solid-to-fluid feedback: force and moment of a section change its bellows' volumes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.bellow_law import places
from viscodesign.model.system import System


@dataclass(frozen=True)
class Feedback(Effect):
    """Volume stored by the section's normal force and moment; equation (1), last term."""

    name: ClassVar[str] = "feedback"
    order: ClassVar[int] = 45
    formula: ClassVar[str] = "(da/dN N + da/dM M) / (da/dp p)"
    validity: ClassVar[str] = "Small changes of a bellow's volume by the loads of its section."
    source: ClassVar[str] = "The paper, equation (1)."
    keys: ClassVar[tuple[str, ...]] = ("bellows.area_per_force", "bellows.area_per_moment")

    area_per_force: float
    area_per_moment: float
    length: float
    """Of a bellow along the stream [m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        bellows = quantities.scene.bellows
        return cls(bellows.area_per_force, bellows.area_per_moment, bellows.length)

    def present(self, quantities: SceneQuantities) -> bool:
        return (self.area_per_force, self.area_per_moment) != (0.0, 0.0)

    def weight(self, quantities: SceneQuantities) -> float:
        force = quantities.load_force
        area = (
            abs(self.area_per_force) + abs(self.area_per_moment) * quantities.body.length
        ) * force
        return area / (quantities.scene.bellows.area_per_pressure * quantities.swing)

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "bellows.area_per_force and area_per_moment are zero"
        if quantities.load_force == 0.0:
            return "nothing loads the rod, so there is nothing to feed back"
        return f"forces up to about {quantities.load_force:.2g} N act on the sections"

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(
            volume_per_force=self.length * self.area_per_force,
            volume_per_moment=self.length * self.area_per_moment,
        )

    def join(self, system: System) -> None:
        length = system.bellow.length
        per_force = system.parameter("area_per_force", self.area_per_force)
        per_moment = system.parameter("area_per_moment", self.area_per_moment)
        for name, place in places(system.graph).items():
            force, moment = system.normal_force[place.section], system.moment[place.section]
            area = per_force * force + place.side * per_moment * moment
            system.extra_volume[name] += length * area
