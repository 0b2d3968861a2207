"""Tip load: a dead force on the tip, and a payload carried there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, NamedTuple, Self

from viscodesign.effects.base import Effect
from viscodesign.effects.load_limit import load_faults
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System, rod_endings


class TipLoads(NamedTuple):
    """What acts on one tip: a force [N] and a payload [kg]."""

    force_x: float
    force_z: float
    payload: float


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

    loads: tuple[TipLoads, ...]
    """Loads of every rod."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        each = quantities.scene.loads_of_rods
        return cls(tuple(TipLoads(o.tip_force.x, o.tip_force.z, o.payload) for o in each))

    def present(self, quantities: SceneQuantities) -> bool:
        return any(own != (0.0, 0.0, 0.0) for own in self.loads)

    def indispensable(self, quantities: SceneQuantities) -> bool:
        return True  # a stated load is carried, however small, unless the spec leaves it out

    def weight(self, quantities: SceneQuantities) -> float:
        carried = self.largest_payload * quantities.acceleration
        return (quantities.tip_force + carried) / quantities.bending_force

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "the tip is free"
        return (
            f"{quantities.tip_force:.3g} N and {1000 * self.largest_payload:.3g} g act at the tip"
        )

    def estimate_term(self) -> EstimateTerm:
        x, z, payload = self.loads[0]
        return EstimateTerm(tip_force=(x, z), tip_mass=payload)

    @property
    def largest_payload(self) -> float:
        """[kg]"""
        return max(own.payload for own in self.loads)

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        return load_faults(quantities, quantities.tip_force, "loads.tip_force")

    def join(self, system: System) -> None:
        for rod, own, end in zip(system.rod.rods, self.loads, rod_endings(system), strict=True):
            if own.payload:
                rod.add_tip_mass(system.parameter(f"payload{end}", own.payload))
            if abs(own.force_x) + abs(own.force_z):
                x = system.parameter(f"tip_force.x{end}", own.force_x)
                z = system.parameter(f"tip_force.z{end}", own.force_z)
                tip = rod.tip
                system.load_potential -= x * tip[0] + z * tip[1]
