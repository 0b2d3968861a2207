"""Fluid mass: what the bellows hold has weight and inertia."""

from __future__ import annotations

from typing import ClassVar, Self

from casadi import SX

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import places
from viscodesign.model.system import System


@dataclass(frozen=True)
class FluidMass(Effect):
    """The fluid in the bellows as a mass on the axis, as much as they hold at each instant.

    Gravity and inertia act on it where they are included. Its weight also gives a head: the
    pressure of a network at rest increases downwards. Inflow has the speed of the section
    that it enters.
    """

    name: ClassVar[str] = "fluid_mass"
    order: ClassVar[int] = 6  # before everything that acts on masses
    formula: ClassVar[str] = "n V_0 rho_f / (m l)"
    validity: ClassVar[str] = (
        "The fluid of a section is spread evenly along its axis; that in the tubes is neglected."
    )
    source: ClassVar[str] = "Lagrange's equations with the mass that each bellow holds."
    keys: ClassVar[tuple[str, ...]] = (
        "fluid.density",
        "bellows.height",
        "bellows.width",
        "bellows.length",
    )

    density: float
    amount: float
    """Volume at rest of all bellows [m3]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        amount = len(quantities.graph.bellows) * quantities.bellow.rest_volume
        return cls(quantities.scene.fluid.density, amount)

    def weight(self, quantities: SceneQuantities) -> float:
        return self.amount * self.density / quantities.solid_mass

    def reason(self, quantities: SceneQuantities) -> str:
        held, solid = 1e3 * self.amount * self.density, 1e3 * quantities.solid_mass
        return f"the bellows hold {held:.3g} g at rest, the body weighs {solid:.3g} g"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(held_density=self.density)

    def join(self, system: System) -> None:
        density = system.parameter("fluid.density", self.density)
        held = [SX(0) for _ in range(system.graph.sections)]
        for name, place in places(system.graph).items():
            held[place.section] += density * system.amount[name]
        system.rod.add_carried_mass(held)
