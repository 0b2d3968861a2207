"""The rod's part of the equations, in the simplest form that carries what acts on it."""

from __future__ import annotations

from enum import Enum

import casadi as ca

from viscodesign.model.system import System
from viscodesign.model.unknowns import SizeSymbols, Unknowns, column, substitute

SX = ca.SX


class RodForm(Enum):
    """How the rod enters the equations."""

    ARCS = "closed-form arcs"
    STATIC = "static rod"
    DAMPED = "massless damped rod"
    DYNAMIC = "dynamic rod"


MOVING = (RodForm.DYNAMIC, RodForm.DAMPED)


def rod_form(system: System) -> RodForm:
    """The simplest rod that carries everything that was added to the system."""
    if not system.kinetic_energy.is_zero():
        return RodForm.DYNAMIC
    if not system.dissipation_power.is_zero():
        return RodForm.DAMPED
    loaded = not (system.load_potential.is_zero() and system.tip_moment.is_zero())
    return RodForm.STATIC if loaded else RodForm.ARCS


class RodEquations:
    """Unknowns, balances and outputs of the rod."""

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.sizes = sizes
        self.form = rod_form(system)
        self.length = system.parameter("length", system.body.length)
        self.acceleration = SX.sym("acceleration", *system.rod.velocity.shape)
        self.coupled = self.form is RodForm.DYNAMIC and not self._masses_stand_alone()

    def _masses_stand_alone(self) -> bool:
        """Whether every node's momentum is a constant times its own velocity."""
        velocity = ca.vec(self.system.rod.velocity)
        mass = self._mass_matrix()
        free = not ca.depends_on(mass, ca.veccat(velocity, self.system.rod.position))
        return mass.sparsity().is_diag() and free

    def _momentum(self) -> SX:
        return ca.gradient(self.system.kinetic_energy, ca.vec(self.system.rod.velocity))

    def _mass_matrix(self) -> SX:
        return ca.jacobian(self._momentum(), ca.vec(self.system.rod.velocity))

    def name_unknowns(self, states: Unknowns, algebraics: Unknowns, statics: Unknowns) -> None:
        """Add the rod's unknowns to their vectors."""
        if self.form is RodForm.ARCS:
            return
        rod, length = self.system.rod, self.length
        speed = length / self.sizes.time
        algebraics.add("elastic_curvature", rod.elastic_curvature, 1.0 / length)
        statics.add("elastic_curvature", rod.elastic_curvature, 1.0 / length)
        statics.add("position", rod.position, length)
        if self.form is RodForm.STATIC:
            algebraics.add("position", rod.position, length)
            return
        states.add("position", rod.position, length)
        owner = states if self.form is RodForm.DYNAMIC else algebraics
        owner.add("velocity", rod.velocity, speed)
        if self.coupled:
            algebraics.add("acceleration", self.acceleration, speed / self.sizes.time)

    # -- coupling to the network ----------------------------------------------

    def resultants(self) -> list[tuple[SX, SX]]:
        """Mean normal force and moment of each section: conjugate to its intrinsic strains."""
        system, rod = self.system, self.system.rod
        symbols = [ca.vertcat(*system.normal_force), ca.vertcat(*system.moment)]
        if self.form is RodForm.ARCS:
            return [(symbol, SX.zeros(symbol.shape)) for symbol in symbols]
        section_length = rod.h * rod.edges_per_section
        potential = rod.elastic_potential()
        strains = (rod.intrinsic_stretch, rod.intrinsic_curvature)
        return [
            (symbol, -ca.gradient(potential, strain) / section_length)
            for symbol, strain in zip(symbols, strains, strict=True)
        ]

    def intrinsic_strains(self) -> list[tuple[SX, SX]]:
        """The rod's strain symbols, and what pressures and loads make them."""
        system, rod = self.system, self.system.rod
        return [
            (rod.intrinsic_curvature, system.intrinsic_curvature),
            (rod.intrinsic_stretch, system.intrinsic_stretch),
            (rod.tip_moment, system.load_factor * system.tip_moment),
        ]

    def conjugate_volumes(self) -> SX:
        """Volume that a reciprocal coupling would store under the section's resultants (B,)."""
        system = self.system
        own = ca.vertcat(*system.told_by.values())
        bending = ca.jacobian(system.intrinsic_curvature, own)
        extension = ca.jacobian(system.intrinsic_stretch, own)
        if system.swelling:
            # Per pressure: what was told per swelling, over the pressure per swelling.
            slope = ca.diag(ca.jacobian(system.swelling_defects(), own))
            slope = ca.repmat(_not_level(slope, system).T, system.graph.sections, 1)
            bending, extension = bending / slope, extension / slope
        section = system.rod.h * system.rod.edges_per_section
        return section * (
            bending.T @ ca.vertcat(*system.moment) + extension.T @ ca.vertcat(*system.normal_force)
        )

    # -- balances -------------------------------------------------------------

    def _forces(self) -> SX:
        rod = self.system.rod
        potential = (
            rod.elastic_potential()
            + self.system.load_factor * self.system.load_potential
            - rod.tip_moment * ca.sum1(rod.turns)
        )
        forces = -ca.gradient(potential, ca.vec(rod.position))
        if self.form in MOVING:
            # A Rayleigh function is half the power, its gradient the force.
            forces -= ca.gradient(self.system.dissipation_power / 2, ca.vec(rod.velocity))
        return forces

    def _force_size(self) -> SX:
        return self.system.rod.EI / self.length**2

    def _momentum_defect(self) -> SX:
        """Lagrange's equations where the nodes' velocities are coupled, over a force."""
        rod, energy = self.system.rod, self.system.kinetic_energy
        position, velocity = ca.vec(rod.position), ca.vec(rod.velocity)
        momentum = self._momentum()
        rate = ca.jtimes(momentum, velocity, ca.vec(self.acceleration))
        rate += ca.jtimes(momentum, position, velocity) - ca.gradient(energy, position)
        return (rate - self._forces()) / self._force_size()

    def _compatibility(self) -> SX:
        return self.system.rod.compatibility() * self.system.rod.edges

    def dynamics(self) -> tuple[list[SX], list[SX]]:
        """Rates of the scaled states and scaled algebraic defects, not yet resolved."""
        if self.form is RodForm.ARCS:
            return [], []
        length, time = self.length, self.sizes.time
        velocity = ca.vec(self.system.rod.velocity)
        alg = [self._compatibility()]
        if self.form is RodForm.STATIC:
            return [], [*alg, self._forces() / self._force_size()]
        if self.form is RodForm.DAMPED:
            return [velocity / length], [*alg, self._forces() / self._force_size()]
        if self.coupled:
            acceleration = ca.vec(self.acceleration)
            alg.append(self._momentum_defect())
        else:
            acceleration = self._forces() / ca.diag(self._mass_matrix())
        return [velocity / length, acceleration * time / length], alg

    def equilibrium(self) -> list[SX]:
        """Defects of the steady state in the static unknowns, not yet resolved."""
        if self.form is RodForm.ARCS:
            return []
        still = ca.vec(self.system.rod.velocity)
        forces = self._forces() / self._force_size()
        return [
            self._compatibility(),
            *substitute([forces], [(still, SX.zeros(still.shape))]),
        ]

    def energy_size(self) -> SX:
        """What bending by a tenth of a radian stores [J]."""
        return self.system.rod.EI / self.length / 100

    def rates(self) -> dict[str, SX]:
        """Powers whose integrals the balances need [W]."""
        return {"material_loss": self.system.dissipation_power} if self.form in MOVING else {}

    def outputs(self) -> dict[str, SX]:
        """What a motion is read from."""
        system, rod = self.system, self.system.rod
        found = {
            "normal_force": column(system.normal_force),
            "moment": column(system.moment),
            "intrinsic_curvature": rod.intrinsic_curvature,
            "intrinsic_stretch": rod.intrinsic_stretch,
            "kinetic_energy": system.kinetic_energy,
            "load_energy": system.load_potential - rod.tip_moment * ca.sum1(rod.turns),
        }
        if self.form is not RodForm.ARCS:
            found |= {
                "position": ca.vec(rod.position),
                "angle": rod.node_angles(),
                "stretch": rod.stretch,
                "elastic_energy": rod.elastic_potential(),
            }
        return found


LEVEL = 1e-9
"""Slope of a pressure, over that of the linear law, that is taken as no less."""


def _not_level(slope: SX, system: System) -> SX:
    """Pressures per swelling (B,), none of them nought [Pa/m3]."""
    least = LEVEL / system.parameter("compliance", system.bellow.compliance)
    return SX(ca.if_else(ca.fabs(slope) < least, least, slope))
