"""The coupled model as sums that effects add to.

A system starts from what every scene needs: elastic energy of the rod, intrinsic
strains by pressure, and a volume in every bellow. Each effect then adds its term: an
energy, a dissipation, a stored volume, a pressure drop along a tube; or it replaces a
simple law by a finer one: of the fluid, of a bellow's wall.
What no effect added is absent: without kinetic energy the rod is algebraic, without any
load it is a row of arcs, without pressure drops each connected network has one
pressure.

Amounts of fluid are stated as volume at ambient density; so are flows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import BellowLaws, in_pairs
from viscodesign.model.bellow_wall import LinearWall, OwnWalls, SnappingWall, Wall
from viscodesign.model.contact_point import ContactPoint
from viscodesign.model.fluid import FluidLaw, Incompressible
from viscodesign.model.graph import Graph
from viscodesign.model.rod import Body, RodDiscretisation, RodParameters, Softness
from viscodesign.model.scene_number import PARAMETER_VALUE, Numbers
from viscodesign.model.sums import Terms
from viscodesign.model.syringes import SyringeParameters, SyringeSymbols
from viscodesign.storage.cached_property import cached_property

SX = ca.SX


@dataclass(frozen=True)
class Parameter:
    """A number of a scene, and its symbol in formulas."""

    symbol: SX
    value: float = field(metadata=PARAMETER_VALUE)


@dataclass(frozen=True)
class InletSource:
    """One inlet: a smooth formula inside each interval of the run."""

    value: Callable[[SX, SX], SX]
    """(time, piece coefficients) -> pressure above the baseline [Pa], or, with a
    ``syringe``, volume that its plunger has pushed out [m3]."""
    coefficients: int
    syringe: SyringeParameters | None = None


def rod_endings(system: System) -> list[str]:
    """What the names of a rod's own parameters end with: nothing for a single one."""
    count = len(system.rod.rods)
    return [f".{k + 1}" for k in range(count)] if count > 1 else [""]


class System:
    """Symbols and sums of one coupled model; `formulate` turns it into equations.

    Effects join first; what follows from all of them is then computed once, for all
    nodes together.
    """

    def __init__(
        self,
        graph: Graph,
        body: Body,
        bellows: BellowLaws,
        sources: Mapping[str, InletSource],
        baseline: float,
        ambient: float,
        rod: RodDiscretisation,
    ) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._stored: dict[str, SX] = {}
        self.graph = graph
        self.body = body
        self.bellow = bellows.typical
        self.bellows = bellows
        self.time = SX.sym("time")
        self.load_factor = SX.sym("load_factor")
        self.pieces = SX.sym("pieces", sum(s.coefficients for s in sources.values()))
        self.baseline = self.parameter("gauge_pressure", baseline)
        self.ambient = self.parameter("ambient_pressure", ambient)
        self.length = self.parameter("length", body.length)
        self.discretisation = rod
        self.parameter("compliance", self.bellow.compliance)
        self._rod_parameters = self._parameters_of(body)
        self.rod = rod.symbols(self._rod_parameters)
        self.pressure = {name: SX.sym(f"pressure_{name}") for name in graph.bellows_along_tubes()}
        self.junction_pressure = {name: SX.sym(f"pressure_{name}") for name in graph.junctions}
        self.inlet_pressure: dict[str, SX] = {}
        self.syringes: dict[str, SyringeSymbols] = {}
        self._connect(sources)
        # Resultants of each section, positive in tension and in bending to the right.
        self.normal_force = [SX.sym(f"normal_force_{j + 1}") for j in range(graph.sections)]
        self.moment = [SX.sym(f"moment_{j + 1}") for j in range(graph.sections)]
        self.flow = {tube.name: SX.sym(f"flow_{tube.name}") for tube in graph.tubes}

        # Content of a node [m3 at ambient density]: a stand-in for `stored`, so that its
        # mass can be used before all laws are known.
        self.amount = {name: SX.sym(f"amount_{name}") for name in graph.bellows}

        # Laws that an effect may replace.
        self.fluid: FluidLaw = Incompressible()
        self.wall: Wall = self.linear_wall()
        self.filled_swelling = SX(0)
        self.swelling: dict[str, SX] = {}
        """Volume of every bellow beyond that at rest [m3], where pressure does not determine it."""

        # The sums that effects join.
        self.kinetic_energy = Terms()
        self.load_potential = Terms()
        self.tip_moment = SX(0)
        self.contacts: list[ContactPoint] = []
        self.contact_moment = SX(0)
        """Moment by which forces of contact turn the tip [N m]."""
        self.dissipation_power = Terms()
        self.extra_volume = {name: SX(0) for name in graph.bellows}
        """Volume of a bellow beyond the law of its wall [m3]."""
        self.tube_volume: dict[str, SX] = {}
        """Volume that elastic tubes give a node [m3]; `tube_energy` belongs to it [J]."""
        self.tube_energy = SX(0)
        self.drop: dict[str, SX] = {}
        """Pressure drop along a tube as a function of its flow [Pa]."""
        self.inertance: dict[str, SX] = {}
        """Pressure per rate of change of a tube's flow [kg/m4]."""

        self.wide: frozenset[str] = frozenset()
        """Tubes of so little resistance that an error of pressure must not turn into a flow."""

    def parameter(self, name: str, value: float) -> SX:
        """A named number of the scene as a symbol, so that the same formulas serve many values.

        Raises `ValueError` where the name already has another value: an effect's own
        numbers begin with its name, as in ``gravity.tilt``.
        """
        if name not in self._parameters:
            self._parameters[name] = Parameter(SX.sym(name), value)
        known = self._parameters[name]
        is_blank = value != value  # NaN, which formulation makes of it
        if not is_blank and value != known.value:
            raise ValueError(
                f"parameter {name!r} is {known.value:g} already, and cannot be {value:g} as well; "
                "begin the names of an effect's own parameters with its name"
            )
        return known.symbol

    def of_sections(self, name: str, values: Numbers) -> SX:
        """A number of all sections: one symbol for one number, or one of each section (S,)."""
        return self._several(name, values, [str(j + 1) for j in range(self.graph.sections)])

    def of_bellows(self, name: str, values: Numbers) -> SX:
        """A number of all bellows, as the walls' laws read it: one symbol, or (B,) of them.

        ``values``: one number, or an array in the order of the graph (B,).
        """
        if not isinstance(values, np.ndarray):
            return self.parameter(name, values)
        own = dict(zip(self.graph.bellows, values.tolist(), strict=True))
        along = self.graph.bellows_along_tubes()
        return self._several(name, np.array([own[b] for b in along]), along)

    def _several(self, name: str, values: Numbers, members: Sequence[str]) -> SX:
        if not isinstance(values, np.ndarray):
            return self.parameter(name, values)
        each = zip(members, values.tolist(), strict=True)
        return ca.vertcat(*(self.parameter(f"{name}.{own}", value) for own, value in each))

    def parameters(self) -> tuple[SX, np.ndarray]:
        """All parameters' symbols and values, in the order of their first use."""
        symbols = [parameter.symbol for parameter in self._parameters.values()]
        return ca.vertcat(*symbols), np.array(list(self.numbers().values()), dtype=float)

    def numbers(self) -> dict[str, float]:
        """All parameters' values by name, in the same order."""
        return {name: parameter.value for name, parameter in self._parameters.items()}

    def settle(self) -> None:
        """Compute what depends on all sums, so that every parameter in it is registered."""
        for tube in self.graph.tubes:
            self.driving_pressure(tube.start, tube.end)
        for name in self.graph.nodes:
            self.specific_work(name)
        for name in (*self.pressure, *self.storing_nodes()):
            self.carried_energy(name)
            self.stored(name)
        self.swelling_defects()
        self.fluid_energy()

    # -- the rod --------------------------------------------------------------

    def _parameters_of(self, body: Body, rod: str = "") -> RodParameters:
        """``rod``: what the names of one of several end with."""
        bending = self.parameter(f"bending_stiffness{rod}", body.bending_stiffness)
        extension = self.parameter(f"extension_stiffness{rod}", body.extension_stiffness)
        section = self.parameter(f"section_length{rod}", body.section_length)
        own = body.varied
        mass = self.parameter(f"mass_per_length{rod}", body.mass_per_length)
        if body.members:
            each = enumerate(body.members, start=1)
            members = tuple(self._parameters_of(member, f".{k}") for k, member in each)
            return RodParameters(bending, extension, section, mass, self.length, members=members)
        if own is None:
            return RodParameters(bending, extension, section, mass, self.length)
        names = [str(j + 1) for j in range(body.sections)]
        softness = Softness(
            bending
            / self._several(f"section_bending_stiffness{rod}", own.bending_stiffness, names),
            extension
            / self._several(f"section_extension_stiffness{rod}", own.extension_stiffness, names),
        )
        if isinstance(own.mass_per_length, np.ndarray):
            mass = self._several(f"section_mass_per_length{rod}", own.mass_per_length, names)
        return RodParameters(bending, extension, section, mass, self.length, softness=softness)

    def let_shear(self, stiffness: SX) -> None:
        """Let cross sections turn against the axis; ``stiffness``: kappa G A [N].

        Raises `ValueError` where something was said of the rod before.
        """
        self.discretisation = self.discretisation.shearable()
        self._renew_rod(replace(self._rod_parameters, shear_stiffness=stiffness))

    def scale_stiffness(self, bending: SX | float = 1.0, extension: SX | float = 1.0) -> None:
        """Multiply the stiffnesses of all sections of all rods by factors [1].

        Curvature and stretch under pressure alone stay: they are stated as such. Raises
        `ValueError` where something was said of the rod before.
        """
        self._renew_rod(self._rod_parameters.stiffened(SX(bending), SX(extension)))

    def _renew_rod(self, parameters: RodParameters) -> None:
        """Replace the rod's symbols: what was said of the old ones would be lost."""
        masses = len(self.rod.masses())
        self._rod_parameters = parameters
        self.rod = self.discretisation.symbols(parameters)
        sums = self.kinetic_energy, self.load_potential, self.dissipation_power
        is_untouched = all(one.is_zero() for one in sums) and self.tip_moment.is_zero()
        if not is_untouched or self.contacts or masses != len(self.rod.masses()):
            raise ValueError(
                "an effect that changes the rod's law must join before all that load it or hang "
                "masses on it; give it an `order` below 5"
            )

    def add_contact(
        self, name: str, gap: SX, along: SX, friction: SX, foot_radius: SX | None = None
    ) -> None:
        """Let a rigid surface touch the rod at a point.

        ``gap``, ``along``: distance from the surface and path along it, of a point without
        rotation [m]; ``friction``: Coulomb's coefficient [1]; ``foot_radius``: that of a round
        tip around the point, which rolls and whose radius ``gap`` has taken off [m].
        """
        normal, tangential = SX.sym(f"normal_force_at_{name}"), SX.sym(f"friction_at_{name}")
        slip = along
        if foot_radius is not None:
            slip = along - foot_radius * self.rod.tip_angle
            self.contact_moment -= foot_radius * tangential
        self.contacts.append(ContactPoint(name, gap, along, slip, friction, normal, tangential))

    # -- the network ----------------------------------------------------------

    def node_pressure(self, node: str) -> SX:
        """Gauge pressure of a node of the network of any kind [Pa]."""
        for kind in (self.pressure, self.junction_pressure, self.inlet_pressure):
            if node in kind:
                return kind[node]
        raise KeyError(node)

    def driving_pressure(self, start: str, end: str) -> SX:
        """Driving pressure of the flow from one node to another, density included [Pa]."""
        return self._driving(start) - self._driving(end)

    def _driving(self, node: str) -> SX:
        pressure = self.fluid.density_integral(self.node_pressure(node))
        return pressure - self.load_factor * self.head(node)

    def head(self, node: str) -> SX:
        """Hydrostatic pressure from the clamp down to a node [Pa]."""
        return -self._load_per_amount.get(node, SX(0))

    def carried_energy(self, node: str) -> SX:
        """Kinetic energy of a unit amount of fluid at a node [Pa]."""
        return self._kinetic_per_amount.get(node, SX(0))

    @cached_property
    def _load_per_amount(self) -> dict[str, SX]:
        return self._per_amount(self.load_potential.total)

    @cached_property
    def _kinetic_per_amount(self) -> dict[str, SX]:
        return self._per_amount(self.kinetic_energy.total)

    def _per_amount(self, energy: SX) -> dict[str, SX]:
        slopes = ca.gradient(energy, ca.vertcat(*self.amount.values()))
        return dict(zip(self.amount, ca.vertsplit(slopes), strict=True))

    def specific_work(self, node: str) -> SX:
        """Work that a unit amount of fluid can do at a node, including its height [Pa]."""
        return self.fluid.specific_work(self.node_pressure(node)) - self.head(node)

    def wall_volume(self, node: str) -> SX:
        """Volume between the walls around a node [m3]; zero at a rigid junction."""
        volume = self.tube_volume.get(node, SX(0))
        if node in self.pressure:
            volume += self._bellow_volumes[node]
        if node in self.syringes:
            volume += self.syringes[node].volume(self._is_stiff)
        return volume

    @cached_property
    def _bellow_volumes(self) -> dict[str, SX]:
        volumes = self.wall.volume(ca.vertcat(*self.wall_argument.values()))
        return dict(zip(self.pressure, ca.vertsplit(volumes), strict=True))

    def volume(self, node: str) -> SX:
        """The same with the volume that the rod's resultants add [m3]."""
        return self.wall_volume(node) + self.extra_volume.get(node, SX(0))

    def stored(self, node: str) -> SX:
        """Amount of fluid at a node [m3 at ambient density]."""
        if node not in self._stored:
            self._stored[node] = self._amount_at(node)
        return self._stored[node]

    def _amount_at(self, node: str) -> SX:
        if node in self.syringes and self._is_stiff:
            # The barrel's own fluid is compressible, that of the network is not.
            return self.volume(node)
        return self.volume(node) * self.fluid.density(self.node_pressure(node))

    @property
    def _is_stiff(self) -> bool:
        """Whether the network's fluid is incompressible."""
        return isinstance(self.fluid, Incompressible)

    def store(self, node: str, volume: SX, compliance: SX) -> None:
        """Give a node the volume of elastic tubes [m3], and their compliance [m3/Pa]."""
        if node in self.inlet_pressure and node not in self.syringes:
            return  # an ideal source fills it without delay
        pressure = self.node_pressure(node)
        self.tube_volume[node] = self.tube_volume.get(node, SX(0)) + volume + compliance * pressure
        self.tube_energy += compliance * pressure**2 / 2

    def storing_nodes(self) -> list[str]:
        """Nodes other than bellows that store fluid: junctions of elastic tubes, syringes."""
        own = {**self.junction_pressure, **self.syringes}
        return [name for name in own if name in self.tube_volume or name in self.syringes]

    @cached_property
    def net_inflow(self) -> dict[str, SX]:
        """Sum of the tube flows into every node [m3/s]; negative where an inlet delivers."""
        totals = {name: SX(0) for name in self.graph.nodes}
        for tube in self.graph.tubes:
            totals[tube.end] += self.flow[tube.name]
            totals[tube.start] -= self.flow[tube.name]
        return totals

    # -- bellows --------------------------------------------------------------

    def _connect(self, sources: Mapping[str, InletSource]) -> None:
        used = 0
        for name, source in sources.items():
            piece = self.pieces[used : used + source.coefficients]
            used += source.coefficients
            value = source.value(self.time, piece)
            if source.syringe is None:
                self.inlet_pressure[name] = self.baseline + value
                continue
            syringe = SyringeSymbols(
                name, source.syringe, value, self.baseline, self.ambient, self.parameter
            )
            self.syringes[name] = syringe
            self.inlet_pressure[name] = syringe.pressure

    def linear_wall(self) -> LinearWall:
        """The paper's laws of a bellow."""
        law = self.bellows
        return LinearWall(
            self.of_bellows("rest_volume", law.rest_volume),
            self.of_bellows("compliance", law.compliance),
            self.of_bellows("curvature_per_pressure", law.curvature_per_pressure),
            self.of_bellows("stretch_per_pressure", law.stretch_per_pressure),
        )

    def let_snap(self, wall: SnappingWall | OwnWalls, filled: Numbers) -> None:
        """Let the pressure of every bellow be a function of its swelling, a new unknown.

        ``filled``: swelling at the pressure at which sealed parts were filled, one or (B,) [m3].
        """
        self.wall = wall
        self.filled_swelling = self.of_bellows("filled_swelling", filled)
        self.swelling = {name: SX.sym(f"swelling_{name}") for name in self.pressure}

    def plunger_pressures(self) -> list[SX]:
        """Work per volume that every plunger pushes out [Pa]."""
        return [syringe.plunger_pressure(self._is_stiff) for syringe in self.syringes.values()]

    @property
    def wall_argument(self) -> dict[str, SX]:
        """Argument of the laws of the bellows' walls: pressure, or swelling."""
        return self.swelling or self.pressure

    def swelling_defects(self) -> SX:
        """Pressure of every swelling minus the bellow's own (B,) [Pa]; empty without swellings."""
        if not (self.swelling and isinstance(self.wall, SnappingWall | OwnWalls)):
            return SX(0, 1)
        pressure = ca.vertcat(*self.pressure.values())
        return self.wall.pressure(ca.vertcat(*self.swelling.values())) - pressure

    @cached_property
    def intrinsic_curvature(self) -> SX:
        """Curvature of every section under its pressures alone (S,) [1/m]."""
        left, right = self._columns(self.wall.curvature)
        return left - right

    @cached_property
    def intrinsic_stretch(self) -> SX:
        """Stretch of every section under its pressures alone (S,) [1]."""
        left, right = self._columns(self.wall.stretch)
        return left + right

    def _columns(self, law: Callable[[SX], SX]) -> tuple[SX, SX]:
        """A law's values of the left and the right bellows, clamp first (S,)."""
        names, arguments = zip(*self.wall_argument.items(), strict=True)
        values = dict(zip(names, ca.vertsplit(law(ca.vertcat(*arguments))), strict=True))
        left, right = zip(*in_pairs(self.graph, values), strict=True)
        return ca.vertcat(*left), ca.vertcat(*right)

    def fluid_energy(self) -> SX:
        """Energy of walls and fluid, whose rate is the power of the inflow [J]."""
        energy = self.tube_energy
        syringes = [s.energies(self._is_stiff) for s in self.syringes.values()]
        energy += sum((own + cushion for own, cushion in syringes), SX(0))
        energy += ca.sum1(self.wall.energy(ca.vertcat(*self.wall_argument.values())))
        for name in (*self.pressure, *self.storing_nodes()):
            pressure = self.node_pressure(name)
            energy += pressure * (self.volume(name) - self.wall_volume(name))
            if not self._is_stiff:
                energy += self.stored(name) * self.fluid.specific_work(pressure)
                energy -= pressure * self.volume(name)
        return energy
