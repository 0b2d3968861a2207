"""The coupled model as sums that effects add to.

A system starts from what no scene can do without: elastic energy of the rod,
intrinsic strains by pressure, and a volume in every bellow. Each effect then adds
its term: an energy, a dissipation, a stored volume, a pressure drop along a tube; or
it puts a finer law in the place of a simple one: of the fluid, of a bellow's wall.
What nobody added is absent: without kinetic energy the rod is algebraic, without any
load it is a row of arcs, without pressure drops each connected network has one
pressure.

Amounts of fluid are told as volume at the density of ambient pressure; so are flows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca
import numpy as np

from viscodesign.model.bellow_law import BellowLaw, in_pairs
from viscodesign.model.bellow_wall import LinearWall, SnappingWall, Wall
from viscodesign.model.fluid import FluidLaw, Gas, Incompressible, Liquid
from viscodesign.model.graph import Graph
from viscodesign.model.rod import Body, RodDiscretisation, RodParameters
from viscodesign.model.scene_number import PARAMETER_VALUE, SCENE_NUMBER

SX = ca.SX


@dataclass(frozen=True)
class Parameter:
    """A number of a scene, and what stands for it in formulas."""

    symbol: SX
    value: float = field(metadata=PARAMETER_VALUE)


@dataclass(frozen=True)
class Syringe:
    """A closed vessel with a plunger, in the place of a source of pressure."""

    full_volume: float = field(metadata=SCENE_NUMBER)
    """Volume in front of the plunger at its start [m3]."""
    bulk_modulus: float | None = field(metadata=SCENE_NUMBER)
    """Of a liquid [Pa]; None for a gas, which follows ``exponent``."""
    exponent: float = 1.0
    cushion: float = field(default=0.0, metadata=SCENE_NUMBER)
    """Gas beside a liquid, of the full volume, at the baseline pressure [m3]."""


@dataclass(frozen=True)
class Source:
    """One inlet: a smooth formula inside each interval of the run."""

    value: Callable[[SX, SX], SX]
    """(time, piece coefficients) -> pressure above the baseline [Pa], or, with a
    ``syringe``, volume that its plunger has pushed out [m3]."""
    coefficients: int
    syringe: Syringe | None = None


class System:
    """Symbols and sums of one coupled model; `formulate` turns it into equations.

    Effects join first; what follows from all of them is then computed once, for all
    nodes together, and kept.
    """

    def __init__(
        self,
        graph: Graph,
        body: Body,
        bellow: BellowLaw,
        sources: Mapping[str, Source],
        baseline: float,
        ambient: float,
        rod: RodDiscretisation,
    ) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._stored: dict[str, SX] = {}
        self.graph = graph
        self.body = body
        self.bellow = bellow
        self.time = SX.sym("time")
        self.load_factor = SX.sym("load_factor")
        self.pieces = SX.sym("pieces", sum(s.coefficients for s in sources.values()))
        self.baseline = self.parameter("gauge_pressure", baseline)
        self.ambient = self.parameter("ambient_pressure", ambient)
        self.length = self.parameter("length", body.length)
        self.discretisation = rod
        self.rod = rod.symbols(
            RodParameters(
                self.parameter("bending_stiffness", body.bending_stiffness),
                self.parameter("extension_stiffness", body.extension_stiffness),
                self.parameter("section_length", body.section_length),
                self.parameter("mass_per_length", body.mass_per_length),
                self.length,
            )
        )
        self.pressure = {name: SX.sym(f"pressure_{name}") for name in graph.bellows_along_tubes()}
        self.junction_pressure = {name: SX.sym(f"pressure_{name}") for name in graph.junctions}
        self.inlet_pressure: dict[str, SX] = {}
        self.syringes: dict[str, Syringe] = {}
        self.pushed: dict[str, SX] = {}
        """Volume that each syringe's plunger has pushed out, a symbol [m3]."""
        self.pushed_value: dict[str, SX] = {}
        self._connect(sources)
        # Resultants of each section, positive in tension and in bending to the right.
        self.normal_force = [SX.sym(f"normal_force_{j + 1}") for j in range(graph.sections)]
        self.moment = [SX.sym(f"moment_{j + 1}") for j in range(graph.sections)]
        self.flow = {tube.name: SX.sym(f"flow_{tube.name}") for tube in graph.tubes}

        # What a node holds [m3 at ambient density]: a stand-in for `stored`, by which its
        # mass can be named before all laws are known.
        self.amount = {name: SX.sym(f"amount_{name}") for name in graph.bellows}

        # Laws that an effect may replace.
        self.fluid: FluidLaw = Incompressible()
        self.wall: Wall = self.linear_wall()
        self.filled_swelling = SX(0)
        self.swelling: dict[str, SX] = {}
        """Volume of every bellow beyond that at rest [m3], where pressure does not settle it."""

        # The sums that effects join.
        self.kinetic_energy = SX(0)
        self.load_potential = SX(0)
        self.tip_moment = SX(0)
        self.dissipation_power = SX(0)
        self.extra_volume = {name: SX(0) for name in graph.bellows}
        """What a bellow stores beyond the law of its wall [m3]."""
        self.tube_volume: dict[str, SX] = {}
        """What tubes store, at a node [m3]; `tube_energy` with it [J]."""
        self.tube_energy = SX(0)
        self.drop: dict[str, SX] = {}
        """Loss of pressure along a tube as a function of its flow [Pa]."""
        self.inertance: dict[str, SX] = {}
        """Pressure per rate of flow of a tube [kg/m4]."""

        self.wide: frozenset[str] = frozenset()
        """Tubes that hardly resist: no error of pressure may pass for a flow through them."""

    def parameter(self, name: str, value: float) -> SX:
        """A named number of the scene as a symbol, so that one build serves many values."""
        if name not in self._parameters:
            self._parameters[name] = Parameter(SX.sym(name), float(value))
        return self._parameters[name].symbol

    def parameters(self) -> tuple[SX, np.ndarray]:
        """All parameters' symbols and values, in the order of their first use."""
        symbols = [parameter.symbol for parameter in self._parameters.values()]
        values = np.array([parameter.value for parameter in self._parameters.values()])
        return ca.vertcat(*symbols), values

    def settle(self) -> None:
        """Work out what depends on all sums, so that each parameter in it has its value."""
        for tube in self.graph.tubes:
            self.driving_pressure(tube.start, tube.end)
        for name in self.graph.nodes:
            self.specific_work(name)
        for name in (*self.pressure, *self.storing_nodes()):
            self.carried_energy(name)
            self.stored(name)
        for name in self.syringes:
            self.plunger_pressure(name)
        self.swelling_defects()
        self.fluid_energy()

    # -- the network ----------------------------------------------------------

    def node_pressure(self, node: str) -> SX:
        """Gauge pressure of a node of the network, whatever its kind [Pa]."""
        for kind in (self.pressure, self.junction_pressure, self.inlet_pressure):
            if node in kind:
                return kind[node]
        raise KeyError(node)

    def driving_pressure(self, start: str, end: str) -> SX:
        """What drives the flow from one node to another, over the fluid's density [Pa]."""
        return self._driving(start) - self._driving(end)

    def _driving(self, node: str) -> SX:
        pressure = self.fluid.density_integral(self.node_pressure(node))
        return pressure - self.load_factor * self.head(node)

    def head(self, node: str) -> SX:
        """Weight of the fluid from the clamp down to a node, taken as a pressure [Pa]."""
        return -self._load_per_amount.get(node, SX(0))

    def carried_energy(self, node: str) -> SX:
        """Kinetic energy that a unit amount of fluid brings to a node [Pa]."""
        return self._kinetic_per_amount.get(node, SX(0))

    @cached_property
    def _load_per_amount(self) -> dict[str, SX]:
        return self._per_amount(self.load_potential)

    @cached_property
    def _kinetic_per_amount(self) -> dict[str, SX]:
        return self._per_amount(self.kinetic_energy)

    def _per_amount(self, energy: SX) -> dict[str, SX]:
        slopes = ca.gradient(energy, ca.vertcat(*self.amount.values()))
        return dict(zip(self.amount, ca.vertsplit(slopes), strict=True))

    def specific_work(self, node: str) -> SX:
        """Work that a unit amount of fluid can do at a node, its height included [Pa]."""
        return self.fluid.specific_work(self.node_pressure(node)) - self.head(node)

    def wall_volume(self, node: str) -> SX:
        """Volume that the walls around a node give it [m3]; zero at a bare junction."""
        volume = self.tube_volume.get(node, SX(0))
        if node in self.pressure:
            volume += self._bellow_volumes[node]
        if node in self.syringes:
            volume += self.barrel_volume(node)
        return volume

    @cached_property
    def _bellow_volumes(self) -> dict[str, SX]:
        volumes = self.wall.volume(ca.vertcat(*self.wall_argument.values()))
        return dict(zip(self.pressure, ca.vertsplit(volumes), strict=True))

    def volume(self, node: str) -> SX:
        """The same, with what the rod's resultants add [m3]."""
        return self.wall_volume(node) + self.extra_volume.get(node, SX(0))

    def stored(self, node: str) -> SX:
        """Amount of fluid at a node [m3 at ambient density]."""
        if node not in self._stored:
            self._stored[node] = self._amount_at(node)
        return self._stored[node]

    def _amount_at(self, node: str) -> SX:
        if self._has_own_fluid(node):
            # The barrel's own fluid yields, that of the network does not.
            return self.volume(node)
        return self.volume(node) * self.fluid.density(self.node_pressure(node))

    def store(self, node: str, volume: SX, compliance: SX) -> None:
        """Let tubes give a node a volume [m3], and more of it per pressure [m3/Pa]."""
        if node in self.inlet_pressure and node not in self.syringes:
            return  # an ideal source fills it, and nobody is later for it
        pressure = self.node_pressure(node)
        self.tube_volume[node] = self.tube_volume.get(node, SX(0)) + volume + compliance * pressure
        self.tube_energy += compliance * pressure**2 / 2

    def storing_nodes(self) -> list[str]:
        """Nodes besides the bellows that hold fluid: junctions of soft tubes, syringes."""
        own = {**self.junction_pressure, **self.syringes}
        return [name for name in own if name in self.tube_volume or name in self.syringes]

    @cached_property
    def net_inflow(self) -> dict[str, SX]:
        """Sum of the tube flows into every node; out of an inlet it is negative [m3/s]."""
        totals = {name: SX(0) for name in self.graph.nodes}
        for tube in self.graph.tubes:
            totals[tube.end] += self.flow[tube.name]
            totals[tube.start] -= self.flow[tube.name]
        return totals

    # -- syringes -------------------------------------------------------------

    def barrel_volume(self, name: str) -> SX:
        """Volume in front of a plunger; where the network's fluid is stiff, at ambient density."""
        left = self._space(name)
        if not self._has_own_fluid(name):
            return left
        return left * self.barrel_fluid(name).density(self.inlet_pressure[name])

    def _space(self, name: str) -> SX:
        """Volume of fluid in front of a plunger [m3]."""
        full = self.parameter(f"syringe.{name}", self.syringes[name].full_volume)
        return full - self.pushed[name] - self._cushion_volume(name)

    def _cushion_amount(self, name: str) -> SX | None:
        """The gas beside a barrel's liquid, as volume at ambient density [m3]; None without."""
        cushion = self.syringes[name].cushion
        if not cushion:
            return None
        volume = self.parameter(f"syringe.{name}.cushion", cushion)
        return volume * self._cushion_gas.density(self.baseline)

    @property
    def _cushion_gas(self) -> Gas:
        """It keeps the liquid's temperature."""
        return Gas(self.ambient, 1.0)

    def _cushion_volume(self, name: str) -> SX:
        amount = self._cushion_amount(name)
        if amount is None:
            return SX(0)
        return amount / self._cushion_gas.density(self.inlet_pressure[name])

    def cushion_energy(self, name: str) -> SX:
        """What the gas beside a barrel's liquid stores [J].

        Minus the integral of the plunger's work per volume over the gas's volume, by parts.
        """
        amount = self._cushion_amount(name)
        if amount is None:
            return SX(0)
        pressure = self.inlet_pressure[name]
        work = self._cushion_gas.specific_work(pressure)
        stored = amount * work - self._cushion_volume(name) * self.plunger_pressure(name)
        if self._has_own_fluid(name):
            # The plunger's work per volume is p + p2/(2 K): the liquid yields as well.
            modulus = self.parameter(f"syringe.{name}.bulk_modulus", self._modulus(name))
            stored += amount * self.ambient * (pressure - work) / modulus
        return stored

    def _modulus(self, name: str) -> float:
        modulus = self.syringes[name].bulk_modulus
        assert modulus is not None, "a gas has no cushion"
        return modulus

    def barrel_fluid(self, name: str) -> FluidLaw:
        """The fluid in a barrel, which always yields: the plunger's position is given."""
        syringe = self.syringes[name]
        if syringe.bulk_modulus is None:
            return Gas(self.ambient, syringe.exponent)
        return Liquid(self.parameter(f"syringe.{name}.bulk_modulus", syringe.bulk_modulus))

    def barrel_energy(self, name: str) -> SX:
        """What the barrel's own fluid stores; zero where the network's law covers it [J]."""
        if not self._has_own_fluid(name):
            return SX(0)
        law, pressure = self.barrel_fluid(name), self.inlet_pressure[name]
        return self._space(name) * (
            pressure * law.density(pressure) - law.density_integral(pressure)
        )

    def plunger_pressure(self, name: str) -> SX:
        """Work per volume that a plunger pushes out [Pa]."""
        pressure = self.inlet_pressure[name]
        if not self._has_own_fluid(name):
            return pressure
        return self.barrel_fluid(name).density_integral(pressure)

    def _has_own_fluid(self, node: str) -> bool:
        return node in self.syringes and isinstance(self.fluid, Incompressible)

    def _connect(self, sources: Mapping[str, Source]) -> None:
        used = 0
        for name, source in sources.items():
            piece = self.pieces[used : used + source.coefficients]
            used += source.coefficients
            value = source.value(self.time, piece)
            if source.syringe is None:
                self.inlet_pressure[name] = self.baseline + value
                continue
            self.syringes[name] = source.syringe
            self.inlet_pressure[name] = SX.sym(f"pressure_{name}")
            self.pushed[name] = SX.sym(f"pushed_{name}")
            self.pushed_value[name] = value

    # -- bellows --------------------------------------------------------------

    def linear_wall(self) -> LinearWall:
        """The paper's laws of a bellow."""
        law = self.bellow
        return LinearWall(
            self.parameter("rest_volume", law.rest_volume),
            self.parameter("compliance", law.compliance),
            self.parameter("curvature_per_pressure", law.curvature_per_pressure),
            self.parameter("stretch_per_pressure", law.stretch_per_pressure),
        )

    def let_snap(self, wall: SnappingWall, filled: float) -> None:
        """Give every bellow a law by which the pressure follows from its swelling.

        ``filled``: swelling at the pressure at which sealed parts were filled [m3].
        """
        self.wall = wall
        self.filled_swelling = self.parameter("filled_swelling", filled)
        self.swelling = {name: SX.sym(f"swelling_{name}") for name in self.pressure}

    @property
    def wall_argument(self) -> dict[str, SX]:
        """What the laws of the bellows' walls are functions of: pressure, or swelling."""
        return self.swelling or self.pressure

    def swelling_defects(self) -> SX:
        """Pressure of every swelling less the bellow's own (B,) [Pa]; none where none swells."""
        if not isinstance(self.wall, SnappingWall):
            return SX(0, 1)
        pressure = ca.vertcat(*self.pressure.values())
        return self.wall.pressure(ca.vertcat(*self.swelling.values())) - pressure

    @cached_property
    def intrinsic_curvature(self) -> SX:
        """Curvature of every section that its pressures ask for (S,) [1/m]."""
        left, right = self._columns
        return self.wall.curvature(left) - self.wall.curvature(right)

    @cached_property
    def intrinsic_stretch(self) -> SX:
        """Stretch of every section that its pressures ask for (S,) [1]."""
        left, right = self._columns
        return self.wall.stretch(left) + self.wall.stretch(right)

    @cached_property
    def _columns(self) -> tuple[SX, SX]:
        """What the laws of the left and the right bellows depend on, clamp first (S,)."""
        left, right = zip(*in_pairs(self.graph, self.wall_argument), strict=True)
        return ca.vertcat(*left), ca.vertcat(*right)

    def fluid_energy(self) -> SX:
        """Energy of walls and fluid whose rate is the work of what flows in [J]."""
        energy = self.tube_energy
        energy += sum(
            (self.barrel_energy(n) + self.cushion_energy(n) for n in self.syringes), SX(0)
        )
        energy += ca.sum1(self.wall.energy(ca.vertcat(*self.wall_argument.values())))
        for name in (*self.pressure, *self.storing_nodes()):
            pressure = self.node_pressure(name)
            energy += pressure * (self.volume(name) - self.wall_volume(name))
            if not isinstance(self.fluid, Incompressible):
                energy += self.stored(name) * self.fluid.specific_work(pressure)
                energy -= pressure * self.volume(name)
        return energy
