"""Flow regime: fast flow loses more than slow laminar flow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

import casadi as ca
import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System
from viscodesign.physics import tube


@dataclass(frozen=True, eq=False)
class FlowRegime(Effect):
    """Friction from laminar to turbulent flow, and losses at a tube's entrance and exit."""

    name: ClassVar[str] = "flow_regime"
    order: ClassVar[int] = 16
    formula: ClassVar[str] = "f Re/64 - 1 + K Re r/(32 L), at the largest flow"
    needs: ClassVar[str] = "pressure_distribution"
    validity: ClassVar[str] = (
        "Smooth tubes, developed flow at every instant; between Re 2300 and 4000 no law is sure."
    )
    source: ClassVar[str] = "Churchill (1977) for friction; local losses as for a sharp edge."
    keys: ClassVar[tuple[str, ...]] = (
        "network.entrance_loss",
        "network.exit_loss",
        "fluid.density",
    )

    density: float
    viscosity: float
    radii: dict[str, float]
    resistances: dict[str, float]
    loss: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        fluid, network = quantities.scene.fluid, quantities.scene.network
        return cls(
            fluid.density,
            fluid.viscosity,
            {t.name: t.radius for t in quantities.graph.tubes},
            quantities.resistances,
            network.entrance_loss + network.exit_loss,
        )

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.radii)

    def weight(self, quantities: SceneQuantities) -> float:
        flow = quantities.slow_flows
        return float(np.max(self.multiplier(flow), initial=1.0)) - 1.0

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.radii:
            return "no tube joins anything"
        reynolds = self._reynolds(quantities.slow_flows)
        place = list(self.radii)[int(np.argmax(np.max(reynolds, axis=0)))]
        return (
            f"slow laminar flow would reach a Reynolds number of {np.max(reynolds):.3g} in {place}"
        )

    def _reynolds(self, flow: np.ndarray) -> np.ndarray:
        radius = np.array(list(self.radii.values()))
        return np.asarray(tube.reynolds_number(flow, self.density, self.viscosity, radius))

    def multiplier(self, flow: np.ndarray) -> np.ndarray:
        """Loss over that of slow laminar flow, at flows (T, Q) [m3/s]."""
        radius, resistance = np.array(list(self.radii.values())), self._resistance
        ends = np.array([self._ends(r) for r in radius])
        friction = tube.friction_multiplier(self._reynolds(flow), np)
        return np.asarray(friction + ends * np.abs(flow) / resistance)

    @property
    def _resistance(self) -> np.ndarray:
        return np.array(list(self.resistances.values()))

    def lost_pressure(self, flow: np.ndarray) -> np.ndarray:
        return np.asarray((self.multiplier(flow) - 1) * self._resistance * np.abs(flow))

    def _ends(self, radius: float) -> float:
        return tube.local_loss_coefficient(self.density, self.loss, radius)

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(loss=self.multiplier)

    def join(self, system: System) -> None:
        density = system.parameter("fluid.density", self.density)
        viscosity = system.parameter("fluid.viscosity", self.viscosity)
        for name, radius in self.radii.items():
            flow = system.flow[name]
            size = system.parameter(f"radius.{name}", radius)
            reynolds = tube.reynolds_number(flow, density, viscosity, size, ca)
            ends = system.parameter(f"end_loss.{name}", self._ends(radius))
            system.drop[name] *= tube.friction_multiplier(reynolds, ca)
            system.drop[name] += ends * flow * ca.fabs(flow)
