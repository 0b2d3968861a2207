"""The planar, extensible, unshearable rod as a chain of nodes.

Nodes carry positions (x, z), so the intrinsic strain of a section may jump in
arc length and change in time without any derivative of the pressure. Between
two nodes the axis is nearly an arc, and two relations connect the nodes with
the strains of the smooth rod, each exact for piecewise constant strain and
accurate to higher order for smoothly varying strain:

- **Turning.** The direction of a chord is the mean of the tangent's angle over
  its edge, so the turn at a node is the integral of the curvature against the
  hat function of that node. With the elastic curvature c linear between nodes,
  turn - rest turn = W c, where W is the mass matrix of the hats,
  h [1/3 1/6; 1/6 2/3 1/6; ...]. At the clamp only half of the first edge turns;
  at the free tip c = 0.
- **Length.** An edge of stretch lambda is the chord of an arc,
  h lambda sinc(kappa h / 2), with the edge's own total curvature kappa.

Where sections differ, c is the moment over the stiffness EI of a uniform rod. It is continuous;
the curvature of an edge is c times its softness, EI over its own stiffness, and stands in the
place of c in both relations.

The moment E I c is an unknown of its own: the system stays sparse, the number of
operations linear in the number of edges. So is the axial force E A tau of every edge, with
its elastic stretch tau: within a step of an integrator nodes move straight, which stretches
an edge that turns, and a stiff axis would answer that with a large force.
Where a rod with mass is damped, so is the rate k of every node's curvature, whose power is
EI h (2 k dkappa/dt - k^2) times the retardation time: how its force depends on the places is as
stiff as the mesh is fine, and the steps of a linearly implicit method would be as short. Without
load the chain lies exactly on the arcs for any number of edges.
"""

from __future__ import annotations

import casadi as ca

from viscodesign.model.node_masses import node_masses, node_weights
from viscodesign.model.rod import Body, PointMass, RodParameters, RodSymbols, Softness

SX = ca.SX


class ChainSymbols(RodSymbols):
    """Symbols, strains and energies of a chain of ``edges_per_section`` edges a section."""

    def __init__(self, body: Body, edges_per_section: int, parameters: RodParameters) -> None:
        super().__init__(parameters)
        self.body = body
        self.edges = body.sections * edges_per_section
        self.edges_per_section = edges_per_section
        self.h = parameters.section_length / edges_per_section
        self.section_length = self.h * edges_per_section
        self.position = SX.sym("position", 2, self.edges)
        self.velocity = SX.sym("velocity", 2, self.edges)
        self.elastic_curvature = SX.sym("elastic_curvature", self.edges)
        self.axial_strain = SX.sym("axial_strain", self.edges)
        self.coordinates = ca.vec(self.position)
        self.rates = ca.vec(self.velocity)
        self.internal = ca.vertcat(self.elastic_curvature, self.axial_strain)
        self.curvature_rate = SX.sym("curvature_rate", self.edges)
        self.coordinate_size = parameters.length
        self._length = parameters.length
        self._soften(parameters.softness)
        self.intrinsic_curvature = SX.sym("intrinsic_curvature", body.sections)
        self.intrinsic_stretch = SX.sym("intrinsic_stretch", body.sections)
        moment = parameters.tip_moment
        self.tip_moment = SX.sym("tip_moment") if moment is None else moment
        mass = parameters.mass_per_length
        self._masses: list[PointMass] = []
        if mass.is_scalar():
            each = [mass * self.h * weight for weight in node_weights(self.edges)]
            self._hang(each)
        else:
            self._hang(node_masses(ca.vertsplit(self._per_edge(mass) * self.h)))
        self._measure_strains()

    # -- what effects may use -------------------------------------------------

    @property
    def tip(self) -> SX:
        return self.position[:, -1]

    @property
    def tip_angle(self) -> SX:
        return self.node_angles()[-1]

    @property
    def section_ends(self) -> list[SX]:
        every = self.edges_per_section
        return [self.position[:, k] for k in range(every - 1, self.edges, every)]

    def tip_turns(self) -> list[SX]:
        return ca.vertsplit(self.turns)

    @property
    def force_size(self) -> SX:
        return self.bending_stiffness / self._length**2

    @property
    def internal_size(self) -> SX:
        every = SX.ones(self.edges)
        return ca.vertcat(every / self._length, every * self.force_size / self.extension_stiffness)

    @property
    def internal_scale(self) -> SX:
        every = SX.ones(self.edges)
        return ca.vertcat(
            every * self.edges / self.bending_stiffness, every / (self.h * self.force_size)
        )

    def masses(self) -> list[PointMass]:
        return list(self._masses)

    def add_tip_mass(self, mass: SX) -> None:
        self._masses.append(PointMass(mass, self.tip, self.velocity[:, -1]))

    def add_carried_mass(self, per_section: list[SX]) -> None:
        count = self.edges_per_section
        per_edge = [mass / count for mass in per_section for _ in range(count)]
        around = [*per_edge, per_edge[-1]]
        weights = node_weights(self.edges)
        self._hang([w * (around[i] + around[i + 1]) / 2 for i, w in enumerate(weights)])

    def _hang(self, per_node: list[SX]) -> None:
        for i, mass in enumerate(per_node):
            self._masses.append(PointMass(mass, self.position[:, i], self.velocity[:, i]))

    def dissipation_powers(self, time: SX) -> list[SX]:
        # The shortening of a chord that merely bends, of order (kappa h)^2, is left in the stretch.
        r, v = self.coordinates, self.rates
        stretch_rate = ca.jtimes(self.chord_lengths / self.h, r, v)
        extension = self.extension_stiffness / self.extension_softness * self.h * stretch_rate**2
        rate = self.curvature_rate
        bending = (
            self.bending_stiffness
            * self.tributary_lengths
            * rate
            * (2 * self.strain_rate_values - rate)
        )
        if time.is_scalar():
            return ca.vertsplit(time * (extension + bending))
        edges = self._per_edge(time)
        return ca.vertsplit(edges * extension + self._retarded(edges) * bending)

    @property
    def strain_rates(self) -> SX:
        return self.curvature_rate

    @property
    def strain_rate_values(self) -> SX:
        return ca.jtimes(self.turns / self.tributary_lengths, self.coordinates, self.rates)

    def _retarded(self, time: SX) -> SX:
        """Mean of the retardation times (edges,) of the edges about every node's turn [s]."""
        soft = time * self.bending_softness
        return self.h * _about_nodes(soft) / self.tributary_lengths

    def rotary_energies(self, inertia_per_length: SX) -> list[SX]:
        inertia = ca.vertsplit(self._per_edge(inertia_per_length) * self.h)
        rates = self._edge_turn_rates()
        # Along an edge the rate changes by half of what its neighbours differ by; the clamp
        # mirrors it, and the free tip bends no further.
        around = [-rates[0], *rates, rates[-1]]
        return [
            own * (rate**2 + (after - before) ** 2 / 48) / 2
            for own, before, rate, after in zip(inertia, around, rates, around[2:], strict=False)
        ]

    def _edge_turn_rates(self) -> list[SX]:
        """Rate at which each edge turns (edges,) [rad/s]."""
        clamp = SX.zeros(2, 1)
        chords = ca.diff(ca.horzcat(clamp, self.position), 1, 1)
        rates = ca.diff(ca.horzcat(clamp, self.velocity), 1, 1)
        turned = chords[1, :] * rates[0, :] - chords[0, :] * rates[1, :]
        return ca.horzsplit(turned / (chords[0, :] ** 2 + chords[1, :] ** 2))

    @property
    def tip_curvature(self) -> SX:
        """Elastic curvature at the tip [1/m], caused by the moment applied there."""
        return self.tip_moment / self.bending_stiffness

    @property
    def tributary_lengths(self) -> SX:
        """Reference length that each node's turn is spread over: h/2 at the clamp, else h.

        Where sections differ, that of the uniform rod which turns as much under the moment there.
        """
        if self._is_uniform:
            return self.h * ca.vertcat(0.5, SX.ones(self.edges - 1))
        return self.h * _about_nodes(self.bending_softness)

    def _soften(self, softness: Softness | None) -> None:
        """Note how much softer than the uniform rod every edge is (edges,) [1]."""
        self._is_uniform = softness is None
        one = SX.ones(self.edges)
        self.bending_softness = one if softness is None else self._per_edge(softness.bending)
        self.extension_softness = one if softness is None else self._per_edge(softness.extension)

    # -- kinematics -----------------------------------------------------------

    def _measure_strains(self) -> None:
        nodes = ca.horzcat(SX.zeros(2, 1), self.position)
        chords = nodes[:, 1:] - nodes[:, :-1]
        self.chord_lengths = ca.sqrt(chords[0, :] ** 2 + chords[1, :] ** 2).T
        self.turns = self._turns(chords)
        kappa = self._per_edge(self.intrinsic_curvature)
        zeta = self._per_edge(self.intrinsic_stretch)
        rest = ca.vertcat(kappa[0] * self.h / 2, (kappa[:-1] + kappa[1:]) * self.h / 2)
        measured = ca.vertcat((self.turns - rest) / self.tributary_lengths, self.tip_curvature)
        edge_curvature = kappa + self.bending_softness * (measured[:-1] + measured[1:]) / 2
        self.stretch = self._edge_stretch(chords, self.h * _sinc(edge_curvature * self.h / 2))
        self.elastic_stretch = self.stretch - 1 - zeta
        self.elastic_turns = self.turns - rest
        self._kappa = kappa

    def _turns(self, chords: SX) -> SX:
        """Turn at nodes 0..edges-1 (edges,) [rad]; the clamp's is measured from +z."""
        return _turns_of(chords)

    def _edge_stretch(self, chords: SX, arc: SX) -> SX:
        """Stretch of every edge (edges,) [1]; ``arc``: chords of the unstretched arcs [m]."""
        del chords
        return self.chord_lengths / arc

    def _per_edge(self, per_section: SX) -> SX:
        """Values of sections, one for all or (S,), as those of their edges (edges,)."""
        if per_section.is_scalar() and self.body.sections > 1:
            return ca.repmat(per_section, self.edges, 1)
        return ca.vertcat(
            *(
                per_section[j]
                for j in range(self.body.sections)
                for _ in range(self.edges_per_section)
            )
        )

    def node_angles(self) -> SX:
        """Angle of the tangent at nodes 1..edges (edges,) [rad], from +z, never wrapped."""
        c = ca.vertcat(self.elastic_curvature, self.tip_curvature)
        chord_angles = ca.cumsum(self.turns)
        elastic = self.bending_softness * (c[:-1] / 6 + c[1:] / 3)
        return chord_angles + self._kappa * self.h / 2 + self.h * elastic

    # -- energy ---------------------------------------------------------------

    def elastic_energies(self) -> list[SX]:
        # Where their sum is stationary, it is the stored elastic energy.
        c, tau = self.elastic_curvature, self.axial_strain
        # Along an edge the curvature is linear. That of the tip is given: its product with the
        # last node's counts, its square does not.
        after = ca.vertcat(c[1:], self.tip_curvature)
        square = self.bending_softness * (c**2 + c * after + ca.vertcat(c[1:], 0) ** 2)
        bending = self.bending_stiffness * (c * self.elastic_turns - self.h / 6 * square)
        bending[-1] -= self.tip_moment * self._kappa[-1] * self.h / 2
        drawn = self.extension_softness * tau / 2
        extension = self.extension_stiffness * self.h * tau * (self.elastic_stretch - drawn)
        return ca.vertsplit(bending + extension)

    def stored_energies(self) -> list[SX]:
        # What the moment at the tip stores in the last edge, which turns the tip beyond the node.
        moment, soft = self.tip_moment, self.bending_softness[-1]
        beyond = soft * (self.elastic_curvature[-1] + self.tip_curvature) / 6 + self._kappa[-1] / 2
        return [*self.elastic_energies(), moment * self.h * beyond]

    def outputs(self) -> dict[str, SX]:
        return {
            "position": self.coordinates,
            "angle": self.node_angles(),
            "stretch": self.stretch,
        }


def _about_nodes(per_edge: SX) -> SX:
    """Half of what the edges before and after each of the nodes 0..edges-1 have (edges,)."""
    return (ca.vertcat(0, per_edge[:-1]) + per_edge) / 2


def _turns_of(chords: SX) -> SX:
    """Turns of successive chords (edges,) [rad]."""
    x, z = chords[0, :].T, chords[1, :].T
    x_before, z_before = ca.vertcat(0, x[:-1]), ca.vertcat(1, z[:-1])
    return ca.atan2(x * z_before - z * x_before, x * x_before + z * z_before)


def _sinc(u: SX) -> SX:
    """sin(u)/u by its series in u^2: smooth at zero, error below 2e-12 for |u| <= 0.7."""
    square = u * u
    value = SX.ones(u.shape)
    for n in range(5, 0, -1):
        value = 1 - square / ((2 * n) * (2 * n + 1)) * value
    return value
