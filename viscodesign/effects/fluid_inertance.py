"""Fluid inertance: the fluid in the tubes resists acceleration."""

from __future__ import annotations

import math
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System
from viscodesign.physics import tube


@dataclass(frozen=True, eq=False)
class FluidInertance(Effect):
    """Pressure that accelerates the fluid in each tube; the flow is then a state."""

    name: ClassVar[str] = "fluid_inertance"
    order: ClassVar[int] = 17
    formula: ClassVar[str] = "(4/3) rho r^2 / (8 mu t_i)"
    needs: ClassVar[tuple[str, ...]] = ("pressure_distribution",)
    # Its losses make the flows unknowns already, and inertance makes them smooth at rest.
    free_with: ClassVar[str] = "flow_regime"
    validity: ClassVar[str] = (
        "The velocity profile of steady laminar flow; no pressure waves within a tube."
    )
    source: ClassVar[str] = "Momentum of a parabolic profile."
    keys: ClassVar[tuple[str, ...]] = (
        "fluid.density",
        "network.tube_radius",
        "network.tube_length",
        "network.changes",
        "network.tubes",
        "network.feed_line",
    )

    inertances: dict[str, float]
    delay: float
    """Inertance over resistance, of all tubes together [s]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        density, tubes = quantities.scene.fluid.density, quantities.graph.tubes
        found = {t.name: tube.fluid_inertance(density, t.length, t.radius) for t in tubes}
        resistance = sum(quantities.resistances.values())
        return cls(found, sum(found.values()) / resistance if tubes else 0.0)

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.inertances)

    def weight(self, quantities: SceneQuantities) -> float:
        swing = max(quantities.scales.t_i, quantities.scales.t_net * 1e-6)
        return self.delay / swing if math.isfinite(swing) and swing > 0.0 else 0.0

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.inertances:
            return "the network has no tubes"
        return f"viscosity damps a flow within {self.delay:.3g} s"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(inertance=tuple(self.inertances.values()))

    def join(self, system: System) -> None:
        for t in system.graph.tubes:
            inertance = system.parameter(f"inertance.{t.name}", self.inertances[t.name])
            middle = (system.node_pressure(t.start) + system.node_pressure(t.end)) / 2
            system.inertance[t.name] = inertance * system.fluid.density(middle)
