"""Gas compressibility: a gas yields, in the bellows and along the tubes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect, Missed, Trait
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.fluid import Gas
from viscodesign.model.system import System
from viscodesign.physics import gas, tube
from viscodesign.physics.choking import CHOKING_MACH
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.postprocess.sustained import Sustained
from viscodesign.results.findings import Notice
from viscodesign.storage.disk_arrays import blocks

if TYPE_CHECKING:
    from viscodesign.postprocess.motion import Motion
    from viscodesign.solve.problem import Problem

INCOMPRESSIBLE_MACH = 0.3
"""Mach number from which a gas can no longer be taken as incompressible."""


@dataclass(frozen=True)
class PolytropicGas:
    """The gas law as an estimate of the motion needs it."""

    exponent: float

    def density(self, pressure: np.ndarray, ambient: float) -> np.ndarray:
        """Density over that at ambient pressure [1]."""
        return np.asarray(gas.density_ratio(pressure, ambient, self.exponent))

    def compliance(self, volume: np.ndarray, absolute: np.ndarray) -> np.ndarray:
        """Volume per pressure of an amount of gas [m3/Pa]."""
        return volume / (self.exponent * absolute)


@dataclass(frozen=True)
class GasCompressibility(Effect):
    """The gas's mass is conserved, not its volume.

    Its density follows the absolute pressure, (rho/rho_0)^n = P/P_0; a tube carries
    mass by the integral of density over pressure. Amounts and flows are volumes at
    ambient density.
    """

    name: ClassVar[str] = "gas_compressibility"
    order: ClassVar[int] = 14
    formula: ClassVar[str] = "V_0 / (n_poly p_abs C)"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.COMPRESSIBLE_FLUID})
    validity: ClassVar[str] = (
        "A polytropic ideal gas of constant viscosity; alone, at Mach numbers below 0.3."
    )
    source: ClassVar[str] = "Ideal gas; Hagen-Poiseuille for each slice of a tube."
    keys: ClassVar[tuple[str, ...]] = (
        "fluid.gas_constant",
        "fluid.polytropic_exponent",
        "ambient_pressure",
    )

    is_gas: bool
    exponent: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        fluid = quantities.scene.fluid
        return cls(fluid.is_gas, fluid.polytropic_exponent)

    def present(self, quantities: SceneQuantities) -> bool:
        return self.is_gas

    def indispensable(self, quantities: SceneQuantities) -> bool:
        # A jump at the start drives a gas for an instant that no solved run is asked about.
        if not self.is_gas or not quantities.graph.tubes:
            return False
        return bool(np.max(_mach(quantities, quantities.first_flows)) > INCOMPRESSIBLE_MACH)

    def weight(self, quantities: SceneQuantities) -> float:
        law, scene = quantities.bellow, quantities.scene
        absolute = scene.ambient_pressure + scene.gauge_pressure
        return gas.gas_compliance(law.rest_volume, absolute, self.exponent) / law.compliance

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.is_gas:
            return f"{quantities.scene.fluid.name} is a liquid (no gas constant)"
        return (
            f"the gas in a bellow stores {100 * self.weight(quantities):.3g} % of what its wall "
            "stores"
        )

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(fluid=PolytropicGas(self.exponent))

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        scene, tubes = quantities.scene, quantities.graph.tubes
        if self.name in active or scene.fluid.speed_of_sound is None:
            return

        def too_fast(peak: Peak) -> Notice:
            name, is_choked = tubes[peak.column].name, peak.value > CHOKING_MACH
            result = "it would choke" if is_choked else "incompressible flow does not hold"
            return Notice(
                "choking" if is_choked else "fast_gas",
                f"the {'gas' if scene.fluid.is_gas else 'fluid'} reaches Mach {peak.value:.3g} in "
                f"{name}: {result} there",
                name,
                peak.time_s,
            )

        yield Limit(
            lambda block: _mach(quantities, block.flow),
            INCOMPRESSIBLE_MACH,
            too_fast,
            lag_s=quantities.filling_time,
        )

    def missed_in(
        self, quantities: SceneQuantities, problem: Problem, motion: Motion
    ) -> Missed | None:
        """Gas that goes too fast to be taken as incompressible."""
        fastest, way = Peak(), motion.largest_displacement(quantities.body.lengths)
        sustained = Sustained(quantities.filling_time)
        for rows in blocks(len(motion.time), motion.time, motion.flow):
            time = motion.time[rows]
            fastest.update(time, sustained.update(time, _mach(quantities, motion.flow[rows])))
        if fastest.value <= INCOMPRESSIBLE_MACH or way == 0.0:
            return None
        name = quantities.graph.tubes[fastest.column].name
        reason = f"the gas reaches Mach {fastest.value:.3g} in {name}"
        squared = fastest.value**2
        return Missed(reason, way * squared / (1 + squared), fastest.time_s, leaves_validity=True)

    def join(self, system: System) -> None:
        system.fluid = Gas(system.ambient, self.exponent)


def _mach(quantities: SceneQuantities, flow: np.ndarray) -> np.ndarray:
    """Mach number of flows at ambient density (T, Q)."""
    radius = np.array([t.radius for t in quantities.graph.tubes])
    sound = quantities.scene.fluid.speed_of_sound or math.inf
    return np.asarray(tube.mean_speed(flow, radius) / sound)
