"""Pressure distribution: the fluid takes time to pass the tubes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System
from viscodesign.scene.bellows import snaps


@dataclass(frozen=True)
class PressureDistribution(Effect):
    """Viscous flow between nodes of different pressure; off: one pressure a network."""

    name: ClassVar[str] = "pressure_distribution"
    order: ClassVar[int] = 10
    formula: ClassVar[str] = "t_net / t_i"
    validity: ClassVar[str] = "Slow laminar flow of a Newtonian fluid in slender tubes."
    source: ClassVar[str] = "Hagen and Poiseuille; the paper, equation (1)."
    keys: ClassVar[tuple[str, ...]] = ("network", "fluid", "temperature")

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
            return "no tube joins anything"
        if snaps(quantities.scene.bellows):
            return "the measured curve snaps, and only flow tells how fast"
        if self.indispensable(quantities):
            return "two inlets feed one network, and only flow tells their pressures apart"
        scales = quantities.scales
        return (
            f"the network settles in {scales.t_net:.3g} s, the input swings in {scales.t_i:.3g} s"
        )

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(uniform=False)

    def join(self, system: System) -> None:
        for tube in system.graph.tubes:
            resistance = system.parameter(f"resistance.{tube.name}", self.resistances[tube.name])
            system.drop[tube.name] = resistance * system.flow[tube.name]
