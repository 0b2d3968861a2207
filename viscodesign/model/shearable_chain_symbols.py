"""The planar, extensible, shearable rod (Simo and Reissner) as a chain of nodes.

Beside the nodes' positions, every edge has the mean angle phi of its cross sections. In their
frame, with t = (sin phi, cos phi) along and n = (cos phi, -sin phi) across, a chord d has

    stretch d.t / (h sinc(kappa h/2)),   shear d.n / (h sinc(kappa h/2)),

exact for strains that are constant along the edge. Curvatures are those of the cross sections, so
the turn at a node is a difference of these angles and never wraps; all else is as in the
unshearable chain.

Source: Reissner, On one-dimensional finite-strain beam theory: the plane problem, J. Appl. Math.
Phys. 23 (1972); in small deflections it is Timoshenko's beam.
"""

from __future__ import annotations

import casadi as ca

from viscodesign.model.chain_symbols import ChainSymbols
from viscodesign.model.rod import Body, RodParameters

SX = ca.SX

TIP_REACH = 1.5
"""Edges for which the last change of shear from edge to edge stands [1]."""


class ShearableChainSymbols(ChainSymbols):
    """Symbols, strains and energies of the chain with angles of its cross sections."""

    def __init__(self, body: Body, edges_per_section: int, parameters: RodParameters) -> None:
        assert parameters.shear_stiffness is not None
        edges = body.sections * edges_per_section
        self._angles = SX.sym("section_angle", edges)
        self._angle_rates = SX.sym("section_rate", edges)
        super().__init__(body, edges_per_section, parameters)
        self.shear_stiffness = parameters.shear_stiffness
        if not self.shear_stiffness.is_scalar():
            self.shear_stiffness = self._per_edge(self.shear_stiffness)

    @property
    def section_angles(self) -> SX:
        return self._angles

    @property
    def section_rates(self) -> SX:
        return self._angle_rates

    @property
    def strain_rates(self) -> SX:
        return SX(0, 1)  # turns are differences of angles: their force depends on rates alone

    @property
    def strain_rate_values(self) -> SX:
        return SX(0, 1)

    def _turns(self, chords: SX) -> SX:
        return self._angles - ca.vertcat(0, self._angles[:-1])

    def _edge_stretch(self, chords: SX, arc: SX) -> SX:
        self._along, self._across = _in_frame(chords, self._angles)
        self.shear = self._across / arc
        return self._along / arc

    def elastic_energies(self) -> list[SX]:
        # Along an edge shear is linear: its square is that of the mean, and a twelfth of that of
        # what it changes by. At the clamp, where nothing moves, it does not change.
        change = self._shear_change()
        reach = ca.vertcat(SX.ones(self.edges - 1), TIP_REACH)
        square = self.shear**2 + reach * change**2 / 12
        shearing = self.shear_stiffness * self.h * square / 2
        own = ca.vertsplit(shearing)
        return [a + b for a, b in zip(super().elastic_energies(), own, strict=True)]

    def _shear_change(self) -> SX:
        """How much the shear of every edge differs from what the one before would have (edges,).

        What changes smoothly where sections differ is the force.
        """
        if self.shear_stiffness.is_scalar():
            return self.shear - ca.vertcat(self.shear[0], self.shear[:-1])
        force = self.shear_stiffness * self.shear
        return (force - ca.vertcat(force[0], force[:-1])) / self.shear_stiffness

    def dissipation_powers(self, time: SX) -> list[SX]:
        at = ca.vertcat(self.coordinates, self._angles)
        along = ca.vertcat(self.rates, self._angle_rates)
        stretch, shear = (
            ca.jtimes(part / self.h, at, along) for part in (self._along, self._across)
        )
        bending = self._angle_rates - ca.vertcat(0, self._angle_rates[:-1])
        drawn = self.extension_stiffness / self.extension_softness * self.h * stretch**2
        power = drawn + self.shear_stiffness * self.h * shear**2
        bent = self.bending_stiffness * bending**2 / self.tributary_lengths
        if time.is_scalar():
            return ca.vertsplit(time * (power + bent))
        edges = self._per_edge(time)
        return ca.vertsplit(edges * power + self._retarded(edges) * bent)

    def rotary_energies(self, inertia_per_length: SX) -> list[SX]:
        inertia = self._per_edge(inertia_per_length) * self.h
        return ca.vertsplit(inertia * self._angle_rates**2 / 2)

    def outputs(self) -> dict[str, SX]:
        return super().outputs() | {"shear_angle": ca.atan2(self._across, self._along)}


def _in_frame(chords: SX, angles: SX) -> tuple[SX, SX]:
    """Parts of the chords (2, n) along and across their cross sections' normals, each (n,)."""
    x, z = chords[0, :].T, chords[1, :].T
    sin, cos = ca.sin(angles), ca.cos(angles)
    return x * sin + z * cos, x * cos - z * sin
