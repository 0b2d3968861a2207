"""`effects.wall`: an effect in one file, a wall beside the tip that pushes back.

docs/extending.md has the contract of an effect and says how the package finds this file.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

import casadi as ca

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System


@dataclass(frozen=True)
class TipWall(Effect):
    """A flat, frictionless wall to the right of the tip, where a spec says `wall: on`.

    Contact by a penalty: the tip may enter the wall, which pushes back by its stiffness times the
    depth.
    """

    name: ClassVar[str] = "wall"
    order: ClassVar[int] = 60
    formula: ClassVar[str] = "1 - d / l"
    validity: ClassVar[str] = "Contact at the tip only; the wall yields by force over stiffness."
    keys: ClassVar[tuple[str, ...]] = ("actuator.length",)

    distance: float = 0.02
    """From the clamp's axis, towards R [m]."""
    stiffness: float = 500.0
    """Force on the tip per depth [N/m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls()

    def present(self, quantities: SceneQuantities) -> bool:
        return quantities.scene.effects.mode(self.name) == "on"

    def weight(self, quantities: SceneQuantities) -> float:
        """Part of the length that the tip can no longer move to the right."""
        return max(0.0, 1 - self.distance / quantities.body.length)

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "there is a wall only where the spec says `wall: on`"
        return f"a wall {1000 * self.distance:.3g} mm beside the clamp's axis"

    def join(self, system: System) -> None:
        distance = system.parameter("wall.distance", self.distance)
        stiffness = system.parameter("wall.stiffness", self.stiffness)
        depth = ca.fmax(0, system.rod.tip[0] - distance)
        system.load_potential += stiffness * depth**2 / 2
