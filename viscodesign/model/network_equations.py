"""The network's part of the equations: contents of its nodes, and flows through its tubes."""

from __future__ import annotations

from enum import Enum

import casadi as ca

from viscodesign.errors import SpecError
from viscodesign.model.fluid_content import FluidContent
from viscodesign.model.system import System
from viscodesign.model.tube_flows import TubeFlows
from viscodesign.model.unknowns import SizeSymbols, SymbolicUnknowns, Traits, column

SX = ca.SX

BELLOW_AMOUNTS, BELLOW_PRESSURES = "volume", "pressure"
"""Blocks of which one row each belongs to a bellow, in the same order."""
AMOUNT, PRESSURE = Traits(is_amount=True), Traits(is_pressure=True)
MULTIVALUED, INTEGRAL = Traits(is_multivalued=True), Traits(is_integral=True)


class NetworkForm(Enum):
    """How the network enters the equations."""

    DISTRIBUTED = "a pressure in every bellow"
    UNIFORM = "one pressure per connected network"


class NetworkEquations:
    """Unknowns, balances and outputs of the network."""

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.sizes = sizes
        self.form = NetworkForm.DISTRIBUTED if system.drop else NetworkForm.UNIFORM
        self.content = FluidContent(system)
        self.storing = self.content.storing
        bare = [name for name in system.junction_pressure if name not in self.storing]
        self.flows = TubeFlows(system, sizes, bare)
        self._shared: list[tuple[SX, SX]] = []

    # -- unknowns -------------------------------------------------------------

    def name_unknowns(
        self, states: SymbolicUnknowns, algebraics: SymbolicUnknowns, statics: SymbolicUnknowns
    ) -> None:
        """Add the network's unknowns to their vectors."""
        if self.form is NetworkForm.UNIFORM:
            self._share_pressures(algebraics, statics)
            return
        system, volume, flows = self.system, self.volume_size(), self.flows
        self.amounts = SX.sym("amount", len(system.pressure))
        self.node_amounts = SX.sym("node_amount", len(self.storing))
        self.inflows = SX.sym("inflow", len(self.content.driven))
        states.add(BELLOW_AMOUNTS, self.amounts, volume, AMOUNT)
        states.add("node_volume", self.node_amounts, volume, AMOUNT)
        states.add("inflow", self.inflows, volume * len(system.pressure), INTEGRAL)
        inertial = flows.independent(flows.inertial)
        implicit = flows.independent(flows.implicit)
        states.add("flow", flows.symbols(inertial), flows.flow_sizes(inertial))
        for unknowns in (algebraics, statics):
            swellings = column(list(system.swelling.values()))
            unknowns.add("swelling", swellings, volume, MULTIVALUED)
            self._add_pressures(unknowns)
        algebraics.add("flow", flows.symbols(implicit), flows.untested_sizes(implicit))
        every = [*inertial, *implicit]
        statics.add("flow", flows.symbols(every), flows.flow_sizes(every))

    def _add_pressures(self, unknowns: SymbolicUnknowns) -> None:
        system = self.system
        for name, symbols in (
            (BELLOW_PRESSURES, list(system.pressure.values())),
            ("junction_pressure", list(system.junction_pressure.values())),
            ("syringe_pressure", [syringe.pressure for syringe in system.syringes.values()]),
        ):
            unknowns.add(name, column(symbols), self.sizes.pressure, PRESSURE)

    def volume_size(self) -> SX:
        compliance = self.system.parameter("compliance", self.system.bellow.compliance)
        return compliance * self.sizes.pressure

    def energy_size(self) -> SX:
        """Energy that a bellow takes up at the size of pressure [J]."""
        return self.volume_size() * self.sizes.pressure

    def _share_pressures(self, algebraics: SymbolicUnknowns, statics: SymbolicUnknowns) -> None:
        """Give every connected network one pressure: its inlet's, or an unknown."""
        system, content = self.system, self.content
        if system.swelling:
            raise SpecError.plain("a bellow cannot snap in a network of one pressure")
        shared = SX.sym("network_pressure", len(content.sealed))
        for unknowns in (algebraics, statics):
            unknowns.add("network_pressure", shared, self.sizes.pressure, PRESSURE)
        for component in content.components:
            inlets = content.pressure_inlets(component)
            if len(inlets) > 1:
                raise SpecError.plain(
                    f"the inlets {', '.join(inlets)} feed one network of uniform pressure"
                )
            if inlets:
                value = system.inlet_pressure[inlets[0]]
            elif component in content.sealed:
                value = shared[content.sealed.index(component)]
            else:
                continue
            for node in component.nodes:
                if node not in inlets:
                    head = system.load_factor * system.head(node)
                    self._shared.append((system.node_pressure(node), value + head))

    def substitutions(self) -> list[list[tuple[SX, SX]]]:
        """Substitutions for symbols that come before those of the unknowns, in this order."""
        system = self.system
        amounts = [(symbol, system.stored(name)) for name, symbol in system.amount.items()]
        pushed = [(syringe.pushed, syringe.pushed_value) for syringe in system.syringes.values()]
        dependent = [(system.flow[name], value) for name, value in self.flows.dependent.items()]
        return [self.flows.formulas(), amounts, self._shared, pushed, dependent]

    # -- balances -------------------------------------------------------------

    def dynamics(self) -> tuple[list[SX], list[SX]]:
        """Rates of the scaled states and scaled algebraic residuals, not yet resolved."""
        size = self.volume_size()
        if self.form is NetworkForm.UNIFORM:
            return [], self.content.sealed_residuals(size)
        inflow, flows, driven = self.system.net_inflow, self.flows, self.content.driven
        ode = [column([inflow[name] for name in (*self.system.pressure, *self.storing)]) / size]
        if self.content.fed:
            # States, not quadratures: only then do the same linear formulas apply to them
            # and the volumes, and the balance holds to round-off.
            delivered = column([-inflow[name] for name in driven])
            ode.append(delivered / (size * len(self.system.pressure)))
        rates, inertial = flows.accelerations(), flows.independent(flows.inertial)
        ode.append(column([rates[t.name] for t in inertial]) / flows.flow_sizes(inertial))
        # The state is the amount beyond that at rest: small departures keep their digits.
        held = ca.vertcat(self.amounts, self.node_amounts)
        kept = (held - self.content.departures()) / size
        # In the order of the unknowns: each row has its own on the diagonal.
        count = len(self.system.pressure)
        others = flows.junction_residuals(rates)
        others |= dict(zip(self.storing, ca.vertsplit(kept[count:]), strict=True))
        nodes = [others[n] for n in (*self.system.junction_pressure, *self.system.syringes)]
        drops = flows.drop_residuals(flows.independent(flows.implicit))
        return ode, [kept[:count], self._swelling_residuals(), *nodes, *drops]

    def _swelling_residuals(self) -> SX:
        """Pressure of a bellow's swelling minus its own, over the size of pressure."""
        return self.system.swelling_defects() / self.sizes.pressure

    def equilibrium(self) -> list[SX]:
        """Residuals of the steady state in the static unknowns, not yet resolved."""
        if self.form is NetworkForm.UNIFORM:
            return self.content.sealed_residuals(self.volume_size())
        flows = self.flows
        return [
            self._swelling_residuals(),
            *self._steady_flows(list(self.system.pressure)),
            *self._junction_residuals(),
            *self._steady_flows(list(self.system.syringes)),
            *flows.drop_residuals([*flows.inertial, *flows.implicit]),
        ]

    def _junction_residuals(self) -> list[SX]:
        """Junctions in their order, without those whose flows keep the balance."""
        flows = self.flows
        found = flows.junction_balances()
        storing = [name for name in self.system.junction_pressure if name in self.storing]
        found |= dict(zip(storing, self._steady_flows(storing), strict=True))
        return [found[name] for name in self.system.junction_pressure if name in found]

    def _steady_flows(self, nodes: list[str]) -> list[SX]:
        """No net flow anywhere; in a sealed part the first node's row is its content."""
        content = self.content
        first = (content.first_node(c) for c in content.sealed)
        sealed = dict(zip(first, content.sealed_residuals(self.volume_size()), strict=True))
        return [sealed[n] if n in sealed else self.flows.steady_residual(n) for n in nodes]

    # -- results --------------------------------------------------------------

    def rates(self) -> dict[str, SX]:
        """Powers whose integrals the balances need [W]."""
        system = self.system
        if self.form is NetworkForm.UNIFORM:
            return {}
        driven = [n for n in system.inlet_pressure if n not in system.syringes]
        pump = sum((-system.net_inflow[n] * system.specific_work(n) for n in driven), SX(0))
        tubes = sum(
            (
                system.flow[t.name] * (system.specific_work(t.start) - system.specific_work(t.end))
                for t in system.graph.tubes
            ),
            SX(0),
        )
        return {"pump": pump, "tube_loss": tubes}

    def works(self) -> list[str]:
        """Names of the works of forces along paths.

        Where pressures differ, the flows give the pump's; with one pressure for all it is
        the work of the fluid's pressure on what is stored.
        """
        others = ["plunger", "coupling", "carried"]
        return others if self.form is NetworkForm.DISTRIBUTED else ["pump", *others]

    def _held(self, nodes: list[str]) -> SX:
        """Contents of nodes [m3]: states, where there are any."""
        if self.form is NetworkForm.UNIFORM:
            return column([self.system.stored(n) for n in nodes])
        return self.content.rest_amounts(nodes) + ca.vertcat(self.amounts, self.node_amounts)

    def outputs(self, conjugate: SX) -> dict[str, SX]:
        """Quantities of a motion; ``conjugate`` volumes of the rod's resultants (B,)."""
        system = self.system
        names = list(system.pressure)
        volume = column([system.volume(n) for n in names])
        wall = column([system.wall_volume(n) for n in names])
        tubes = column([system.tube_volume.get(n, SX(0)) for n in names])
        distributed = self.form is NetworkForm.DISTRIBUTED
        nodes = [*names, *self.storing]
        return {
            "pressure": column(list(system.pressure.values())),
            "volume": volume - tubes,
            "tube_volume": tubes,
            "stored": self._held(nodes),
            "specific_work": column([system.specific_work(n) for n in nodes]),
            "flow": column(list(system.flow.values())) if distributed else SX(0, 1),
            "inlet_pressure": column(list(system.inlet_pressure.values())),
            "junction_pressure": column(list(system.junction_pressure.values())),
            "unpaired_volume": volume - wall - conjugate,
            "fluid_energy": system.fluid_energy(),
            "carried_energy": column([system.carried_energy(n) for n in nodes]),
            "pushed": column([syringe.pushed for syringe in system.syringes.values()]),
            "plunger_pressure": column(system.plunger_pressures()),
        }
