"""Choked flow: a gas speeds up along a tube, and leaves it no faster than it can."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect, Missed
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System
from viscodesign.model.traced_formula import traced
from viscodesign.physics import choking, gas, tube
from viscodesign.postprocess.motion_limits import Limit, MotionBlock, Peak
from viscodesign.postprocess.sustained import Sustained
from viscodesign.postprocess.tube_ends import end_pressures
from viscodesign.references import LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.storage.disk_arrays import blocks

if TYPE_CHECKING:
    from viscodesign.postprocess.motion import Motion
    from viscodesign.solve.problem import Problem

MIN_RATIO = 0.02
"""Absolute over ambient pressure below which an estimate takes no gas to be thinner."""


@dataclass(frozen=True, eq=False)
class ChokedFlow(Effect):
    """Pressure that speeds up a gas along each tube, and the largest flow that it lets through.

    Where the pressure behind a tube is so low that the gas would leave it faster than its own
    speed of sound (the isothermal one, Mach 1/sqrt(gamma), or that of the polytropic exponent),
    the flow no longer depends on what is behind.
    """

    name: ClassVar[str] = "choked_flow"
    order: ClassVar[int] = 18
    formula: ClassVar[str] = "Ma^2 = v^2 rho / (n_poly p_abs), of slow laminar flow"
    needs: ClassVar[tuple[str, ...]] = ("pressure_distribution", "gas_compressibility")
    validity: ClassVar[str] = (
        "Steady flow along each tube, a flat profile, heat exchange as the polytropic exponent "
        "says; losses at the ends count as friction, within 4 % of the largest flow."
    )
    source: ClassVar[str] = (
        "Shapiro (1953), chapter 6: isothermal flow with friction; Crane TP 410, equation 1-6."
    )
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "shapiro1953",
            "book",
            {
                "author": "Shapiro, Ascher H.",
                "title": "The Dynamics and Thermodynamics of Compressible Fluid Flow",
                "volume": "1",
                "publisher": "Ronald Press",
                "year": "1953",
            },
        ),
    )
    keys: ClassVar[tuple[str, ...]] = (
        "fluid.density",
        "fluid.polytropic_exponent",
        "ambient_pressure",
        "network.tube_radius",
    )

    is_gas: bool
    exponent: float
    coefficients: dict[str, float]
    """Momentum flux per flow squared of every tube [Pa s2/m6]."""
    quantities: SceneQuantities
    """The scene's numbers, for the flows that an estimate starts from."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        fluid, tubes = quantities.scene.fluid, quantities.graph.tubes
        found = {t.name: choking.momentum_coefficient(fluid.density, t.radius) for t in tubes}
        return cls(fluid.is_gas, fluid.polytropic_exponent, found, quantities)

    def present(self, quantities: SceneQuantities) -> bool:
        return self.is_gas and bool(self.coefficients)

    # -- whether it matters -----------------------------------------------------

    def indispensable(self, quantities: SceneQuantities) -> bool:
        # A jump at the start drives a gas for an instant that no solved run is asked about.
        first = quantities.first_flows
        pressure = quantities.slow_tube_pressures[: len(first)]
        return bool(np.max(self._mach(first, pressure), initial=0.0) > choking.CHOKING_MACH)

    def weight(self, quantities: SceneQuantities) -> float:
        return float(np.max(self._mach_squared(quantities.slow_flows), initial=0.0))

    def _mach_squared(self, flow: np.ndarray) -> np.ndarray:
        """Squared Mach numbers of flows (..., T, Q) [m3/s] at the densities of slow laminar flow
        (T, Q) [1]."""
        ambient = self.quantities.scene.ambient_pressure
        ratio = np.maximum(1 + self.quantities.slow_tube_pressures / ambient, MIN_RATIO)
        coefficient = np.array(list(self.coefficients.values()))
        return np.asarray(choking.mach_squared(flow, ratio, ambient, self.exponent, coefficient))

    def multiplier(self, flow: np.ndarray) -> np.ndarray:
        """Pressure lost over that of slow laminar flow at flows (..., T, Q) [m3/s].

        That of each tube's fastest moment, as the loss grows with the cube of the flow: a mean
        would be several times too small. The start's jump lasts for no time. Where a gas chokes,
        its change of speed takes about as much as friction, however low the pressure behind.
        """
        squared = self._mach_squared(flow)[..., 1:, :]
        fastest = np.max(squared, axis=-2, keepdims=True, initial=0.0)
        return np.broadcast_to(1 + fastest / (1 + fastest), flow.shape)

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.is_gas:
            return f"{quantities.scene.fluid.name} is a liquid (no gas constant)"
        if not self.coefficients:
            return "the network has no tubes"
        size = np.max(self._mach_squared(quantities.slow_flows), axis=0, initial=0.0)
        place = list(self.coefficients)[int(np.argmax(size))]
        return (
            f"slow laminar flow would reach {np.sqrt(np.max(size)):.3g} times the speed at which "
            f"it chokes, in {place}"
        )

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(flow_loss=self.multiplier)

    # -- the term -----------------------------------------------------------------

    def join(self, system: System) -> None:
        for t in system.graph.tubes:
            coefficient = system.parameter(
                f"choked_flow.momentum.{t.name}", self.coefficients[t.name]
            )
            system.drop[t.name] += traced(
                choking.acceleration_drop,
                system.flow[t.name],
                system.node_pressure(t.start),
                system.node_pressure(t.end),
                system.ambient,
                self.exponent,
                coefficient,
            )

    # -- what a user is told --------------------------------------------------------

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        _, compressible = self.needs
        if self.is_gas and self.name not in active and compressible in active:
            lag_s = quantities.filling_time
            yield Limit(self._block_mach, choking.CHOKING_MACH, self._too_fast, lag_s=lag_s)

    def _block_mach(self, block: MotionBlock) -> np.ndarray:
        return self._mach(block.flow, block.tube_pressure)

    def _mach(self, flow: np.ndarray, lower: np.ndarray) -> np.ndarray:
        """Mach number at the thinner end of each tube, of flows and pressures there (T, Q)."""
        scene, tubes = self.quantities.scene, self.quantities.graph.tubes
        ambient = scene.ambient_pressure
        gauge = np.maximum(lower, -0.999 * ambient)
        density = gas.density_ratio(gauge, ambient, self.exponent)
        speed = tube.mean_speed(flow, np.array([t.radius for t in tubes])) / density
        return np.asarray(speed / (scene.fluid.speed_of_sound or np.inf))

    def _too_fast(self, peak: Peak) -> Notice:
        name = list(self.coefficients)[peak.column]
        reason = f"the gas reaches Mach {peak.value:.3g} in {name}: it would choke there"
        return Notice("choking", reason, name, peak.time_s)

    def missed_in(
        self, quantities: SceneQuantities, problem: Problem, motion: Motion
    ) -> Missed | None:
        """Gas faster than it can be; else what the computed flows would lose, as for friction."""
        fastest, lost, scene = Peak(), Peak(), quantities.scene
        speed, loss = Sustained(quantities.filling_time), Sustained(quantities.filling_time)
        way = motion.largest_displacement(quantities.body.lengths)
        coefficient = np.array(list(self.coefficients.values()))
        for rows in blocks(len(motion.time), motion.time, motion.flow):
            time, flow = motion.time[rows], motion.flow[rows]
            start, end = end_pressures(quantities.graph, motion, tuple(scene.inputs), rows)
            fastest.update(time, speed.update(time, self._mach(flow, np.minimum(start, end))))
            along = choking.acceleration_drop(
                flow, start, end, scene.ambient_pressure, self.exponent, coefficient
            )
            lost.update(time, loss.update(time, np.abs(along).sum(axis=1, keepdims=True)))
        share = min(lost.value / quantities.swing, 1.0)
        if fastest.value > choking.CHOKING_MACH and way > 0.0:
            message = self._too_fast(fastest).message
            return Missed(message, share * way, fastest.time_s, leaves_validity=True)
        reason = (
            f"at the computed flows it would cost {lost.value:.3g} Pa, {share:.2g} times the "
            "largest pressure"
        )
        return Missed(reason, share * way, lost.time_s)
