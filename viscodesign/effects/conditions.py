"""The numbers of a scene by which effects are weighed."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from viscodesign.model.coupling import BellowLaw
from viscodesign.model.graph import Component, Graph
from viscodesign.model.rod import Body
from viscodesign.physics import beam, bellow, timescales, tube
from viscodesign.scene.scene import Scene
from viscodesign.trajectory import Scales


@dataclass
class Conditions:
    """Stiffnesses, times and loads of a scene, and the effects taken so far."""

    scene: Scene
    taken: set[str] = field(default_factory=set)

    @property
    def accuracy(self) -> float:
        """Tip error asked for, in actuator lengths."""
        return self.scene.accuracy

    @cached_property
    def graph(self) -> Graph:
        """The network as a graph."""
        return self.scene.graph

    @cached_property
    def body(self) -> Body:
        """The actuator as a beam."""
        a = self.scene.actuator
        return Body(
            length=a.length,
            sections=self.scene.bellows.count // 2,
            bending_stiffness=beam.bending_stiffness(
                a.youngs_modulus, a.height, a.width, a.bending_factor
            ),
            extension_stiffness=beam.extension_stiffness(
                a.youngs_modulus, a.height, a.width, a.extension_factor
            ),
            mass_per_length=beam.mass_per_length(a.density, a.height, a.width, a.solid_fraction),
        )

    @cached_property
    def bellow(self) -> BellowLaw:
        """The linear laws of one bellow."""
        b, modulus = self.scene.bellows, self.scene.actuator.youngs_modulus
        rest = bellow.rest_volume(b.height, b.width, b.length)
        section = self.body.section_length
        return BellowLaw(
            length=b.length,
            rest_volume=rest,
            compliance=bellow.compliance(b.length, b.area_per_pressure),
            curvature_per_pressure=bellow.curvature_per_pressure(
                b.angle_per_pressure, modulus, section
            ),
            stretch_per_pressure=bellow.stretch_per_pressure(
                b.extension_per_pressure, modulus, section
            ),
            floor_volume=b.collapse_fraction * rest,
        )

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
            t_i=min((i.transient() for i in scene.inputs.values()), default=math.inf),
            t_net=max((self._network_time(c) for c in self.graph.components()), default=0.0),
        )

    def _viscous_elastic_time(self) -> float:
        tubes = self.graph.tubes
        if not tubes:
            return 0.0
        total = sum(t.length for t in tubes)
        # Tubes of several radii: the radius of an equal tube of the same total resistance.
        radius = (total / sum(t.length / t.radius**4 for t in tubes)) ** 0.25
        return timescales.viscous_elastic_time(
            self.scene.fluid.viscosity, self.scene.bellows.area_per_pressure, radius, total
        )

    def _network_time(self, component: Component) -> float:
        laplacian = self.laplacian(component)
        bellows, junctions = len(component.bellows), len(component.junctions)
        own, rest = laplacian[:bellows, :bellows], laplacian[bellows:, bellows:]
        if junctions:
            own = own - laplacian[:bellows, bellows:] @ np.linalg.solve(
                rest, laplacian[bellows:, :bellows]
            )
        compliance = np.full(bellows, self.bellow.compliance)
        return timescales.slowest_network_time(own, compliance, sealed=not component.fed)

    def laplacian(self, component: Component) -> np.ndarray:
        """Conductance matrix of a component's bellows, then junctions; inlets held [m3/(Pa s)]."""
        index = {n: k for k, n in enumerate((*component.bellows, *component.junctions))}
        matrix = np.zeros((len(index), len(index)))
        for t in component.tubes:
            conductance = 1 / self.resistances[t.name]
            ends = [index[end] for end in (t.start, t.end) if end in index]
            for end in ends:
                matrix[end, end] += conductance
            if len(ends) == 2:
                matrix[ends[0], ends[1]] -= conductance
                matrix[ends[1], ends[0]] -= conductance
        return matrix

    # -- loads ----------------------------------------------------------------

    @cached_property
    def inlet_samples(self) -> np.ndarray:
        """Gauge pressures of all inlets, sampled densely and at both sides of every corner [Pa]."""
        duration = self.scene.run.duration
        times = [np.linspace(0.0, duration, 2001)]
        for source in self.scene.inputs.values():
            corners = np.array(source.corners(duration))
            times += [corners, corners - 1e-9 * duration, corners + 1e-9 * duration]
        grid = np.clip(np.concatenate(times), 0.0, duration)
        baseline = self.scene.gauge_pressure
        samples = [baseline + source.pressure(grid) for source in self.scene.inputs.values()]
        return np.concatenate([*samples, [baseline]])

    @cached_property
    def swing(self) -> float:
        """Largest gauge pressure of any inlet over the run, in size [Pa]."""
        return float(np.max(np.abs(self.inlet_samples))) or 1.0

    @cached_property
    def pressure_range(self) -> float:
        """Between the lowest and the highest gauge pressure of all inlets [Pa]."""
        return float(np.ptp(self.inlet_samples))

    @cached_property
    def lowest_pressure(self) -> float:
        """Lowest gauge pressure of any inlet over the run [Pa]."""
        return float(np.min(self.inlet_samples))

    @property
    def tip_force(self) -> float:
        """Size of the stated tip force [N]."""
        force = self.scene.loads.tip_force
        return math.hypot(force.x, force.z)

    @property
    def weight_force(self) -> float:
        """Weight of body and payload [N]; zero where gravity is not taken."""
        gravity = self.scene.loads.gravity
        if gravity is None or "gravity" not in self.taken:
            return 0.0
        mass = self.body.mass_per_length * self.body.length + self.scene.loads.payload
        return mass * gravity.acceleration

    @property
    def inertial_force(self) -> float:
        """Mass times length over t_i squared [N]; zero where inertia is not taken."""
        if "inertia" not in self.taken:
            return 0.0
        mass = self.body.mass_per_length * self.body.length + self.scene.loads.payload
        shortest = max(self.scales.t_i, self.scales.t_s)
        return mass * self.body.length / shortest**2

    @property
    def suddenly_loaded(self) -> bool:
        """Whether loads meet a rod that was straight and at rest before."""
        return self.scene.run.start == "rest" and self.tip_force + self.weight_force > 0.0

    @property
    def load_force(self) -> float:
        """Everything that may load the rod, added up without regard to direction [N]."""
        return self.tip_force + self.weight_force + self.inertial_force
