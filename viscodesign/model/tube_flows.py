"""Flows through the tubes of a network: which are unknowns, and the equations that they obey."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.model.graph import Tube
from viscodesign.model.system import System
from viscodesign.model.unknowns import SizeSymbols, column, substitute

SX = ca.SX

UNTESTED_SIZE_FACTOR = 1e6
"""Factor to the size of an unknown by which no error of it counts."""


class TubeFlows:
    """Flows as formulas, algebraic unknowns or states.

    A tube whose pressure drop is proportional to its flow needs no unknown: its flow is a
    formula. Any other drop makes the flow an algebraic unknown, inertance a state. So is the
    flow through a tube of very low resistance an unknown: it then follows from what the bellows
    take up, where a formula would turn every error of the pressures into a flow.
    """

    def __init__(self, system: System, sizes: SizeSymbols, bare: Sequence[str]) -> None:
        """``bare``: junctions that store nothing; without pressure drops there are no flows."""
        self.system = system
        self.sizes = sizes
        self.bare = bare
        tubes = system.graph.tubes if system.drop else ()
        curved = self._measure_drops(tubes)
        self.inertial = [t for t in tubes if t.name in system.inertance]
        implicit = (curved | system.wide) - set(system.inertance)
        self.implicit = [t for t in tubes if t.name in implicit]
        self._unknown = {t.name for t in (*self.inertial, *self.implicit)}
        self.explicit = [t for t in tubes if t.name not in self._unknown]
        self.dependent = self._dependent_flows()

    def _measure_drops(self, tubes: Sequence[Tube]) -> set[str]:
        """Find every tube's drop per flow at zero flow; names of those that are nonlinear."""
        flows = column([self.system.flow[t.name] for t in tubes])
        drops = column([self.system.drop[t.name] for t in tubes])
        slopes = ca.diag(ca.jacobian(drops, flows)) if tubes else SX(0, 1)
        at_rest = substitute([slopes], [(flows, SX.zeros(flows.shape))])[0]
        names = [t.name for t in tubes]
        self._slope = dict(zip(names, ca.vertsplit(at_rest) if tubes else [], strict=True))
        curved = ca.which_depends(drops, flows, 2, True) if tubes else []
        return {name for name, is_curved in zip(names, curved, strict=True) if is_curved}

    def _dependent_flows(self) -> dict[str, SX]:
        """Flows that follow from others, since a bare junction stores nothing.

        One for each junction whose tubes' flows are all unknowns; eliminated from the
        unknowns, they keep the balance there to the last digit.
        """
        tubes = [*self.inertial, *self.implicit]
        rows = [n for n in self.bare if self.balances_itself(n)]
        matrix = np.array([[_sign(t, n) for t in tubes] for n in rows])
        pivots = reduce_incidence(matrix)
        flows = [self.system.flow[t.name] for t in tubes]
        return {
            tubes[pivot].name: -sum(
                (float(matrix[k, j]) * flows[j] for j in np.flatnonzero(matrix[k]) if j != pivot),
                SX(0),
            )
            for k, pivot in enumerate(pivots)
        }

    def balances_itself(self, junction: str) -> bool:
        """Whether a dependent flow keeps a junction's balance."""
        return all(t.name in self._unknown for t in self.system.graph.tubes_at[junction])

    # -- unknowns -------------------------------------------------------------

    def independent(self, tubes: list[Tube]) -> list[Tube]:
        """Those whose flow does not follow from others."""
        return [t for t in tubes if t.name not in self.dependent]

    def symbols(self, tubes: list[Tube]) -> SX:
        """Flows of some tubes as a column [m3/s]."""
        return column([self.system.flow[t.name] for t in tubes])

    def flow_sizes(self, tubes: list[Tube]) -> SX:
        """Flow driven by the size of pressure, or taken by all bellows in one swing, by tube."""
        compliance = self.system.parameter("compliance", self.system.bellow.compliance)
        filling = self.sizes.swing / (compliance * len(self.system.pressure))
        return self.sizes.pressure / (column([self._slope[t.name] for t in tubes]) + filling)

    def untested_sizes(self, tubes: list[Tube]) -> SX:
        """The same; larger for tubes of very low resistance.

        Their flows are nearly the rates of pressures that the inlets impose. No step is
        small enough for the error estimate of such an unknown: it must be left out of it.
        """
        wide = self.system.wide
        factors = [UNTESTED_SIZE_FACTOR if t.name in wide else 1.0 for t in tubes]
        return self.flow_sizes(tubes) * ca.DM(factors)

    def formulas(self) -> list[tuple[SX, SX]]:
        """Flows that are formulas of the pressures."""
        system = self.system
        return [
            (system.flow[t.name], system.driving_pressure(t.start, t.end) / self._slope[t.name])
            for t in self.explicit
        ]

    # -- equations ------------------------------------------------------------

    def accelerations(self) -> dict[str, SX]:
        """Rate of change of the flow in every tube with inertance [m3/s2]."""
        return {
            t.name: self._unbalanced_pressure(t) / self.system.inertance[t.name]
            for t in self.inertial
        }

    def drop_residuals(self, tubes: list[Tube]) -> list[SX]:
        """Driving pressure of a tube minus its pressure drop, over the size of pressure."""
        return [self._unbalanced_pressure(t) / self.sizes.pressure for t in tubes]

    def _unbalanced_pressure(self, tube: Tube) -> SX:
        driving = self.system.driving_pressure(tube.start, tube.end)
        return driving - self.system.drop[tube.name]

    def junction_balances(self) -> dict[str, SX]:
        """Net flows into junctions that store nothing, over the flow of their own tubes.

        Without those where dependent flows keep the balance.
        """
        pressure, balances = self.sizes.pressure, {}
        for name in self.bare:
            if not self.balances_itself(name):
                tubes = self.system.graph.tubes_at[name]
                scale = sum((pressure / self._slope[t.name] for t in tubes), SX(0))
                balances[name] = self.system.net_inflow[name] / scale
        return balances

    def junction_residuals(self, accelerations: dict[str, SX]) -> dict[str, SX]:
        """An equation of the pressure of every junction that stores nothing.

        Where the flows keep the balance by themselves, their ``accelerations`` must keep it
        too, or, without inertance, it is the pressure drop of one of the junction's tubes.
        """
        residuals = self.junction_balances()
        for name, tube in self._tubes_of_junctions().items():
            if tube.name not in accelerations:
                (residuals[name],) = self.drop_residuals([tube])
                continue
            tubes = self.system.graph.tubes_at[name]
            scale = sum((self.sizes.pressure / self.system.inertance[t.name] for t in tubes), SX(0))
            total = sum((_sign(t, name) * accelerations[t.name] for t in tubes), SX(0))
            residuals[name] = total / scale
        return residuals

    def _tubes_of_junctions(self) -> dict[str, Tube]:
        """For every junction that balances itself, one of its tubes, whose flow is dependent.

        Each has another one: tubes of dependent flow form trees that end at other nodes.
        """
        tubes_at, found = self.system.graph.tubes_at, {}
        left = {
            name: {t.name: t for t in tubes_at[name] if t.name in self.dependent}
            for name in self.bare
            if self.balances_itself(name)
        }
        while left:
            leaf = next(name for name, own in left.items() if len(own) == 1)
            (found[leaf],) = left.pop(leaf).values()
            for own in left.values():
                own.pop(found[leaf].name, None)
        return found

    def steady_residual(self, node: str) -> SX:
        """Net flow into a node, over the flow of its own tubes."""
        tubes = self.system.graph.tubes_at[node]
        conductance = sum((1 / self._slope[t.name] for t in tubes), SX(0))
        return self.system.net_inflow[node] / (conductance * self.sizes.pressure)


def _sign(tube: Tube, node: str) -> float:
    """Whether a tube's flow enters a node (1), leaves it (-1), or neither (0)."""
    return float(tube.end == node) - float(tube.start == node)


def reduce_incidence(matrix: np.ndarray) -> list[int]:
    """Bring an incidence matrix (rows, columns) to reduced echelon form; its pivots' columns.

    Entries stay 0 and +-1: the matrix of a graph is totally unimodular.
    """
    pivots: list[int] = []
    for k in range(len(matrix)):
        pivot = int(np.flatnonzero(matrix[k])[0])
        matrix[k] /= matrix[k, pivot]
        for other in range(len(matrix)):
            if other != k:
                matrix[other] -= matrix[other, pivot] * matrix[k]
        pivots.append(pivot)
    return pivots
