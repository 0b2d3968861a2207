"""A sketch of the motion: good to tens of percent, and made in milliseconds.

It answers one question: how far does the tip move when a term is added or taken away?
Linear throughout, each part exact or a known first estimate:

- the network is a linear one, solved mode by mode for the input as it is; what is not
  linear (gas, collapse, turbulence) enters by its mean over the motion;
- the shape is the row of arcs that the pressures ask for; loads bend it further by the
  moments that they have about it;
- inertial forces are those of the first bending mode and the first stretching mode.

An effect changes the numbers of a sketch as it would change the balances; which effects
there are, the sketch does not know.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.estimate.linear_network import LinearNetwork, UniformNetwork
from viscodesign.estimate.modal_response import first_order, second_order
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.physics.gas import density_ratio

if TYPE_CHECKING:
    from viscodesign.estimate.setting import Ground

BendingLaw = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray, np.ndarray]]
"""Gauge pressures -> volume beyond rest [m3], curvature [1/m] and stretch [1] of each."""

FIRST_BENDING = 3.5160
"""First root of a clamped-free beam, squared: its angular frequency times t_s."""
EFFECTIVE_MASS = 3 / FIRST_BENDING**2
"""Of the beam's mass, what a mass at its tip would need to swing alike."""
MODE_SLOPE = 4.648
"""Integral of the first mode's squared slope over that of the mode squared, times l^2."""
UNDAMPED_MODES = 10.0
"""By how much turning counts more where nothing calms the higher modes: the second has the phase
shifted 43 times as fast by it as the first, and up to a quarter of its amplitude."""
LARGEST_TURN = 3.0
"""Turn by which a load may bend one piece in a sketch [rad]."""
SETTLING_ROUNDS = 6
"""Rounds in which means over the motion settle, to a few thousandths."""
LOAD_ROUNDS = 2
SMALLEST_STRETCH = 0.05


@dataclass(frozen=True)
class Shape:
    """The axis as K pieces of arc at T samples."""

    nodes: np.ndarray
    """(T, K, 2) ends of the pieces [m]."""
    middle: np.ndarray
    """(T, K, 2) middles of their chords [m]."""
    direction: np.ndarray
    """(T, K, 2) unit tangents at the middles."""
    stretch: np.ndarray
    """(T, K)"""
    bent: np.ndarray
    """(T, K) curvature by loads [1/m]."""
    drawn: np.ndarray
    """(T, K) stretch by loads [1]."""


@dataclass(frozen=True)
class Sketch:
    """One set of terms, and the motion that follows from it."""

    ground: Ground
    uniform: bool = True
    """Whether every connected network has one pressure."""
    wall: BendingLaw | None = None
    """None for the linear law."""
    gas_exponent: float | None = None
    """Polytropic exponent of a gas that yields in the bellows."""
    capacity: tuple[tuple[str, float], ...] = ()
    """What tubes store per pressure, by node [m3/Pa]."""
    loss: Callable[[np.ndarray], np.ndarray] | None = None
    """Flows (T, Q) -> loss over that of slow laminar flow (T, Q)."""
    inertances: tuple[float, ...] = ()
    """Pressure per rate of flow of the tubes, where that counts [kg/m4]."""
    gravity: tuple[float, float] = (0.0, 0.0)
    tip_force: tuple[float, float] = (0.0, 0.0)
    mass_per_length: float = 0.0
    fluid_density: float = 0.0
    """Of a fluid whose mass counts [kg/m3]."""
    payload: float = 0.0
    moving: bool = False
    """Whether masses resist acceleration."""
    gyration: float = 0.0
    """Radius of gyration of the cross section where its turning resists as well [m]."""
    damping_time: float = 0.0
    volume_per_force: float = 0.0
    volume_per_moment: float = 0.0

    # -- network --------------------------------------------------------------

    @property
    def pressure(self) -> np.ndarray:
        """Gauge pressures of all bellows without feedback (T, B) [Pa]."""
        return self._network[1]

    @property
    def _network(self) -> tuple[LinearNetwork | UniformNetwork, np.ndarray]:
        """The network with its means over the motion, and its pressures."""
        return self.ground.remembered(self._network_key(), self._settle)

    def _network_key(self) -> tuple[object, ...]:
        """What the pressures depend on."""
        law = (self.uniform, self.wall, self.gas_exponent)
        return (*law, self.capacity, self.loss, self.inertances)

    def _settle(self) -> tuple[LinearNetwork | UniformNetwork, np.ndarray]:
        """Means over the motion follow from it, and it from them.

        Always the same number of rounds from the same start: what is left of the
        iteration is then alike in two sketches, and their difference shows the term.
        """
        ground = self.ground
        compliance = np.full(ground.bellows, ground.compliance)
        multiplier = np.ones(len(ground.resistance))
        network = self._linear(compliance, multiplier)
        pressure = network.pressures()
        for _ in range(SETTLING_ROUNDS if self._depends_on_motion() else 0):
            thinness = np.ones(len(multiplier))
            if isinstance(network, LinearNetwork):
                flow = network.flows(pressure)
                if self.loss is not None:
                    multiplier = np.sqrt(multiplier * _at_work(self.loss(flow), flow, ground.time))
                if self.gas_exponent is not None:
                    thinness = self._thinness(network.tube_pressures(pressure), flow)
            compliance = self._mean_compliance(pressure[:, : ground.bellows])
            network = self._linear(compliance, multiplier * thinness)
            pressure = network.pressures()
        return network, pressure[:, : ground.bellows]

    def _thinness(self, pressure: np.ndarray, flow: np.ndarray) -> np.ndarray:
        """Mean density of a gas in all tubes over that in each (Q,).

        In a row of tubes the thinner gas flows faster, and loses more of the pressure.
        """
        ground = self.ground
        assert self.gas_exponent is not None
        absolute = self._absolute(pressure)
        told = density_ratio(absolute - ground.ambient, ground.ambient, self.gas_exponent)
        density = _at_work(np.asarray(told), flow, ground.time)
        return np.asarray(np.mean(density) / density)

    def _absolute(self, pressure: np.ndarray) -> np.ndarray:
        """Absolute pressures; a linear network knows no vacuum [Pa]."""
        ambient = self.ground.ambient
        return np.maximum(ambient + pressure, 0.02 * ambient)

    def flows(self) -> np.ndarray:
        """Flows of all tubes (T, Q) [m3/s]."""
        network, _ = self._network
        return network.flows(network.pressures())

    def _depends_on_motion(self) -> bool:
        return self.wall is not None or self.gas_exponent is not None or self.loss is not None

    def _linear(
        self, compliance: np.ndarray, multiplier: np.ndarray
    ) -> LinearNetwork | UniformNetwork:
        inertance = np.array(self.inertances)
        return self.ground.network(
            compliance, multiplier, dict(self.capacity), inertance, self.uniform
        )

    def _mean_compliance(self, pressure: np.ndarray) -> np.ndarray:
        """Volume per pressure of every bellow, over the pressures that it meets (B,)."""
        ground = self.ground
        low, high = pressure.min(axis=0), pressure.max(axis=0)
        spread = np.maximum(high - low, 1e-3 * ground.swing)
        middle = (low + high) / 2
        ends = [self._law(middle + side * spread / 2)[0] for side in (-1, 1)]
        stored = np.maximum((ends[1] - ends[0]) / spread, 1e-3 * ground.compliance)
        volume = ground.rest_volume + self._law(pressure)[0]
        if self.gas_exponent is not None:
            absolute = self._absolute(pressure)
            volume = np.maximum(volume, 0.02 * ground.rest_volume)
            moved = np.abs(np.diff(pressure, axis=0)) + 1e-9 * ground.swing
            own = (volume / (self.gas_exponent * absolute))[1:]
            stored = stored + np.sum(own * moved, axis=0) / np.sum(moved, axis=0)
        return np.asarray(stored)

    # -- shape ----------------------------------------------------------------

    def _law(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch that each bellow has at its pressure."""
        if self.wall is not None:
            return self.wall(pressure)
        ground = self.ground
        return (
            ground.compliance * pressure,
            ground.curvature * pressure,
            ground.stretch * pressure,
        )

    def _strains(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch of every section (T, S)."""
        _, bend, extend = self._law(pressure)
        right, left = np.split(bend, 2, axis=1)
        return left - right, sum(np.split(extend, 2, axis=1), np.zeros_like(left))

    def _loaded(self, pressure: np.ndarray, taken: np.ndarray | None = None) -> Shape:
        """The axis under the steady loads; ``taken`` (T, B) volumes that the rod takes up."""
        ground = self.ground
        curvature, stretch = (s @ ground.spread.T for s in self._strains(pressure))
        length = ground.length / ground.pieces
        force = self._masses(pressure, taken)[..., None] * np.array(self.gravity)
        force[:, -1] += self.tip_force
        shape = _shape(curvature, 1 + stretch, length)
        for _ in range(LOAD_ROUNDS if np.any(force) else 0):
            bent, drawn = self._elastic(shape, force)
            shape = _shape(curvature + bent, 1 + stretch + drawn, length)
            shape = replace(shape, bent=bent, drawn=drawn)
        return shape

    def _masses(self, pressure: np.ndarray, taken: np.ndarray | None = None) -> np.ndarray:
        """Masses at the ends of the pieces (T or 1, K) [kg]."""
        ground = self.ground
        mass = np.full(ground.pieces, self.mass_per_length * ground.length / ground.pieces)
        mass[-1] = mass[-1] / 2 + self.payload
        return mass + self._held(pressure, taken) if self.fluid_density else mass[None]

    def _held(self, pressure: np.ndarray, taken: np.ndarray | None = None) -> np.ndarray:
        """Mass of the fluid in every piece (T, K) [kg]."""
        ground = self.ground
        volume = ground.rest_volume + self._law(pressure)[0]
        amount = np.maximum(volume if taken is None else volume + taken, 0.0)
        if self.gas_exponent is not None:
            amount *= density_ratio(pressure, ground.ambient, self.gas_exponent)
        per_section = sum(np.split(amount, 2, axis=1), np.zeros((1, 1)))
        return np.asarray(self.fluid_density * per_section @ ground.share.T)

    @cached_property
    def _carried(self) -> float:
        """Mass that is spread along the rod, the fluid's by its mean over the motion [kg]."""
        held = self._held(self.pressure) if self.fluid_density else np.zeros((1, 1))
        mean = float(np.mean(np.sum(held, axis=1)))
        return self.mass_per_length * self.ground.length + mean

    def _elastic(self, shape: Shape, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch that forces (T, K, 2) beyond each piece ask for (T, K)."""
        ground, middle, nodes = self.ground, shape.middle, shape.nodes
        carried = _beyond(force)
        torque = _beyond(nodes[..., 1] * force[..., 0] - nodes[..., 0] * force[..., 1])
        moment = torque - (middle[..., 1] * carried[..., 0] - middle[..., 0] * carried[..., 1])
        normal = np.sum(shape.direction * carried, axis=-1)
        length = ground.length / nodes.shape[1]
        turn = np.clip(moment / ground.bending_stiffness * length, -LARGEST_TURN, LARGEST_TURN)
        return turn / length, normal / ground.extension_stiffness

    # -- motion ---------------------------------------------------------------

    @cached_property
    def tip(self) -> np.ndarray:
        """The tip at every sample (T, 2) [m]."""
        heavy = self.fluid_density * math.hypot(*self.gravity)
        masses = (self.mass_per_length, self.fluid_density, self.payload)
        loads = (self.gravity, self.tip_force, *masses)
        shape = self.ground.remembered(
            (*self._network_key(), *loads), lambda: self._loaded(self.pressure)
        )
        tip, moved = self._followed(shape)
        if heavy or self.volume_per_force or self.volume_per_moment:
            taken = self._taken(moved)
            tip, _ = self._followed(self._loaded(self._answered(moved, taken), taken))
        return tip

    def _followed(self, shape: Shape) -> tuple[np.ndarray, Shape]:
        """Tip, and the axis with the elastic strains that loads and inertia give it."""
        tip = shape.nodes[:, -1]
        if not self.moving:
            if self.damping_time > 0.0:
                tip = tip + self._late(tip)
            return tip, shape
        # Inertial forces: of the first mode they are its stiffness times what it lags.
        rate = self._bending_rate()
        lag = self._lag(shape.nodes, rate, self.ground.straight)
        inert = self._masses(self.pressure)[..., None] * rate**2 * lag
        bent, drawn = self._elastic(shape, inert)
        moved = self._moved(shape, bent, drawn) + self._stretched(shape)
        return tip + moved, replace(shape, bent=shape.bent + bent, drawn=shape.drawn + drawn)

    def _moved(self, shape: Shape, bent: np.ndarray, drawn: np.ndarray) -> np.ndarray:
        """How far small strains of the pieces move the tip (T, 2)."""
        length = self.ground.length / bent.shape[1]
        arm = shape.nodes[:, -1:, :] - shape.middle
        turned = np.stack((arm[..., 1], -arm[..., 0]), axis=-1)
        parts = bent[..., None] * turned + drawn[..., None] * shape.direction
        limit = self.ground.length
        return np.asarray(np.clip(np.sum(parts, axis=1) * length, -limit, limit))

    def _stretched(self, shape: Shape) -> np.ndarray:
        """How far the first stretching mode moves the tip from its length (T, 2)."""
        extended = shape.stretch.mean(axis=1, keepdims=True) * self.ground.length
        lag = self._lag(extended, self._axial_rate(), np.array([self.ground.length]))
        chord = shape.nodes[:, -1]
        size = np.maximum(np.hypot(chord[:, :1], chord[:, 1:]), 1e-3 * self.ground.length)
        return np.asarray(lag * chord / size)

    def _lag(self, path: np.ndarray, rate: float, rest: np.ndarray) -> np.ndarray:
        """How far a mode departs from paths (T, ...) that it is asked to follow."""
        ground = self.ground
        asked = (path - rest).reshape(len(path), -1)
        # y'' / rate^2 + damping y' + y = asked, divided by the damping time.
        damping = max(self.damping_time, 1e-9 / rate)
        ones = np.ones(asked.shape[1])
        followed = second_order(
            ones / (rate**2 * damping),
            ones / damping,
            ground.time,
            asked / damping,
            ground.starts_steady,
        )
        return np.asarray(followed - asked).reshape(path.shape)

    def _late(self, path: np.ndarray) -> np.ndarray:
        """How far a massless damped rod lags behind a path (T, M)."""
        ground, time = self.ground, self.damping_time
        asked = path - ground.straight[-1]
        start = asked[0] if ground.starts_steady else 0 * asked[0]
        rates = np.full(asked.shape[1], -1 / time)
        return np.asarray(first_order(rates, ground.time, asked / time, start) - asked)

    def _bending_rate(self) -> float:
        """Angular frequency of the first bending mode, with payload and turning [1/s]."""
        length = self.ground.length
        slope = MODE_SLOPE * (1.0 if self.damping_time else UNDAMPED_MODES)
        carried = EFFECTIVE_MASS * self._carried * (1 + slope * (self.gyration / length) ** 2)
        stiffness = 3 * self.ground.bending_stiffness / length**3
        return math.sqrt(stiffness / (carried + self.payload))

    def _axial_rate(self) -> float:
        """The same of the first stretching mode."""
        mass = 4 / math.pi**2 * self._carried + self.payload
        return math.sqrt(self.ground.extension_stiffness / self.ground.length / mass)

    def _taken(self, shape: Shape) -> np.ndarray:
        """Volumes that the forces in the axis give the bellows (T, B) [m3]."""
        ground = self.ground
        moment = ground.bending_stiffness * shape.bent @ ground.share
        normal = ground.extension_stiffness * shape.drawn @ ground.share
        force, turn = self.volume_per_force * normal, self.volume_per_moment * moment
        return np.concatenate([force - turn, force + turn], axis=1)

    def _answered(self, shape: Shape, taken: np.ndarray) -> np.ndarray:
        """Pressures with what the axis does to the fluid: volumes taken up, height (T, B)."""
        ground = self.ground
        depth = (shape.middle @ np.array(self.gravity)) @ ground.share
        head = self.fluid_density * np.concatenate([depth, depth], axis=1)
        return self._network[0].pressures(taken, head)[:, : ground.bellows]

    # -- what it is for -------------------------------------------------------

    def distance(self, other: Sketch) -> float:
        """Largest distance of the two tips over the output times [m]."""
        apart = (self.tip - other.tip)[self.ground.told]
        found = float(np.max(np.hypot(apart[:, 0], apart[:, 1])))
        return found if math.isfinite(found) else math.inf

    def with_(self, **changes: object) -> Sketch:
        """The same with other numbers."""
        return replace(self, **changes)  # type: ignore[arg-type]


def _at_work(values: np.ndarray, flow: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Means (Q,) of values (T, Q) over the motion, weighed by the work that slow flow takes."""
    # A jump's first instant would count for a whole step: the later end stands for it.
    work = flow[1:] ** 2 * np.diff(time)[:, None] + 1e-300
    return np.asarray(np.sum(values[1:] * work, axis=0) / np.sum(work, axis=0))


def _shape(curvature: np.ndarray, stretch: np.ndarray, length: float) -> Shape:
    """The axis of pieces with these total strains (T, K), without loads."""
    stretch = np.maximum(stretch, SMALLEST_STRETCH)
    nodes, angles = arc_nodes(curvature, stretch, length, 1)
    ends = np.concatenate([np.zeros((len(nodes), 1, 2)), nodes], axis=1)
    turned = angles - curvature * length / 2
    return Shape(
        nodes=nodes,
        middle=(ends[:, 1:] + ends[:, :-1]) / 2,
        direction=np.stack((np.sin(turned), np.cos(turned)), axis=-1),
        stretch=stretch,
        bent=np.zeros_like(curvature),
        drawn=np.zeros_like(stretch),
    )


def _beyond(values: np.ndarray) -> np.ndarray:
    """Sums from each piece to the tip, along the second axis."""
    return np.asarray(np.cumsum(values[:, ::-1], axis=1)[:, ::-1])
