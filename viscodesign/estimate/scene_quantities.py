"""The numbers of a scene by which effects are weighed."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence
from typing import Any, TypeVar

import numpy as np

from viscodesign.errors import UsageError, described
from viscodesign.estimate.motion_estimate import MotionEstimate
from viscodesign.estimate.network_estimate import NetworkEstimate
from viscodesign.estimate.network_matrix import laplacian, settling_time
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import BellowLaw, BellowLaws
from viscodesign.model.graph import Component, Graph
from viscodesign.model.rod import Body
from viscodesign.model.scene_number import Numbers, mean_of
from viscodesign.physics import beam, gas, timescales, tube
from viscodesign.results.findings import Scales
from viscodesign.scene.bellow_numbers import bellow_laws
from viscodesign.scene.body_numbers import body_of
from viscodesign.scene.inputs.syringe import SyringeInput
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

T = TypeVar("T")

SUDDEN_SHARE = 0.3
"""Swing of a rod that its weight meets at once, relative to the accuracy, that is negligible."""


@dataclass(frozen=True, eq=False)
class SceneQuantities:
    """Stiffnesses, times and loads of a scene: what follows from it alone, and never changes."""

    scene: Scene

    def __post_init__(self) -> None:
        # All that takes a scene begins here.
        if not isinstance(self.scene, Scene):
            given = described(self.scene)
            raise UsageError(f"expected a scene, such as load('leg.yaml') returns; got {given}")

    @cached_property
    def _memory(self) -> dict[Hashable, Any]:
        return {}

    def remembered(self, key: Hashable, make: Callable[[], T]) -> T:
        """What others made of these quantities alone for this key, or make now."""
        if key not in self._memory:
            self._memory[key] = make()
        found: T = self._memory[key]
        return found

    @property
    def accuracy(self) -> float:
        """Tip error asked for, in actuator lengths."""
        return self.scene.accuracy

    @property
    def requested_m(self) -> float:
        """The same as a length [m]."""
        return self.accuracy * self.body.length

    @cached_property
    def graph(self) -> Graph:
        """The network as a graph."""
        return self.scene.graph

    @cached_property
    def body(self) -> Body:
        """The actuator as a beam."""
        return body_of(self.scene)

    @cached_property
    def bellow(self) -> BellowLaw:
        """The linear laws of one bellow: the means of all."""
        return self.bellows.typical

    @cached_property
    def bellows(self) -> BellowLaws:
        """The linear laws of all bellows."""
        return bellow_laws(self.scene)

    def compliance_of(self, names: Sequence[str]) -> Numbers:
        """Volume per pressure of these bellows, one for all or of each [m3/Pa]."""
        each = self.bellows.compliance
        if not isinstance(each, np.ndarray):
            return each
        places = {name: k for k, name in enumerate(self.graph.bellows)}
        return np.asarray(each[[places[name] for name in names]])

    @cached_property
    def resistances(self) -> dict[str, float]:
        """Slow-flow resistance of every tube [Pa s/m3]."""
        viscosity = self.scene.fluid.viscosity
        return {
            t.name: tube.hydraulic_resistance(viscosity, t.length, t.radius)
            for t in self.graph.tubes
        }

    @cached_property
    def scales(self) -> Scales:
        """The four characteristic times."""
        scene, body = self.scene, self.body
        return Scales(
            t_s=beam.elastic_inertial_time(
                body.mass_per_length, body.length, body.bending_stiffness
            ),
            t_f=self._viscous_elastic_time(),
            t_i=min(
                (i.transient(scene.run.duration) for i in scene.inputs.values()), default=math.inf
            ),
            t_net=max((self._settling_time(c) for c in self.graph.components()), default=0.0),
        )

    @cached_property
    def filling_time(self) -> float:
        """Time in which the tube that resists most fills one bellow [s]."""
        return max(self.resistances.values(), default=0.0) * self.bellow.compliance

    @property
    def swing_time(self) -> float:
        """Shortest swing of any inlet's profile, at most the run; ignores a stated t_i [s]."""
        duration = self.scene.run.duration
        swings = (i.swing_time_within(duration) for i in self.scene.inputs.values())
        return min([*swings, duration])

    def _viscous_elastic_time(self) -> float:
        tubes = self.graph.tubes
        if not tubes:
            return 0.0
        total = sum(t.length for t in tubes)
        # Tubes of several radii: the radius of an equal tube of the same total resistance.
        radius = (total / sum(t.length / t.radius**4 for t in tubes)) ** 0.25
        return timescales.viscous_elastic_time(
            self.scene.fluid.viscosity,
            mean_of(self.scene.bellows.each("area_per_pressure")),
            radius,
            total,
        )

    def laplacian(self, component: Component) -> np.ndarray:
        """Conductance matrix of a component's bellows, then junctions [m3/(Pa s)]."""
        return laplacian(component, self.resistances)

    def _settling_time(self, component: Component) -> float:
        return settling_time(component, self.resistances, self.compliance_of(component.bellows))

    # -- loads ----------------------------------------------------------------

    @cached_property
    def _pressures_met(self) -> tuple[float, float]:
        """Lowest and highest gauge pressure of the baseline and of all inlets over the run [Pa]."""
        met = [self.scene.gauge_pressure, *self._inlet_pressures]
        return min(met), max(met)

    @cached_property
    def _inlet_pressures(self) -> list[float]:
        """Extremes of every inlet over the run, gauge [Pa]."""
        baseline, met = self.scene.gauge_pressure, []
        for name, source in self.scene.inputs.items():
            unit = 1.0 if source.gives_pressure else self._yield(name)
            met += [baseline + unit * value for value in source.extremes(self.scene.run.duration)]
        return met

    def _yield(self, name: str) -> float:
        """Pressure per volume that a plunger pushes into its closed network [Pa/m3]."""
        part = next(c for c in self.graph.components() if name in c.inlets)
        barrels = sum(self.barrel_compliance(n) for n in part.inlets if n in self.barrels)
        return 1 / (barrels + len(part.bellows) * self.bellow.compliance)

    @cached_property
    def barrels(self) -> dict[str, SyringeInput]:
        """Inlets that a plunger drives."""
        inputs = self.scene.inputs.items()
        return {name: source for name, source in inputs if isinstance(source, SyringeInput)}

    def barrel_compliance(self, name: str) -> float:
        """Volume per pressure of the fluid in a barrel at its start [m3/Pa]."""
        fluid, barrel = self.scene.fluid, self.barrels[name]
        absolute, volume = (
            self.scene.ambient_pressure + self.scene.gauge_pressure,
            barrel.full_volume,
        )
        if fluid.bulk_modulus is not None:
            cushion = gas.gas_compliance(barrel.cushion, absolute, 1.0)
            return (volume - barrel.cushion) / fluid.bulk_modulus + cushion
        return gas.gas_compliance(volume, absolute, fluid.polytropic_exponent)

    # -- estimates of the motion ------------------------------------------------

    @cached_property
    def bare_estimate(self) -> MotionEstimate:
        """The motion without any effect, for effects to add their terms to."""
        barrels = {name: self.barrel_compliance(name) for name in self.barrels}
        numbers = (self.body, self.bellows, self.resistances, barrels, self.swing)
        return MotionEstimate(EstimateSetting(self.scene, *numbers))

    @cached_property
    def slow_flows(self) -> np.ndarray:
        """Flows of all tubes that slow laminar flow would have (T, Q) [m3/s]."""
        return self._slow_network.flows()

    @property
    def first_flows(self) -> np.ndarray:
        """The same at the first instant, before and after a jump (n, Q) [m3/s]."""
        time = self.bare_estimate.setting.time
        return np.asarray(self.slow_flows[time == time[0]])

    @cached_property
    def slow_tube_pressures(self) -> np.ndarray:
        """Mean gauge pressures of all tubes in the same flow (T, Q) [Pa]."""
        return self._slow_network.tube_pressures()

    @cached_property
    def _slow_network(self) -> NetworkEstimate:
        return self.bare_estimate.plus(EstimateTerm(distributed=True)).network

    @property
    def swing(self) -> float:
        """Largest gauge pressure of any inlet over the run, in size [Pa]."""
        return max(abs(pressure) for pressure in self._pressures_met) or 1.0

    @property
    def pressure_range(self) -> float:
        """Between the lowest and the highest gauge pressure of all inlets [Pa]."""
        return self.highest_pressure - self.lowest_pressure

    @property
    def lowest_pressure(self) -> float:
        """Lowest gauge pressure of the baseline and of any inlet over the run [Pa]."""
        return self._pressures_met[0]

    @property
    def lowest_inlet_pressure(self) -> float:
        """Lowest gauge pressure of any inlet over the run, or the baseline without any [Pa]."""
        return min(self._inlet_pressures, default=self.scene.gauge_pressure)

    @property
    def highest_pressure(self) -> float:
        """Highest gauge pressure of the baseline and of any inlet over the run [Pa]."""
        return self._pressures_met[1]

    @property
    def tip_force(self) -> float:
        """Size of the stated tip force [N]."""
        force = self.scene.loads.tip_force
        return math.hypot(force.x, force.z)

    @property
    def solid_mass(self) -> float:
        """Mass of the body [kg]."""
        return self.body.mass_per_length * self.body.length

    @property
    def carried_mass(self) -> float:
        """Mass of body and payload [kg]."""
        return self.solid_mass + self.scene.loads.payload

    @property
    def acceleration(self) -> float:
        """Gravity that the scene states; zero without [m/s2]."""
        gravity = self.scene.loads.gravity
        return 0.0 if gravity is None else gravity.acceleration

    @property
    def weight(self) -> float:
        """Weight of body and payload [N]."""
        return self.carried_mass * self.acceleration

    @property
    def fluid_weight(self) -> float:
        """Weight of all the fluid that the bellows may come to hold [N]."""
        b, swelling = self.scene.bellows, self.bellow.compliance * max(self.highest_pressure, 0.0)
        longest = float(np.max(b.each("length")))
        swelling = max([swelling, *(longest * row[1] for c in b.curves for row in c.rows or ())])
        volume = len(self.graph.bellows) * (self.bellow.rest_volume + swelling)
        return self.scene.fluid.density * volume * self.acceleration

    @property
    def bending_force(self) -> float:
        """EI/l2, the scale of forces [N]."""
        return self.body.bending_stiffness / self.body.length**2

    @property
    def largest_turn(self) -> float:
        """Turn of a section with one bellow at the highest pressure, the other at the lowest
        [rad]."""
        turn = np.max(np.abs(self.bellows.curvature_per_pressure))
        per_pressure = float(turn) * self.body.section_length
        return self.pressure_range * per_pressure

    @property
    def suddenly_loaded(self) -> bool:
        """Whether loads meet a rod that was straight and at rest before."""
        if self.scene.run.start != "rest":
            return False
        return self.tip_force > 0.0 or self._largest_drop > SUDDEN_SHARE * self.requested_m

    @property
    def _largest_drop(self) -> float:
        """Bound of the tip's swing when the weight meets a straight rod at rest [m].

        Twice the static deflection, with all of the weight at the tip. An upright rod may topple.
        """
        gravity, body = self.scene.loads.gravity, self.body
        if gravity is None:
            return 0.0
        along, across = math.cos(gravity.tilt), abs(math.sin(gravity.tilt))
        bending = (1.0 if along < 0.0 else across) * body.length**3 / (3 * body.bending_stiffness)
        stretching = abs(along) * body.length / body.extension_stiffness
        return 2.0 * self.weight * (bending + stretching)

    @property
    def load_force(self) -> float:
        """Everything that may load the rod, added up without regard to direction [N]."""
        inertia = self.carried_mass * self.body.length / max(self.scales.t_i, self.scales.t_s) ** 2
        return self.tip_force + self.weight + inertia
