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
class Wall(Effect):
    """A smooth, frictionless wall to the right of the tip.

    A penalty: the tip may enter, and is pushed back by the stiffness times the depth.
    """

    name: ClassVar[str] = "wall"
    order: ClassVar[int] = 60
    formula: ClassVar[str] = "k l^3 / (E I)"
    validity: ClassVar[str] = "Contact at the tip alone; the wall yields by force over stiffness."

    distance: float = 0.02
    """From the clamped axis, towards R [m]."""
    stiffness: float = 500.0
    """Force on the tip per depth [N/m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls()

    def weight(self, quantities: SceneQuantities) -> float:
        length = quantities.body.length
        return self.stiffness * length / quantities.bending_force

    def reason(self, quantities: SceneQuantities) -> str:
        return f"a wall {1000 * self.distance:.3g} mm beside the clamped axis"

    def join(self, system: System) -> None:
        depth = ca.fmax(0, system.rod.tip[0] - system.parameter("wall.distance", self.distance))
        stiffness = system.parameter("wall.stiffness", self.stiffness)
        system.load_potential += stiffness * depth**2 / 2
