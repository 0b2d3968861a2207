"""`effects.wall`: an effect in one file, a wall beside the tip that pushes back.

In a spec `wall: on`, or with its options `wall: {mode: on, distance: 30 mm, stiffness: 1 N/mm}`.
docs/extending.md has the contract of an effect and says how the package finds this file.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar, Self

import casadi as ca
from pydantic import Field

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.results.findings import Notice
from viscodesign.scene.spec_part import SpecPart
from viscodesign.units import Length, SpringStiffness


class WallOptions(SpecPart):
    """Where the wall stands, and how hard it is."""

    distance: Length = Field(0.02, gt=0, description="From the clamp's axis, towards R")
    stiffness: SpringStiffness = Field(500.0, gt=0, description="Force on the tip per depth")
    deepest: Length = Field(0.005, ge=0, description="Depth of the tip that a run warns about")


@dataclass(frozen=True)
class TipWall(Effect):
    """A flat, frictionless wall to the right of the tip, where a spec has it on.

    Contact by a penalty: the tip may enter the wall, which pushes back by its stiffness times the
    depth.
    """

    name: ClassVar[str] = "wall"
    order: ClassVar[int] = 60
    formula: ClassVar[str] = "1 - d / l"
    validity: ClassVar[str] = "Contact at the tip only; the wall yields by force over stiffness."
    keys: ClassVar[tuple[str, ...]] = ("actuator.length",)

    options: ClassVar[type[WallOptions]] = WallOptions

    own: WallOptions

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls(quantities.scene.effects.options_of(cls.name, cls.options))

    def present(self, quantities: SceneQuantities) -> bool:
        return quantities.scene.effects.mode(self.name) == "on"

    def weight(self, quantities: SceneQuantities) -> float:
        """Part of the length that the tip can no longer move to the right."""
        return max(0.0, 1 - self.own.distance / quantities.body.length)

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "there is a wall only where the spec has it on, as in `wall: on`"
        return f"a wall {1000 * self.own.distance:.3g} mm beside the clamp's axis"

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        if self.name in active:
            yield Limit(
                lambda block: block.tip[:, 0] - self.own.distance, self.own.deepest, self._too_deep
            )

    def _too_deep(self, peak: Peak) -> Notice:
        message = (
            f"the tip is {1000 * peak.value:.3g} mm inside the wall, which yields too much to be "
            "one; raise effects.wall.stiffness"
        )
        return Notice("deep_in_wall", message, "effects.wall", peak.time_s)

    def join(self, system: System) -> None:
        distance = system.parameter("wall.distance", self.own.distance)
        stiffness = system.parameter("wall.stiffness", self.own.stiffness)
        for rod in system.rod.rods:  # several where actuators share fluid
            depth = ca.fmax(0, rod.tip[0] - distance)
            system.load_potential += stiffness * depth**2 / 2
