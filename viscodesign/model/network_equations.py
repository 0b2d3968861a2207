"""The network's part of the equations: what its nodes hold, and what its tubes let through."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

import casadi as ca
import numpy as np

from viscodesign.errors import SpecError
from viscodesign.model.graph import Component, Tube
from viscodesign.model.system import System
from viscodesign.model.unknowns import SizeSymbols, Traits, Unknowns, column, substitute

SX = ca.SX


BELLOW_AMOUNTS, BELLOW_PRESSURES = "volume", "pressure"
"""Blocks of which one row each belongs to a bellow, in the same order."""
AMOUNT, PRESSURE = Traits(is_amount=True), Traits(is_pressure=True)
MULTIVALUED = Traits(is_multivalued=True)
UNTESTED = 1e6
"""Factor to the size of an unknown by which no error of it counts."""
SNAPS_AT_ONCE = (
    "bellows.curve: between some of its rows the pressure falls as the bellow swells; it snaps "
    "there, as fast as the tubes let it. Let effects.pressure_distribution be on or auto."
)


def two_pressures(inlets: Sequence[str]) -> SpecError:
    """The refusal of one pressure in a network that several inlets feed."""
    return SpecError.plain(
        f"effects.pressure_distribution: off gives every connected network one pressure, but the "
        f"inlets {', '.join(inlets)} feed the same network. Use 'on' or 'auto', or separate the "
        "inlets."
    )


class NetworkForm(Enum):
    """How the network enters the equations."""

    DISTRIBUTED = "a pressure in every bellow"
    UNIFORM = "one pressure per connected network"


class NetworkEquations:
    """Unknowns, balances and outputs of the network.

    A tube whose loss is proportional to its flow needs no unknown: its flow is a
    formula. Any other loss makes the flow an algebraic unknown, inertance a state. So is the
    flow through a tube that hardly resists: it follows from what the bellows take, then, where
    a formula would make a flow of every error of the pressures.
    """

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.sizes = sizes
        self.form = NetworkForm.DISTRIBUTED if system.drop else NetworkForm.UNIFORM
        self.storing = system.storing_nodes()
        self.bare = [name for name in system.junction_pressure if name not in self.storing]
        self.components = tuple(system.graph.components())
        self.fed = tuple(c for c in self.components if self._pressure_inlets(c))
        self.driven = [name for c in self.fed for name in self._pressure_inlets(c)]
        self.sealed = tuple(c for c in self.components if c not in self.fed and self._nodes(c))
        self.sealed_volumes = SX.sym("sealed_volumes", len(self.sealed))
        tubes = system.graph.tubes if self.form is NetworkForm.DISTRIBUTED else ()
        curved = self._measure_losses(tubes)
        self.inertial = [t for t in tubes if t.name in system.inertance]
        implicit = (curved | system.wide) - set(system.inertance)
        self.implicit = [t for t in tubes if t.name in implicit]
        self._unknown = {t.name for t in (*self.inertial, *self.implicit)}
        self.explicit = [t for t in tubes if t.name not in self._unknown]
        self.dependent = self._dependent_flows()
        self._shared: list[tuple[SX, SX]] = []

    def _pressure_inlets(self, component: Component) -> list[str]:
        return [name for name in component.inlets if name not in self.system.syringes]

    def _nodes(self, component: Component) -> list[str]:
        """Nodes of a component that hold fluid."""
        own = set(component.nodes)
        return [n for n in (*self.system.pressure, *self.storing) if n in own]

    def _measure_losses(self, tubes: Sequence[Tube]) -> set[str]:
        """Learn every tube's loss per flow at no flow; names of those that are no straight line."""
        flows = column([self.system.flow[t.name] for t in tubes])
        losses = column([self.system.drop[t.name] for t in tubes])
        slopes = ca.diag(ca.jacobian(losses, flows)) if tubes else SX(0, 1)
        still = substitute([slopes], [(flows, SX.zeros(flows.shape))])[0]
        names = [t.name for t in tubes]
        self._slope = dict(zip(names, ca.vertsplit(still) if tubes else [], strict=True))
        curved = ca.which_depends(losses, flows, 2, True) if tubes else []
        return {name for name, is_curved in zip(names, curved, strict=True) if is_curved}

    def _dependent_flows(self) -> dict[str, SX]:
        """Flows that follow from others, since a bare junction holds nothing.

        One for each junction whose tubes all have flows of their own; taken out of the
        unknowns they keep the balance there to the last digit.
        """
        tubes = [*self.inertial, *self.implicit]
        rows = [n for n in self.bare if self._balances_itself(n)]
        matrix = np.array([[_sign(t, n) for t in tubes] for n in rows])
        pivots = _reduce(matrix)
        flows = [self.system.flow[t.name] for t in tubes]
        return {
            tubes[pivot].name: -sum(
                (float(matrix[k, j]) * flows[j] for j in np.flatnonzero(matrix[k]) if j != pivot),
                SX(0),
            )
            for k, pivot in enumerate(pivots)
        }

    def _free(self, tubes: list[Tube]) -> list[Tube]:
        """Those whose flow does not follow from others."""
        return [t for t in tubes if t.name not in self.dependent]

    # -- unknowns -------------------------------------------------------------

    def name_unknowns(self, states: Unknowns, algebraics: Unknowns, statics: Unknowns) -> None:
        """Add the network's unknowns to their vectors."""
        size = self.sizes.pressure
        if self.form is NetworkForm.UNIFORM:
            self._share_pressures(algebraics, statics)
            return
        system, volume = self.system, self._volume_size()
        self.amounts = SX.sym("amount", len(system.pressure))
        self.node_amounts = SX.sym("node_amount", len(self.storing))
        self.inflows = SX.sym("inflow", len(self.driven))
        states.add(BELLOW_AMOUNTS, self.amounts, volume, AMOUNT)
        states.add("node_volume", self.node_amounts, volume, AMOUNT)
        states.add("inflow", self.inflows, volume * len(system.pressure))
        inertial, implicit = self._free(self.inertial), self._free(self.implicit)
        states.add("flow", self._flows(inertial), self._flow_sizes(inertial))
        for unknowns in (algebraics, statics):
            unknowns.add("swelling", column(list(system.swelling.values())), volume, MULTIVALUED)
            for name, symbols in (
                (BELLOW_PRESSURES, list(system.pressure.values())),
                ("junction_pressure", list(system.junction_pressure.values())),
                ("syringe_pressure", self._syringe_pressures()),
            ):
                unknowns.add(name, column(symbols), size, PRESSURE)
        algebraics.add("flow", self._flows(implicit), self._untested_sizes(implicit))
        free = [*inertial, *implicit]
        statics.add("flow", self._flows(free), self._flow_sizes(free))

    def _syringe_pressures(self) -> list[SX]:
        return [self.system.inlet_pressure[name] for name in self.system.syringes]

    def _flows(self, tubes: list[Tube]) -> SX:
        return column([self.system.flow[t.name] for t in tubes])

    @property
    def _compliance(self) -> SX:
        return self.system.parameter("compliance", self.system.bellow.compliance)

    def _volume_size(self) -> SX:
        return self._compliance * self.sizes.pressure

    def _flow_sizes(self, tubes: list[Tube]) -> SX:
        """Flow that the pressure drives, or that all bellows take in one swing, by tube."""
        filling = self.sizes.swing / (self._compliance * len(self.system.pressure))
        return self.sizes.pressure / (column([self._slope[t.name] for t in tubes]) + filling)

    def _untested_sizes(self, tubes: list[Tube]) -> SX:
        """The same; larger for tubes that hardly resist.

        Their flows are all but the rates of pressures that the inlets impose. No step is
        small enough for the error estimate of such an unknown: it must be left out of it.
        """
        factors = [UNTESTED if t.name in self.system.wide else 1.0 for t in tubes]
        return self._flow_sizes(tubes) * ca.DM(factors)

    def energy_size(self) -> SX:
        """What a bellow takes up at the size of pressure [J]."""
        return self._volume_size() * self.sizes.pressure

    def _share_pressures(self, algebraics: Unknowns, statics: Unknowns) -> None:
        """Give every connected network one pressure: its inlet's, or an unknown."""
        system = self.system
        if system.swelling:
            raise SpecError.plain(SNAPS_AT_ONCE)
        shared = SX.sym("network_pressure", len(self.sealed))
        for unknowns in (algebraics, statics):
            unknowns.add("network_pressure", shared, self.sizes.pressure, PRESSURE)
        for component in self.components:
            inlets = self._pressure_inlets(component)
            if len(inlets) > 1:
                raise two_pressures(inlets)
            if inlets:
                value = system.inlet_pressure[inlets[0]]
            elif component in self.sealed:
                value = shared[self.sealed.index(component)]
            else:
                continue
            for node in component.nodes:
                if node not in inlets:
                    head = system.load_factor * system.head(node)
                    self._shared.append((system.node_pressure(node), value + head))

    def substitutions(self) -> list[list[tuple[SX, SX]]]:
        """What replaces symbols before the unknowns do, in this order."""
        system = self.system
        explicit = [
            (system.flow[t.name], system.driving_pressure(t.start, t.end) / self._slope[t.name])
            for t in self.explicit
        ]
        amounts = [(symbol, system.stored(name)) for name, symbol in system.amount.items()]
        pushed = [(system.pushed[name], value) for name, value in system.pushed_value.items()]
        dependent = [(system.flow[name], value) for name, value in self.dependent.items()]
        return [explicit, amounts, self._shared, pushed, dependent]

    # -- amounts --------------------------------------------------------------

    def rest_amounts(self, nodes: list[str]) -> SX:
        """What nodes hold at zero gauge, with nothing loading and nothing pushed [m3]."""
        return self._content(nodes, SX(0), SX(0))

    def _content(self, nodes: list[str], pressure: SX, swelling: SX) -> SX:
        system = self.system
        pressures = [
            *system.pressure.values(),
            *system.junction_pressure.values(),
            *self._syringe_pressures(),
        ]
        others = [*system.normal_force, *system.moment, *system.pushed.values()]
        pairs = [(symbol, pressure) for symbol in pressures] + [(s, SX(0)) for s in others]
        pairs += [(symbol, swelling) for symbol in system.swelling.values()]
        stored = column([system.stored(name) for name in nodes])
        return substitute([stored], pairs)[0]

    def filled(self) -> SX:
        """What every sealed part was filled with: its content at the baseline [m3]."""
        return column([ca.sum1(self.filled_amounts(self._nodes(c))) for c in self.sealed])

    def filled_amounts(self, nodes: list[str]) -> SX:
        """What nodes hold at the baseline, with nothing loading and nothing pushed [m3]."""
        return self._content(nodes, self.system.baseline, self.system.filled_swelling)

    def departures(self) -> SX:
        """What bellows and storing nodes hold beyond rest, from pressures [m3]."""
        nodes = [*self.system.pressure, *self.storing]
        return column([self.system.stored(name) for name in nodes]) - self.rest_amounts(nodes)

    def _held(self, nodes: list[str]) -> SX:
        """What nodes hold [m3]: states, where there are any."""
        if self.form is NetworkForm.UNIFORM:
            return column([self.system.stored(n) for n in nodes])
        return self.rest_amounts(nodes) + ca.vertcat(self.amounts, self.node_amounts)

    # -- balances -------------------------------------------------------------

    def dynamics(self) -> tuple[list[SX], list[SX]]:
        """Rates of the scaled states and scaled algebraic defects, not yet resolved."""
        if self.form is NetworkForm.UNIFORM:
            return [], self._sealed_defects()
        inflow, size = self.system.net_inflow, self._volume_size()
        ode = [
            column([inflow[name] for name in (*self.system.pressure, *self.storing)]) / size,
        ]
        if self.fed:
            # States, not quadratures: only then do the same linear formulas carry
            # them and the volumes, and the balance holds to round-off.
            given = column([-inflow[name] for name in self.driven])
            ode.append(given / (size * len(self.system.pressure)))
        rates, inertial = self._flow_rates(), self._free(self.inertial)
        ode.append(column([rates[t.name] for t in inertial]) / self._flow_sizes(inertial))
        # The state is the amount beyond that at rest: small departures keep their digits.
        held = ca.vertcat(self.amounts, self.node_amounts)
        kept = (held - self.departures()) / size
        # In the order of the unknowns: each line has its own on the diagonal.
        count = len(self.system.pressure)
        alg = [kept[:count], self._swelling_lines(), kept[count:]]
        return ode, [*alg, *self._junction_balances(rates), *self._loss_defects(self.implicit)]

    def _swelling_lines(self) -> SX:
        """What a bellow's swelling asks for less its pressure, over the size of pressure."""
        return self.system.swelling_defects() / self.sizes.pressure

    def _flow_rates(self) -> dict[str, SX]:
        """Acceleration of the flow in every tube with inertance [m3/s2]."""
        system = self.system
        return {
            t.name: (system.driving_pressure(t.start, t.end) - system.drop[t.name])
            / system.inertance[t.name]
            for t in self.inertial
        }

    def _loss_defects(self, tubes: list[Tube]) -> list[SX]:
        """What drives a tube less what it loses, over the size of pressure."""
        system = self.system
        return [
            (system.driving_pressure(t.start, t.end) - system.drop[t.name]) / self.sizes.pressure
            for t in tubes
        ]

    def _junction_balances(self, rates: dict[str, SX]) -> list[SX]:
        """What must vanish at junctions that hold nothing, over the flow of their own tubes.

        Where the flows keep the balance by themselves, their accelerations must keep it
        too (``rates``), or, without inertance, the losses of the tubes say all.
        """
        balances = []
        for name in self.bare:
            tubes = self.system.graph.tubes_at[name]
            if not self._balances_itself(name):
                scale = sum((self.sizes.pressure / self._slope[t.name] for t in tubes), SX(0))
                balances.append(self.system.net_inflow[name] / scale)
            elif all(t.name in rates for t in tubes):
                inertances = (self.system.inertance[t.name] for t in tubes)
                scale = sum((self.sizes.pressure / inertance for inertance in inertances), SX(0))
                total = sum((_sign(t, name) * rates[t.name] for t in tubes), SX(0))
                balances.append(total / scale)
        return balances

    def _balances_itself(self, junction: str) -> bool:
        """Whether a dependent flow keeps a junction's balance."""
        return all(t.name in self._unknown for t in self.system.graph.tubes_at[junction])

    def _sealed_defects(self) -> list[SX]:
        """What a sealed part holds less what it was filled with."""
        return [
            (sum((self.system.stored(n) for n in self._nodes(c)), SX(0)) - self.sealed_volumes[k])
            / (self._volume_size() * len(self._nodes(c)))
            for k, c in enumerate(self.sealed)
        ]

    def equilibrium(self) -> list[SX]:
        """Defects of the steady state in the static unknowns, not yet resolved."""
        if self.form is NetworkForm.UNIFORM:
            return self._sealed_defects()
        return [
            self._swelling_lines(),
            *self._steady_flows(list(self.system.pressure)),
            *self._junction_lines(),
            *self._steady_flows(list(self.system.syringes)),
            *self._loss_defects([*self.inertial, *self.implicit]),
        ]

    def _junction_lines(self) -> list[SX]:
        """Junctions in their order, those left out whose flows keep the balance."""
        bare = [name for name in self.bare if not self._balances_itself(name)]
        lines = dict(zip(bare, self._junction_balances({}), strict=True))
        storing = [name for name in self.system.junction_pressure if name in self.storing]
        lines |= dict(zip(storing, self._steady_flows(storing), strict=True))
        return [lines[name] for name in self.system.junction_pressure if name in lines]

    def _steady_flows(self, nodes: list[str]) -> list[SX]:
        """No net flow anywhere; in a sealed part the first node's line is its content."""
        first = (self._nodes(c)[0] for c in self.sealed)
        sealed = dict(zip(first, self._sealed_defects(), strict=True))
        lines = []
        for name in nodes:
            if name in sealed:
                lines.append(sealed[name])
                continue
            tubes = self.system.graph.tubes_at[name]
            conductance = sum((1 / self._slope[t.name] for t in tubes), SX(0))
            lines.append(self.system.net_inflow[name] / (conductance * self.sizes.pressure))
        return lines

    # -- what is told ---------------------------------------------------------

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
        """Names of the works of forces along paths; where pressures differ, flows tell the pump's.

        With one pressure for all it is what the fluid's pressure does to what is stored.
        """
        others = ["plunger", "coupling", "carried"]
        return others if self.form is NetworkForm.DISTRIBUTED else ["pump", *others]

    def outputs(self, conjugate: SX) -> dict[str, SX]:
        """What a motion is read from; ``conjugate`` volumes of the rod's resultants (B,)."""
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
            "pushed": column(list(system.pushed.values())),
            "plunger_pressure": column([system.plunger_pressure(n) for n in system.syringes]),
        }


def _sign(tube: Tube, node: str) -> float:
    """Whether a tube's flow comes to a node (1), leaves it (-1), or neither (0)."""
    return float(tube.end == node) - float(tube.start == node)


def _reduce(matrix: np.ndarray) -> list[int]:
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
