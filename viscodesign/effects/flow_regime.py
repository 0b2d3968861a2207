"""Flow regime: fast flow loses more than slow laminar flow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar, Self

import casadi as ca
import numpy as np

from viscodesign.effects.base import Effect, Missed, Trait
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System
from viscodesign.model.traced_formula import traced
from viscodesign.physics import tube
from viscodesign.physics.tube import LAMINAR_REYNOLDS
from viscodesign.postprocess.motion_limits import Limit, MotionBlock, Peak
from viscodesign.postprocess.sustained import Sustained
from viscodesign.references import LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.storage.disk_arrays import blocks

if TYPE_CHECKING:
    from viscodesign.postprocess.motion import Motion
    from viscodesign.solve.problem import Problem

SLOW_REYNOLDS = 1000.0
"""Reynolds number up to which the friction is that of laminar flow, to round-off."""


@dataclass(frozen=True, eq=False)
class FlowRegime(Effect):
    """Friction from laminar to turbulent flow, and losses at a tube's entrance and exit."""

    name: ClassVar[str] = "flow_regime"
    order: ClassVar[int] = 16
    formula: ClassVar[str] = "f Re/64 - 1 + K Re r/(32 L), at the largest flow"
    needs: ClassVar[tuple[str, ...]] = ("pressure_distribution",)
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.FLOW_LOSSES})
    validity: ClassVar[str] = (
        "Smooth tubes, fully developed flow; no law is reliable between Re 2300 and 4000."
    )
    source: ClassVar[str] = "Churchill (1977) for friction; local losses as for a sharp edge."
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "churchill1977",
            "article",
            {
                "author": "Churchill, S. W.",
                "title": "Friction-factor equation spans all fluid-flow regimes",
                "journal": "Chemical Engineering",
                "volume": "84",
                "number": "24",
                "pages": "91--92",
                "year": "1977",
            },
        ),
    )
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
            return "the network has no tubes"
        reynolds = self._reynolds(quantities.slow_flows)
        place = list(self.radii)[int(np.argmax(np.max(reynolds, axis=0)))]
        return (
            f"slow laminar flow would reach a Reynolds number of {np.max(reynolds):.3g} in {place}"
        )

    def _reynolds(self, flow: np.ndarray) -> np.ndarray:
        radius = np.array(list(self.radii.values()))
        return np.asarray(tube.reynolds_number(flow, self.density, self.viscosity, radius))

    def multiplier(self, flow: np.ndarray) -> np.ndarray:
        """Loss over that of slow laminar flow, at flows (..., T, Q) [m3/s]."""
        radius, resistance = np.array(list(self.radii.values())), self._resistance
        ends = np.array([self._ends(r) for r in radius])
        reynolds = self._reynolds(flow)
        friction, fast = np.ones_like(reynolds), reynolds > SLOW_REYNOLDS
        friction[fast] = tube.friction_multiplier(reynolds[fast], np)
        return np.asarray(friction + ends * np.abs(flow) / resistance)

    @property
    def _resistance(self) -> np.ndarray:
        return np.array(list(self.resistances.values()))

    def lost_pressure(self, flow: np.ndarray) -> np.ndarray:
        """Pressure lost beyond slow laminar flow along each tube (T, Q), at flows [m3/s] [Pa]."""
        return np.asarray((self.multiplier(flow) - 1) * self._resistance * np.abs(flow))

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        if self.name not in active:
            lag_s = quantities.filling_time
            yield Limit(self._block_reynolds, LAMINAR_REYNOLDS, self._turbulent, lag_s=lag_s)

    def _block_reynolds(self, block: MotionBlock) -> np.ndarray:
        return self._reynolds(block.flow)

    def _turbulent(self, peak: Peak) -> Notice:
        tubes = list(self.radii)
        count, name = int(np.sum(peak.columns > LAMINAR_REYNOLDS)), tubes[peak.column]
        return Notice(
            "turbulent_flow",
            f"the Reynolds number exceeds {LAMINAR_REYNOLDS:.0f} in {count} of {len(tubes)} tubes "
            f"and reaches {peak.value:.4g} in {name}: slow viscous flow does not hold there",
            name,
            peak.time_s,
        )

    def missed_in(
        self, quantities: SceneQuantities, problem: Problem, motion: Motion
    ) -> Missed | None:
        """The losses of the computed flows, as a share of the pressure that moves the tip."""
        lost, sustained = Peak(), Sustained(quantities.filling_time)
        for rows in blocks(len(motion.time), motion.time, motion.flow):
            along = self.lost_pressure(motion.flow[rows]).sum(axis=1, keepdims=True)
            lost.update(motion.time[rows], sustained.update(motion.time[rows], along))
        share = lost.value / quantities.swing
        reason = (
            f"at the computed flows it would cost {lost.value:.3g} Pa, {share:.2g} times the "
            "largest pressure"
        )
        way = motion.largest_displacement(quantities.body.lengths)
        return Missed(reason, min(share, 1.0) * way, lost.time_s)

    def _ends(self, radius: float) -> float:
        return tube.local_loss_coefficient(self.density, self.loss, radius)

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(flow_loss=self.multiplier)

    def join(self, system: System) -> None:
        density = system.parameter("fluid.density", self.density)
        viscosity = system.parameter("fluid.viscosity", self.viscosity)
        for name, radius in self.radii.items():
            flow = system.flow[name]
            size = system.parameter(f"radius.{name}", radius)
            reynolds = traced(tube.reynolds_number, flow, density, viscosity, size)
            ends = system.parameter(f"end_loss.{name}", self._ends(radius))
            system.drop[name] *= traced(tube.friction_multiplier, reynolds)
            system.drop[name] += ends * flow * ca.fabs(flow)
