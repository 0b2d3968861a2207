"""From sums to equations: a semi-explicit differential-algebraic system of index 1.

    dx/dt = ode(x, z, t),   0 = alg(x, z, t)

Every unknown is divided by its size, every algebraic equation by the size of its
terms, so that one tolerance means the same for all. Which unknowns exist follows
from what the effects added:

===========================  ==============================================
kinetic energy               positions and velocities are states
only dissipation             positions are states, velocities algebraic
only loads                   positions are algebraic (a static rod)
nothing                      the rod is a row of arcs; no rod unknowns at all
tube flows                   volumes are states, pressures algebraic
no tube flows                one pressure per connected network
===========================  ==============================================
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import casadi as ca
import numpy as np

from viscodesign.errors import SpecError
from viscodesign.model.graph import Component
from viscodesign.model.system import System

SX = ca.SX


class RodForm(Enum):
    """How the rod enters the equations."""

    ARCS = "closed-form arcs"
    STATIC = "static rod"
    DAMPED = "massless damped rod"
    DYNAMIC = "dynamic rod"


class NetworkForm(Enum):
    """How the network enters the equations."""

    DISTRIBUTED = "a pressure in every bellow"
    UNIFORM = "one pressure per connected network"


@dataclass(frozen=True)
class Sizes:
    """Typical sizes by which unknowns are divided: of pressure [Pa] and of time [s]."""

    pressure: float
    time: float


@dataclass(frozen=True)
class Block:
    """A run of unknowns of one kind and size."""

    name: str
    start: int
    count: int
    size: float

    @property
    def span(self) -> slice:
        """Where the block stands in its vector."""
        return slice(self.start, self.start + self.count)


@dataclass
class Unknowns:
    """A vector of scaled unknowns, made of blocks."""

    hats: list[SX] = field(default_factory=list)
    blocks: dict[str, Block] = field(default_factory=dict)
    symbols: list[SX] = field(default_factory=list)
    values: list[SX] = field(default_factory=list)

    def add(self, name: str, symbol: SX, size: float) -> None:
        """Let ``symbol`` be ``size`` times a new scaled unknown."""
        flat = ca.vec(symbol)
        hat = SX.sym(f"{name}_hat", flat.numel())
        start = sum(block.count for block in self.blocks.values())
        self.blocks[name] = Block(name, start, flat.numel(), size)
        self.hats.append(hat)
        self.symbols.append(flat)
        self.values.append(size * hat)

    @property
    def vector(self) -> SX:
        """All scaled unknowns as one column."""
        return ca.vertcat(*self.hats) if self.hats else SX(0, 1)

    @property
    def count(self) -> int:
        """Number of unknowns."""
        return sum(block.count for block in self.blocks.values())

    def sizes(self) -> np.ndarray:
        """Size of every unknown, in order."""
        return np.concatenate(
            [np.full(block.count, block.size) for block in self.blocks.values()] or [np.zeros(0)]
        )

    def physical(self, name: str, hats: np.ndarray) -> np.ndarray:
        """Values in SI of one block out of a scaled vector or (count, T) matrix."""
        block = self.blocks[name]
        return np.asarray(hats)[block.span] * block.size


@dataclass(frozen=True)
class Equations:
    """The equations of one system, with everything a solver needs to know."""

    rod_form: RodForm
    network_form: NetworkForm
    states: Unknowns
    algebraics: Unknowns
    statics: Unknowns
    """Unknowns of the equilibrium: pressures and the rod's shape."""
    time: SX
    pieces: SX
    parameters: SX
    parameter_values: np.ndarray
    ode: SX
    alg: SX
    rates: dict[str, SX]
    """Powers and flows whose integrals the balances need."""
    function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> (ode, alg)."""
    static_function: ca.Function
    """(y, t, pieces, load_factor, sealed_volumes, parameters) -> (residual, Jacobian,
    volumes, intrinsic curvatures, intrinsic stretches)."""
    algebraic_function: ca.Function
    """Like `function`, returning (alg, d alg/d z)."""
    output_function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> named outputs."""
    components: tuple[Component, ...]
    fed: tuple[Component, ...]
    sealed: tuple[Component, ...]


def formulate(system: System, sizes: Sizes) -> Equations:
    """Turn a system's sums into equations.

    Raises `SpecError` where one pressure per network is asked for and two inlets
    feed the same network.
    """
    return _Formulation(system, sizes).equations()


def rod_form(system: System) -> RodForm:
    """The simplest rod that carries everything that was added to the system."""
    if not system.kinetic_energy.is_zero():
        return RodForm.DYNAMIC
    if not system.dissipation_power.is_zero():
        return RodForm.DAMPED
    loaded = not (system.load_potential.is_zero() and system.tip_moment.is_zero())
    return RodForm.STATIC if loaded else RodForm.ARCS


class _Formulation:
    """One pass over a system; kept together because every step needs the same symbols."""

    def __init__(self, system: System, sizes: Sizes) -> None:
        self.system = system
        self.sizes = sizes
        self.rod_form = rod_form(system)
        self.network_form = NetworkForm.DISTRIBUTED if system.flow else NetworkForm.UNIFORM
        self.components = tuple(system.graph.components())
        self.fed = [c for c in self.components if c.fed]
        self.sealed = [c for c in self.components if not c.fed and c.bellows]
        self.sealed_volumes = SX.sym("sealed_volumes", len(self.sealed))
        self.network_pressures: list[tuple[SX, SX]] = []
        self.states, self.algebraics, self.statics = Unknowns(), Unknowns(), Unknowns()
        self._name_unknowns()

    # -- unknowns -------------------------------------------------------------

    def _name_unknowns(self) -> None:
        rod, pressure = self.system.rod, self.sizes.pressure
        body = self.system.body
        volume = self.system.bellow.compliance * pressure
        speed = body.length / self.sizes.time
        if self.network_form is NetworkForm.DISTRIBUTED:
            self.volumes = SX.sym("volume", len(self.system.pressure))
            self.states.add("volume", self.volumes, volume)
            if self.fed:
                self.inflows = SX.sym("inflow", len(self.fed))
                self.states.add("inflow", self.inflows, volume * len(self.system.pressure))
            pressures = ca.vertcat(*self.system.pressure.values())
            junctions = ca.vertcat(*self.system.junction_pressure.values())
            for unknowns in (self.algebraics, self.statics):
                unknowns.add("pressure", pressures, pressure)
                if self.system.junction_pressure:
                    unknowns.add("junction_pressure", junctions, pressure)
        else:
            self._share_pressures(pressure)
        if self.rod_form is RodForm.ARCS:
            return
        curvature = 1.0 / body.length
        self.algebraics.add("elastic_curvature", rod.elastic_curvature, curvature)
        self.statics.add("elastic_curvature", rod.elastic_curvature, curvature)
        self.statics.add("position", rod.position, body.length)
        if self.rod_form is RodForm.STATIC:
            self.algebraics.add("position", rod.position, body.length)
            return
        self.states.add("position", rod.position, body.length)
        owner = self.states if self.rod_form is RodForm.DYNAMIC else self.algebraics
        owner.add("velocity", rod.velocity, speed)

    def _share_pressures(self, size: float) -> None:
        """Give every connected network one pressure: its inlet's, or an unknown."""
        shared = SX.sym("network_pressure", len(self.sealed))
        if self.sealed:
            self.algebraics.add("network_pressure", shared, size)
            self.statics.add("network_pressure", shared, size)
        for component in self.components:
            if len(component.inlets) > 1:
                raise SpecError.plain(
                    f"effects.pressure_distribution: off gives every connected network one "
                    f"pressure, but the inlets {', '.join(component.inlets)} feed the same "
                    f"network. Use 'on' or 'auto', or separate the inlets."
                )
            value = (
                self.system.inlet_pressure[component.inlets[0]]
                if component.inlets
                else shared[self.sealed.index(component)]
                if component in self.sealed
                else None
            )
            if value is None:
                continue
            for name in component.bellows:
                self.network_pressures.append((self.system.pressure[name], value))
            for name in component.junctions:
                self.network_pressures.append((self.system.junction_pressure[name], value))

    # -- substitution ---------------------------------------------------------

    def _resolve(self, expressions: list[SX], unknowns: tuple[Unknowns, ...]) -> list[SX]:
        """Replace resultants, intrinsic strains, shared pressures and unknowns, in this order."""
        system, rod = self.system, self.system.rod
        result = _substitute(expressions, self._resultant_symbols(), self._resultants())
        result = _substitute(
            result,
            [rod.intrinsic_curvature, rod.intrinsic_stretch, rod.tip_moment],
            [
                ca.vertcat(*system.intrinsic_curvature),
                ca.vertcat(*system.intrinsic_stretch),
                system.load_factor * system.tip_moment,
            ],
        )
        if self.network_pressures:
            symbols, values = zip(*self.network_pressures, strict=True)
            result = _substitute(result, list(symbols), list(values))
        for group in unknowns:
            result = _substitute(result, group.symbols, group.values)
        return result

    def _resultant_symbols(self) -> list[SX]:
        return [ca.vertcat(*self.system.normal_force), ca.vertcat(*self.system.moment)]

    def _resultants(self) -> list[SX]:
        """Mean normal force and moment of each section: conjugate to its intrinsic strains."""
        rod, sections = self.system.rod, self.system.graph.sections
        if self.rod_form is RodForm.ARCS:
            return [SX.zeros(sections), SX.zeros(sections)]
        section_length = rod.h * rod.edges_per_section
        potential = rod.elastic_potential()
        return [
            -ca.gradient(potential, rod.intrinsic_stretch) / section_length,
            -ca.gradient(potential, rod.intrinsic_curvature) / section_length,
        ]

    def _conjugate_volumes(self) -> SX:
        """Volume that a reciprocal coupling would store under the section's resultants (B,)."""
        system = self.system
        pressure = ca.vertcat(*system.pressure.values())
        bending = ca.jacobian(ca.vertcat(*system.intrinsic_curvature), pressure)
        extension = ca.jacobian(ca.vertcat(*system.intrinsic_stretch), pressure)
        section = system.rod.h * system.rod.edges_per_section
        return section * (
            bending.T @ ca.vertcat(*system.moment) + extension.T @ ca.vertcat(*system.normal_force)
        )

    # -- balances -------------------------------------------------------------

    def _volume_defects(self) -> list[SX]:
        """The state is the volume beyond that at rest: small departures keep their digits."""
        rest = self.system.parameter("rest_volume", self.system.bellow.rest_volume)
        stored = ca.vertcat(*self.system.volume.values()) - rest
        return [(self.volumes - stored) / self._volume_size()]

    def _volume_size(self) -> float:
        return self.system.bellow.compliance * self.sizes.pressure

    def _junction_balances(self) -> list[SX]:
        """Flow sums of the junctions, over the flow that their own tubes could carry."""
        inflow, balances = self.system.net_inflows(), []
        for name, pressure in self.system.junction_pressure.items():
            own = -ca.jacobian(inflow[name], pressure)
            balances.append(inflow[name] / (own * self.sizes.pressure))
        return balances

    def _forces(self) -> SX:
        rod = self.system.rod
        potential = (
            rod.elastic_potential()
            + self.system.load_factor * self.system.load_potential
            - rod.tip_moment * ca.sum1(rod.turns)
        )
        forces = -ca.gradient(potential, ca.vec(rod.position))
        if self.rod_form in (RodForm.DYNAMIC, RodForm.DAMPED):
            # A Rayleigh function is half the power, its gradient the force.
            forces -= ca.gradient(self.system.dissipation_power / 2, ca.vec(rod.velocity))
        return forces

    def _force_size(self) -> SX:
        return self.system.rod.EI / self.system.body.length**2

    def _accelerations(self) -> SX:
        velocity = ca.vec(self.system.rod.velocity)
        momentum = ca.gradient(self.system.kinetic_energy, velocity)
        mass = ca.jacobian(momentum, velocity)
        if not mass.sparsity().is_diag() or ca.depends_on(mass, velocity):
            raise NotImplementedError("kinetic energy that couples the nodes' velocities")
        return self._forces() / ca.diag(mass)

    def _compatibility(self) -> SX:
        return self.system.rod.compatibility() * self.system.rod.edges

    # -- assembly -------------------------------------------------------------

    def _dynamics(self) -> tuple[list[SX], list[SX]]:
        """Rates of the scaled states and scaled algebraic defects, not yet resolved."""
        ode: list[SX] = []
        alg: list[SX] = []
        if self.network_form is NetworkForm.DISTRIBUTED:
            inflow = self.system.net_inflows()
            ode.append(
                ca.vertcat(*(inflow[name] for name in self.system.pressure)) / self._volume_size()
            )
            if self.fed:
                # A state, not a quadrature: only then do the same linear formulas carry
                # it and the volumes, and the balance holds to round-off.
                size = self._volume_size() * len(self.system.pressure)
                outflow = self._inlet_outflows()
                ode.append(ca.vertcat(*(self._fed_inflow(c, outflow) for c in self.fed)) / size)
            alg += self._volume_defects() + self._junction_balances()
        else:
            alg += self._sealed_defects()
        if self.rod_form is RodForm.ARCS:
            return ode, alg
        alg.append(self._compatibility())
        length, time = self.system.body.length, self.sizes.time
        velocity = ca.vec(self.system.rod.velocity)
        if self.rod_form is RodForm.DYNAMIC:
            ode += [velocity / length, self._accelerations() * time / length]
        else:
            alg.append(self._forces() / self._force_size())
        if self.rod_form is RodForm.DAMPED:
            ode.append(velocity / length)
        return ode, alg

    def _sealed_defects(self) -> list[SX]:
        """What a sealed island holds less what it was filled with."""
        return [
            (ca.sum1(ca.vertcat(*(self.system.volume[b] for b in component.bellows))) - filled)
            / (self._volume_size() * len(component.bellows))
            for component, filled in zip(
                self.sealed, ca.vertsplit(self.sealed_volumes) if self.sealed else [], strict=True
            )
        ]

    def _equilibrium(self) -> list[SX]:
        """Defects of the steady state in the static unknowns, not yet resolved."""
        defects: list[SX] = []
        if self.network_form is NetworkForm.DISTRIBUTED:
            defects += self._steady_pressures() + self._junction_balances()
        else:
            defects += self._sealed_defects()
        if self.rod_form is not RodForm.ARCS:
            forces = self._forces() / self._force_size()
            still = ca.vec(self.system.rod.velocity)
            defects += [
                self._compatibility(),
                *_substitute([forces], [still], [SX.zeros(still.shape)]),
            ]
        return defects

    def _steady_pressures(self) -> list[SX]:
        """No net flow anywhere; in a sealed island the first bellow's line is its volume."""
        inflow = self.system.net_inflows()
        sealed = dict(zip((c.bellows[0] for c in self.sealed), self._sealed_defects(), strict=True))
        lines = []
        for name, pressure in self.system.pressure.items():
            own = -ca.jacobian(inflow[name], pressure)
            if name in sealed:
                lines.append(sealed[name])
            else:
                lines.append(inflow[name] / (own * self.sizes.pressure))
        return lines

    def _inlet_outflows(self) -> dict[str, SX]:
        """What leaves each inlet through its tubes [m3/s]."""
        outflow = {name: SX(0) for name in self.system.inlet_pressure}
        for tube in self.system.graph.tubes:
            for end, sign in ((tube.start, 1), (tube.end, -1)):
                if end in outflow:
                    outflow[end] += sign * self.system.flow[tube.name]
        return outflow

    def _fed_inflow(self, component: Component, outflow: dict[str, SX]) -> SX:
        return sum((outflow[name] for name in component.inlets), SX(0))

    def _balance_rates(self) -> dict[str, SX]:
        system = self.system
        rates: dict[str, SX] = {}
        if system.flow:
            outflow = self._inlet_outflows()
            rates["pump_power"] = sum(
                (system.inlet_pressure[n] * q for n, q in outflow.items()), SX(0)
            )
            rates["tube_loss"] = sum(
                (
                    system.flow[t.name]
                    * (system.node_pressure(t.start) - system.node_pressure(t.end))
                    for t in system.graph.tubes
                ),
                SX(0),
            )
        if self.rod_form in (RodForm.DYNAMIC, RodForm.DAMPED):
            rates["material_loss"] = system.dissipation_power
        return rates

    def _outputs(self) -> dict[str, SX]:
        system, rod = self.system, self.system.rod
        pressure = ca.vertcat(*system.pressure.values())
        volume = ca.vertcat(*system.volume.values())
        linear = ca.vertcat(*system.linear_volume.values())
        outputs = {
            "pressure": pressure,
            "volume": volume,
            "flow": ca.vertcat(*system.flow.values()) if system.flow else SX(0, 1),
            "inlet_pressure": ca.vertcat(*system.inlet_pressure.values()),
            "normal_force": ca.vertcat(*system.normal_force),
            "moment": ca.vertcat(*system.moment),
            "intrinsic_curvature": rod.intrinsic_curvature,
            "intrinsic_stretch": rod.intrinsic_stretch,
            "unpaired_volume": volume - linear - self._conjugate_volumes(),
            "fluid_energy": system.fluid_energy + ca.dot(pressure, volume - linear),
            "kinetic_energy": system.kinetic_energy,
            "load_energy": system.load_potential,
        }
        if self.rod_form is not RodForm.ARCS:
            outputs |= {
                "position": ca.vec(rod.position),
                "angle": rod.node_angles(),
                "stretch": rod.stretch,
                "elastic_energy": rod.elastic_potential(),
            }
        return outputs

    def equations(self) -> Equations:
        """Assemble, resolve and compile."""
        groups = (self.states, self.algebraics)
        ode_parts, alg_parts = self._dynamics()
        rates, outputs = self._balance_rates(), self._outputs()
        resolved = self._resolve(
            [_column(ode_parts), _column(alg_parts), *rates.values(), *outputs.values()], groups
        )
        ode, alg = ca.cse(resolved[:2])
        rates = dict(zip(rates, resolved[2 : 2 + len(rates)], strict=True))
        outputs = dict(zip(outputs, resolved[2 + len(rates) :], strict=True))
        rod = self.system.rod
        static, *static_values = self._resolve(
            [
                _column(self._equilibrium()),
                ca.vertcat(*self.system.volume.values()),
                rod.intrinsic_curvature,
                rod.intrinsic_stretch,
            ],
            (self.statics,),
        )
        parameters, values = self.system.parameters()
        x, z, y = self.states.vector, self.algebraics.vector, self.statics.vector
        tail = [
            self.system.time,
            self.system.pieces,
            self.system.load_factor,
            self.sealed_volumes,
            parameters,
        ]
        return Equations(
            rod_form=self.rod_form,
            network_form=self.network_form,
            states=self.states,
            algebraics=self.algebraics,
            statics=self.statics,
            time=self.system.time,
            pieces=self.system.pieces,
            parameters=ca.vertcat(self.system.load_factor, self.sealed_volumes, parameters),
            parameter_values=values,
            ode=ode,
            alg=alg,
            rates=rates,
            function=ca.Function("balances", [x, z, *tail], [ode, alg]),
            static_function=ca.Function(
                "equilibrium", [y, *tail], [static, ca.jacobian(static, y), *static_values]
            ),
            algebraic_function=ca.Function(
                "constraints", [x, z, *tail], [alg, ca.jacobian(alg, z)]
            ),
            output_function=ca.Function(
                "outputs", [x, z, *tail], list(outputs.values()), _names(7), list(outputs)
            ),
            components=self.components,
            fed=tuple(self.fed),
            sealed=tuple(self.sealed),
        )


def _names(count: int) -> list[str]:
    return [f"i{k}" for k in range(count)]


def _column(parts: list[SX]) -> SX:
    return ca.vertcat(*parts) if parts else SX(0, 1)


def _substitute(expressions: list[SX], symbols: list[SX], values: list[SX]) -> list[SX]:
    if not symbols:
        return expressions
    flat = ca.vertcat(*(ca.vec(s) for s in symbols))
    replaced = ca.vertcat(*(ca.vec(v) for v in values))
    return list(ca.substitute(expressions, [flat], [replaced]))
