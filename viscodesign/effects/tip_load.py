"""Tip load: a dead force on the tip, and a payload carried there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.effects.load_limit import load_faults
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System


@dataclass(frozen=True)
class TipLoad(Effect):
    """A force of fixed direction and a payload at the tip.

    The payload adds mass, which gravity and inertia then act on.
    """

    name: ClassVar[str] = "tip_load"
    order: ClassVar[int] = 5  # before everything that acts on masses
    formula: ClassVar[str] = "F l^2 / (E I)"
    own_rule: ClassVar[str] = (
        "It is included where a spec defines it, also with `others: off`; "
        "`effects.tip_load: off` leaves it out."
    )
    validity: ClassVar[str] = "A force of constant direction; a payload that is a point mass."
    keys: ClassVar[tuple[str, ...]] = ("loads.tip_force", "loads.payload")

    force_x: float
    force_z: float
    payload: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        loads = quantities.scene.loads
        return cls(loads.tip_force.x, loads.tip_force.z, loads.payload)

    def present(self, quantities: SceneQuantities) -> bool:
        return (self.force_x, self.force_z, self.payload) != (0.0, 0.0, 0.0)

    def indispensable(self, quantities: SceneQuantities) -> bool:
        return True  # a stated load is carried, however small, unless the spec leaves it out

    def weight(self, quantities: SceneQuantities) -> float:
        carried = self.payload * quantities.acceleration
        return (quantities.tip_force + carried) / quantities.bending_force

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "the tip is free"
        return f"{quantities.tip_force:.3g} N and {1000 * self.payload:.3g} g act at the tip"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(tip_force=(self.force_x, self.force_z), tip_mass=self.payload)

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        return load_faults(quantities, quantities.tip_force, "loads.tip_force")

    def join(self, system: System) -> None:
        if self.payload:
            system.rod.add_tip_mass(system.parameter("payload", self.payload))
        if abs(self.force_x) + abs(self.force_z):
            x = system.parameter("tip_force.x", self.force_x)
            z = system.parameter("tip_force.z", self.force_z)
            tip = system.rod.tip
            system.load_potential -= x * tip[0] + z * tip[1]
