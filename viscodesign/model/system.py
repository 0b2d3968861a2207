"""The coupled model as sums that effects add to.

A system starts from what no scene can do without: elastic energy of the rod,
intrinsic strains by pressure, and a volume in every bellow. Each effect then adds
its term: an energy, a dissipation, a stored volume, a tube's flow. What nobody
added is absent: without kinetic energy the rod is algebraic, without any load it
is a row of arcs, without tube flows each connected network has one pressure.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.model.coupling import BellowLaw, pair_pressures
from viscodesign.model.graph import Graph
from viscodesign.model.rod import Body, ChainRod

SX = ca.SX


@dataclass(frozen=True)
class Source:
    """The pressure of one inlet: a smooth formula inside each interval of the run."""

    pressure: Callable[[SX, SX], SX]
    """(time, piece coefficients) -> pressure above the baseline [Pa]."""
    coefficients: int


class System:
    """Symbols and sums of one coupled model; `formulate` turns it into equations."""

    def __init__(
        self,
        graph: Graph,
        body: Body,
        bellow: BellowLaw,
        sources: Mapping[str, Source],
        baseline: float,
        edges_per_section: int,
    ) -> None:
        self._parameters: dict[str, tuple[SX, float]] = {}
        self.graph = graph
        self.body = body
        self.bellow = bellow
        self.time = SX.sym("time")
        self.load_factor = SX.sym("load_factor")
        self.pieces = SX.sym("pieces", sum(s.coefficients for s in sources.values()))
        self.baseline = self.parameter("gauge_pressure", baseline)
        self.rod = ChainRod(
            body,
            edges_per_section,
            self.parameter("bending_stiffness", body.bending_stiffness),
            self.parameter("extension_stiffness", body.extension_stiffness),
            self.parameter("section_length", body.section_length),
            self.parameter("mass_per_length", body.mass_per_length),
        )
        self.inlet_pressure = self._inlet_pressures(sources)
        self.pressure = {name: SX.sym(f"pressure_{name}") for name in graph.bellows_along_tubes()}
        self.junction_pressure = {name: SX.sym(f"pressure_{name}") for name in graph.junctions}
        # Resultants of each section, positive in tension and in bending to the right.
        self.normal_force = [SX.sym(f"normal_force_{j + 1}") for j in range(graph.sections)]
        self.moment = [SX.sym(f"moment_{j + 1}") for j in range(graph.sections)]

        # The sums that effects join.
        self.kinetic_energy = SX(0)
        self.load_potential = SX(0)
        self.tip_moment = SX(0)
        self.dissipation_power = SX(0)
        self.flow: dict[str, SX] = {}
        self.linear_volume, self.fluid_energy = self._linear_storage()
        self.volume = dict(self.linear_volume)
        self.intrinsic_curvature, self.intrinsic_stretch = self._linear_strains()

    def parameter(self, name: str, value: float) -> SX:
        """A named number of the scene as a symbol, so that one build serves many values."""
        symbol, _ = self._parameters.setdefault(name, (SX.sym(name), float(value)))
        return symbol

    def parameters(self) -> tuple[SX, np.ndarray]:
        """All parameters' symbols and values, in the order of their first use."""
        symbols = [symbol for symbol, _ in self._parameters.values()]
        values = np.array([value for _, value in self._parameters.values()])
        return ca.vertcat(*symbols), values

    def node_pressure(self, node: str) -> SX:
        """Gauge pressure of a node of the network, whatever its kind [Pa]."""
        for kind in (self.pressure, self.junction_pressure, self.inlet_pressure):
            if node in kind:
                return kind[node]
        raise KeyError(node)

    def net_inflows(self) -> dict[str, SX]:
        """Sum of the tube flows into every node that is not an inlet [m3/s]."""
        totals = {name: SX(0) for name in (*self.pressure, *self.junction_pressure)}
        for tube in self.graph.tubes:
            if tube.end in totals:
                totals[tube.end] += self.flow[tube.name]
            if tube.start in totals:
                totals[tube.start] -= self.flow[tube.name]
        return totals

    def _inlet_pressures(self, sources: Mapping[str, Source]) -> dict[str, SX]:
        pressures, used = {}, 0
        for name, source in sources.items():
            piece = self.pieces[used : used + source.coefficients]
            pressures[name] = self.baseline + source.pressure(self.time, piece)
            used += source.coefficients
        return pressures

    def _linear_storage(self) -> tuple[dict[str, SX], SX]:
        """Volume of every bellow, and the energy that they hold together [J]."""
        rest = self.parameter("rest_volume", self.bellow.rest_volume)
        compliance = self.parameter("compliance", self.bellow.compliance)
        volumes = {name: rest + compliance * p for name, p in self.pressure.items()}
        return volumes, compliance * ca.sumsqr(ca.vertcat(*self.pressure.values())) / 2

    def _linear_strains(self) -> tuple[list[SX], list[SX]]:
        k = self.parameter("curvature_per_pressure", self.bellow.curvature_per_pressure)
        z = self.parameter("stretch_per_pressure", self.bellow.stretch_per_pressure)
        pairs = pair_pressures(self.graph, self.pressure)
        return (
            [k * (left - right) for left, right in pairs],
            [z * (left + right) for left, right in pairs],
        )
