"""Pressure distribution: the fluid takes time to pass the tubes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Self

from viscodesign.effects.base import Effect, Trait
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System
from viscodesign.physics.timescales import LARGEST_TIME_RATIO
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.scene.bellows import snaps


@dataclass(frozen=True)
class PressureDistribution(Effect):
    """Viscous flow between nodes of different pressure; off: one pressure per network."""

    name: ClassVar[str] = "pressure_distribution"
    order: ClassVar[int] = 10
    formula: ClassVar[str] = "t_net / t_i"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.DISTRIBUTED_PRESSURE})
    validity: ClassVar[str] = "Slow laminar flow of a Newtonian fluid in slender tubes."
    source: ClassVar[str] = "Hagen and Poiseuille; the paper, equation (1)."
    references: ClassVar[tuple[LiteratureReference, ...]] = (PAPER,)
    keys: ClassVar[tuple[str, ...]] = (
        "network.layout",
        "network.tube_radius",
        "network.tube_length",
        "network.changes",
        "network.tubes",
        "network.feed_line",
        "fluid.viscosity",
        "temperature",
    )

    resistances: dict[str, float]

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls(quantities.resistances)

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(quantities.graph.tubes)

    def indispensable(self, quantities: SceneQuantities) -> bool:
        # Two sources in one network differ by flow alone.
        if snaps(quantities.scene.bellows):
            return True
        inputs = quantities.scene.inputs
        parts = quantities.graph.components()
        return any(sum(inputs[n].gives_pressure for n in part.inlets) > 1 for part in parts)

    def weight(self, quantities: SceneQuantities) -> float:
        return quantities.scales.ratios["tnet_over_ti"]

    def reason(self, quantities: SceneQuantities) -> str:
        if not quantities.graph.tubes:
            return "the network has no tubes"
        if snaps(quantities.scene.bellows):
            return "the measured curve snaps through, as fast as flow allows"
        if self.indispensable(quantities):
            return "several inlets feed one network; only flow lets their pressures differ"
        scales = quantities.scales
        return (
            f"the network settles in {scales.t_net:.3g} s, the input swings in {scales.t_i:.3g} s"
        )

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(distributed=True)

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        if not self.resistances:
            return
        duration, resistances = quantities.scene.run.duration, self.resistances.values()
        for resistance in (min(resistances), max(resistances)):
            time = resistance * quantities.bellow.compliance
            share = time / duration
            if not 1 / LARGEST_TIME_RATIO < share < LARGEST_TIME_RATIO:
                slow = "lower fluid.viscosity, or lengthen run.duration"
                fast = f"use effects.{self.name}: off"
                yield Fault(
                    f"a bellow fills in {time:.3g} s, {share:.2g} times run.duration: too far "
                    f"apart for double precision; {slow if share > 1 else fast}",
                    "fluid.viscosity",
                )
                return

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        for part in quantities.graph.components() if self.name not in active else ():
            inlets = [name for name in part.inlets if name not in quantities.barrels]
            if len(inlets) > 1:
                yield Fault(
                    "off gives every connected network one pressure, but the inlets "
                    f"{', '.join(inlets)} feed the same network. Use 'on' or 'auto', or separate "
                    "the inlets.",
                    f"effects.{self.name}",
                )

    def join(self, system: System) -> None:
        for tube in system.graph.tubes:
            resistance = system.parameter(f"resistance.{tube.name}", self.resistances[tube.name])
            system.drop[tube.name] = resistance * system.flow[tube.name]
