"""What the parts of a network hold: at rest, as filled, and what sealed parts must keep."""

from __future__ import annotations

import casadi as ca

from viscodesign.model.graph import Component
from viscodesign.model.system import System
from viscodesign.model.unknowns import column, substitute

SX = ca.SX


class FluidContent:
    """Amounts of fluid by node and by connected part, as formulas.

    A part that no pressure source feeds is sealed: it keeps what it was filled with.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self.storing = system.storing_nodes()
        self.components = tuple(system.graph.components())
        self.fed = tuple(c for c in self.components if self.pressure_inlets(c))
        self.driven = [name for c in self.fed for name in self.pressure_inlets(c)]
        self.sealed = tuple(c for c in self.components if c not in self.fed and self._nodes(c))
        self.sealed_volumes = SX.sym("sealed_volumes", len(self.sealed))

    def pressure_inlets(self, component: Component) -> list[str]:
        """Inlets of a component whose pressure is given."""
        return [name for name in component.inlets if name not in self.system.syringes]

    def _nodes(self, component: Component) -> list[str]:
        """Nodes of a component that store fluid."""
        own = set(component.nodes)
        return [n for n in (*self.system.pressure, *self.storing) if n in own]

    def first_node(self, component: Component) -> str:
        """The first of its nodes that store fluid."""
        return self._nodes(component)[0]

    def rest_amounts(self, nodes: list[str]) -> SX:
        """Contents of nodes at zero gauge, unloaded, with no plunger pushed [m3]."""
        return self._at_pressure(nodes, SX(0), SX(0))

    def filled_amounts(self, nodes: list[str]) -> SX:
        """Contents of nodes at the baseline, unloaded, with no plunger pushed [m3]."""
        return self._at_pressure(nodes, self.system.baseline, self.system.filled_swelling)

    def filled(self) -> SX:
        """Amount with which every sealed part was filled: its content at the baseline [m3]."""
        return column([ca.sum1(self.filled_amounts(self._nodes(c))) for c in self.sealed])

    def departures(self) -> SX:
        """Contents of bellows and storing nodes beyond rest, from pressures [m3]."""
        nodes = [*self.system.pressure, *self.storing]
        return column([self.system.stored(name) for name in nodes]) - self.rest_amounts(nodes)

    def _at_pressure(self, nodes: list[str], pressure: SX, swelling: SX) -> SX:
        system = self.system
        syringes = system.syringes.values()
        pressures = [
            *system.pressure.values(),
            *system.junction_pressure.values(),
            *(syringe.pressure for syringe in syringes),
        ]
        zero = [*system.normal_force, *system.moment, *(syringe.pushed for syringe in syringes)]
        pairs = [(symbol, pressure) for symbol in pressures] + [(s, SX(0)) for s in zero]
        count = len(system.swelling)
        filled = ca.vertsplit(ca.repmat(swelling, count // swelling.numel(), 1)) if count else []
        pairs += list(zip(system.swelling.values(), filled, strict=True))
        stored = column([system.stored(name) for name in nodes])
        return substitute([stored], pairs)[0]

    def sealed_residuals(self, volume_size: SX) -> list[SX]:
        """Content of every sealed part minus what it was filled with, by node's size."""
        return [
            (sum((self.system.stored(n) for n in self._nodes(c)), SX(0)) - self.sealed_volumes[k])
            / (volume_size * len(self._nodes(c)))
            for k, c in enumerate(self.sealed)
        ]
