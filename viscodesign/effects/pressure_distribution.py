"""Pressure distribution: the fluid takes time to pass the tubes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.effects.conditions import Conditions
from viscodesign.model.system import System


@dataclass(frozen=True)
class PressureDistribution(Effect):
    """Slow viscous flow between nodes of different pressure; off: one pressure a network."""

    name: ClassVar[str] = "pressure_distribution"
    order: ClassVar[int] = 10
    formula: ClassVar[str] = "t_net / t_i"

    resistances: dict[str, float]

    @classmethod
    def of(cls, conditions: Conditions) -> Self:
        return cls(conditions.resistances)

    def present(self, conditions: Conditions) -> bool:
        return bool(conditions.graph.tubes)

    def weight(self, conditions: Conditions) -> float:
        if any(len(c.inlets) > 1 for c in conditions.graph.components()):
            return float("inf")  # two sources in one network differ by flow alone
        return conditions.scales.ratios["tnet_over_ti"]

    def reason(self, conditions: Conditions) -> str:
        if not conditions.graph.tubes:
            return "no tube joins anything"
        scales = conditions.scales
        return (
            f"the network settles in {scales.t_net:.3g} s, the input swings in {scales.t_i:.3g} s"
        )

    def join(self, system: System) -> None:
        for tube in system.graph.tubes:
            resistance = system.parameter(f"resistance.{tube.name}", self.resistances[tube.name])
            drop = system.node_pressure(tube.start) - system.node_pressure(tube.end)
            system.flow[tube.name] = drop / resistance
