"""The rod's part of the equations, in the simplest form that carries what acts on it."""

from __future__ import annotations

import math
from dataclasses import replace
from enum import Enum

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import places
from viscodesign.model.contact_point import contact_forces, contact_paths
from viscodesign.model.sums import GradientRows, Rows, total, whole
from viscodesign.model.system import System
from viscodesign.model.unknowns import SizeSymbols, SymbolicUnknowns, Traits, column, substitute

SX = ca.SX

COORDINATES = "rod_coordinates"
RATES = "rod_rates"
ACCELERATIONS = "rod_accelerations"
INTERNAL = "rod_internal"
STRAIN_RATES = "rod_strain_rates"
SECTION_ANGLES = "rod_section_angles"
SECTION_RATES = "rod_section_rates"
CONTACT_FORCES = "contact_forces"
"""Names of the rod's blocks of unknowns, whatever the discretisation. Solvers read the traits."""
TRAITS = {
    COORDINATES: Traits(of_rod=True, identifies_branch=True),
    RATES: Traits(of_rod=True, integrations=1),
    # Accelerations are noisy, and nothing is integrated from them but through the
    # velocities, whose error is controlled.
    ACCELERATIONS: Traits(of_rod=True, integrations=2, is_noisy=True),
    # They follow linearly from the coordinates, which do count.
    INTERNAL: Traits(of_rod=True, is_internal=True, integrations=math.inf),
    STRAIN_RATES: Traits(
        of_rod=True, is_noisy=True, follows_from_states=True, integrations=math.inf
    ),
}
TRAITS[CONTACT_FORCES] = Traits(integrations=math.inf)
TRAITS |= {SECTION_ANGLES: TRAITS[COORDINATES], SECTION_RATES: TRAITS[RATES]}
MIN_REL_PRESSURE_SLOPE = 1e-9
"""Smallest pressure per swelling, over that of the linear law, by which a strain is divided."""


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
    loaded |= bool(system.contacts)
    return RodForm.STATIC if loaded else RodForm.ARCS


@dataclass(frozen=True)
class Coordinates:
    """Coordinates of one kind with their rates, and how they enter the equations."""

    name: str
    values: SX
    size: SX
    rates_name: str
    rates: SX
    force_size: SX
    form: RodForm


class RodEquations:
    """Unknowns, balances and outputs of the rod, from the answers of its discretisation."""

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.rod = system.rod
        self.sizes = sizes
        self.form = rod_form(system)
        self.kinds = [kind for kind in (self._places(), self._angles()) if kind.values.numel()]
        self.acceleration = SX.sym("acceleration", self.rod.rates.numel())
        self.strain_rates = self._strain_rates()
        self.dissipation_powers = self._dissipation_powers()
        self.coupled = self.form is RodForm.DYNAMIC and not self._masses_are_constant()
        self.contact_forces = contact_forces(system.contacts)

    def _places(self) -> Coordinates:
        rod = self.rod
        return Coordinates(
            COORDINATES,
            rod.coordinates,
            rod.coordinate_size,
            RATES,
            rod.rates,
            rod.force_size,
            self.form,
        )

    def _angles(self) -> Coordinates:
        """Angles of cross sections, which without inertia of their own follow what moves them."""
        rod, system, form = self.rod, self.system, self.form
        has_mass = ca.depends_on(system.kinetic_energy.total, rod.section_rates)
        if form is RodForm.DYNAMIC and not has_mass:
            form = RodForm.STATIC if system.dissipation_power.is_zero() else RodForm.DAMPED
        angles, rates = rod.section_angles, rod.section_rates
        moment = rod.force_size * system.length
        return Coordinates(SECTION_ANGLES, angles, SX(1), SECTION_RATES, rates, moment, form)

    def _strain_rates(self) -> SX:
        """Those that are unknowns: none where no power depends on them.

        Nor without mass, where the balance of forces determines the rates: it needs its slopes in
        them.
        """
        rates = self.rod.strain_rates
        has_any = self.form is RodForm.DYNAMIC and rates.numel() > 0
        if has_any and ca.depends_on(self.system.dissipation_power.total, rates):
            return rates
        return SX(0, 1)

    def _dissipation_powers(self) -> list[SX]:
        """Powers in the unknowns [W]."""
        terms, rod = self.system.dissipation_power.terms, self.rod
        if self.strain_rates.numel() or not rod.strain_rates.numel():
            return terms
        return substitute(terms, [(rod.strain_rates, rod.strain_rate_values)])

    def _masses_are_constant(self) -> bool:
        """Whether every momentum is a constant times its own velocity."""
        mass = self._mass_matrix(self.rod.rates)
        free = not ca.depends_on(mass, ca.veccat(self.rod.rates, self.rod.coordinates))
        return mass.sparsity().is_diag() and free

    def _mass_matrix(self, rates: SX) -> SX:
        return ca.jacobian(ca.gradient(self.system.kinetic_energy.total, rates), rates)

    def name_unknowns(
        self, states: SymbolicUnknowns, algebraics: SymbolicUnknowns, statics: SymbolicUnknowns
    ) -> None:
        """Add the rod's unknowns to their vectors."""
        if self.form is RodForm.ARCS:
            return
        rod, time = self.rod, self.sizes.time
        # Vibrations along a stiff axis are too fast to resolve, and hardly move it.
        internal = replace(TRAITS[INTERNAL], is_noisy=self.form in MOVING)
        for unknowns in (algebraics, statics):
            unknowns.add(INTERNAL, rod.internal, rod.internal_size, internal)
        if self.strain_rates.numel():
            size = rod.strain_rate_size / time
            algebraics.add(STRAIN_RATES, self.strain_rates, size, TRAITS[STRAIN_RATES])
        for kind in self.kinds:
            statics.add(kind.name, kind.values, kind.size, TRAITS[kind.name])
            self._name_moving(kind, states, algebraics, internal)
        if self.coupled:
            size = rod.coordinate_size / time / time
            algebraics.add(ACCELERATIONS, self.acceleration, size, TRAITS[ACCELERATIONS])
        # No equation changes them: whoever solves for contact does, and all else holds them.
        states.add(CONTACT_FORCES, self.contact_forces, rod.force_size, TRAITS[CONTACT_FORCES])

    def _name_moving(
        self,
        kind: Coordinates,
        states: SymbolicUnknowns,
        algebraics: SymbolicUnknowns,
        internal: Traits,
    ) -> None:
        """Add the unknowns of a kind to those of a motion; ``internal``: traits of what follows."""
        if kind.form is RodForm.STATIC:
            # Angles of sections follow linearly from the places that move.
            traits = TRAITS[kind.name] if self.form is RodForm.STATIC else internal
            algebraics.add(kind.name, kind.values, kind.size, traits)
            return
        states.add(kind.name, kind.values, kind.size, TRAITS[kind.name])
        owner = states if kind.form is RodForm.DYNAMIC else algebraics
        owner.add(kind.rates_name, kind.rates, kind.size / self.sizes.time, TRAITS[kind.rates_name])

    # -- coupling to the network ----------------------------------------------

    def resultants(self) -> list[tuple[SX, SX]]:
        """Mean normal force and moment of each section: conjugate to its intrinsic strains."""
        if self.form is RodForm.ARCS:
            system = self.system
            symbols = [ca.vertcat(*system.normal_force), ca.vertcat(*system.moment)]
            return [(symbol, SX.zeros(symbol.shape)) for symbol in symbols]
        return [(symbol, rows.whole()) for symbol, rows, _ in self._resultant_rows()]

    def _resultant_rows(self) -> list[tuple[SX, GradientRows, SX]]:
        """Symbols of the resultants, what they are, and their sizes."""
        system, rod = self.system, self.rod
        energies, force = rod.elastic_energies(), rod.bending_stiffness / system.length**2
        return [
            (ca.vertcat(*symbols), GradientRows(energies, strain, -1 / rod.section_length), size)
            for symbols, strain, size in (
                (system.normal_force, rod.intrinsic_stretch, force),
                (system.moment, rod.intrinsic_curvature, force * system.length),
            )
        ]

    def intermediates(self) -> list[tuple[SX, Rows, SX]]:
        """Sums that other terms depend on: their symbols, what they are, and their sizes."""
        if self.form is RodForm.ARCS:
            return []
        system, rod = self.system, self.rod
        return [
            (rod.intrinsic_curvature, system.intrinsic_curvature, 1 / system.length),
            (rod.intrinsic_stretch, system.intrinsic_stretch, SX(1)),
            *self._resultant_rows(),
        ]

    def intrinsic_strains(self) -> list[tuple[SX, SX]]:
        """The rod's strain symbols, with the values that pressures and loads give them."""
        system, rod = self.system, self.rod
        return [
            (rod.intrinsic_curvature, system.intrinsic_curvature),
            (rod.intrinsic_stretch, system.intrinsic_stretch),
            (rod.tip_moment, self._dead_moment() + system.contact_moment),
        ]

    def _moment_work(self) -> SX:
        """What the dead moment at the tip can do [J]; several rods have none."""
        moment = self._dead_moment()
        return SX(0) if moment.is_zero() else moment * self.rod.tip_angle

    def _dead_moment(self) -> SX:
        return self.system.load_factor * self.system.tip_moment

    def conjugate_volumes(self) -> SX:
        """Volumes that a reciprocal coupling would store under the section's resultants (B,)."""
        system = self.system
        own = ca.vertcat(*system.wall_argument.values())
        bending = ca.jacobian(system.intrinsic_curvature, own)
        extension = ca.jacobian(system.intrinsic_stretch, own)
        if system.swelling:
            # Per pressure: what is known per swelling, over the pressure per swelling.
            slope = ca.diag(ca.jacobian(system.swelling_defects(), own))
            slope = ca.repmat(_nonzero_slope(slope, system).T, system.graph.sections, 1)
            bending, extension = bending / slope, extension / slope
        return self._length_at_bellows() * (
            bending.T @ ca.vertcat(*system.moment) + extension.T @ ca.vertcat(*system.normal_force)
        )

    def _length_at_bellows(self) -> SX:
        """Length of every bellow's section, one for all or (B,) along the tubes [m]."""
        length = self.rod.section_length
        if length.is_scalar():
            return length
        place = places(self.system.graph)
        return ca.vertcat(*(length[place[name].section] for name in self.system.wall_argument))

    # -- balances -------------------------------------------------------------

    def _internal_rows(self) -> Rows:
        """Equations of the internal unknowns (m,), in which the potential is stationary."""
        rod = self.rod
        if not rod.internal.numel():
            return SX(0, 1)
        return GradientRows(rod.elastic_energies(), rod.internal, rod.internal_scale)

    def _potential(self) -> list[SX]:
        """Energies of the rod and of its loads, each local [J]."""
        system, rod = self.system, self.rod
        loads = [system.load_factor * term for term in system.load_potential.terms]
        turns = [-rod.tip_moment * turn for turn in rod.tip_turns()]
        contacts = [point.potential for point in system.contacts]
        return [*rod.elastic_energies(), *loads, *turns, *contacts]

    def _forces(self, kind: Coordinates, scale: SX) -> list[Rows]:
        """Generalised forces on coordinates, times ``scale``."""
        forces: list[Rows] = [GradientRows(self._potential(), kind.values, -scale)]
        if kind.form in MOVING:
            # A Rayleigh function is half the power, its gradient the force.
            power = self.dissipation_powers
            forces.append(GradientRows(power, kind.rates, -scale / 2))
        return forces

    def _momentum_rows(self) -> list[Rows]:
        """Lagrange's equations where the velocities are coupled, over the size of a force.

        In Nielsen's form, d(dT/dt)/dv - 2 dT/dr = F, they are gradients throughout.
        """
        rod, energies, scale = self.rod, self.system.kinetic_energy.terms, 1 / self.rod.force_size
        moving = ca.vertcat(rod.coordinates, rod.rates)
        along = ca.vertcat(rod.rates, self.acceleration)
        powers = [ca.jtimes(energy, moving, along) for energy in energies]
        inertia = [
            GradientRows(powers, rod.rates, scale),
            GradientRows(energies, rod.coordinates, -2 * scale),
        ]
        return [*inertia, *self._forces(self.kinds[0], -scale)]

    def dynamics(self, with_accelerations: bool) -> tuple[list[list[Rows]], list[list[Rows]]]:
        """Rates of the scaled states and scaled algebraic residuals, not yet resolved.

        Of every block of rows, the contributions to it. ``with_accelerations``: as unknowns,
        with an equation each.
        """
        if self.form is RodForm.ARCS:
            return [], []
        ode: list[list[Rows]] = []
        alg: list[list[Rows]] = [[self._internal_rows()]]
        if self.strain_rates.numel():
            size = self.rod.strain_rate_size / self.sizes.time
            alg.append([(self.rod.strain_rate_values - self.strain_rates) / size])
        for kind in self.kinds:
            forces = self._forces(kind, 1 / kind.force_size)
            if kind.form is not RodForm.STATIC:
                ode.append([kind.rates / kind.size])
            if kind.form is not RodForm.DYNAMIC:
                alg.append(forces)
            elif not (with_accelerations and kind.name == COORDINATES):
                ode.append(self._own_accelerations(kind))
            else:
                ode.append([self.acceleration / (kind.size / self.sizes.time)])
        if self.system.contacts:
            ode.append([SX.zeros(self.contact_forces.shape)])
        return ode, [*alg, self._momentum_rows()] if with_accelerations else alg

    def _own_accelerations(self, kind: Coordinates) -> list[Rows]:
        """Scaled accelerations of coordinates, each with a constant mass of its own."""
        speed = kind.size / self.sizes.time
        return self._forces(kind, 1 / (ca.diag(self._mass_matrix(kind.rates)) * speed))

    def equilibrium(self) -> list[SX]:
        """Residuals of the steady state in the static unknowns, not yet resolved."""
        if self.form is RodForm.ARCS:
            return []
        rates = (*(kind.rates for kind in self.kinds), self.rod.strain_rates)
        at_rest = [(own, SX.zeros(own.shape)) for own in rates]
        forces = [
            whole(self._forces(kind, 1 / kind.force_size), kind.rates.numel())
            for kind in self.kinds
        ]
        internal = whole([self._internal_rows()], self.rod.internal.numel())
        return [internal, *substitute(forces, at_rest)]

    def without_contact(self) -> list[tuple[SX, SX]]:
        """What the forces of contact are where an equilibrium is found: none."""
        forces = self.contact_forces
        return [(forces, SX.zeros(forces.shape))] if self.system.contacts else []

    def energy_size(self) -> SX:
        """Energy of bending the rod by a tenth of a radian [J]."""
        return self.rod.bending_stiffness / self.system.length / 100

    def rates(self) -> dict[str, SX]:
        """Powers whose integrals the balances need [W]."""
        return {"material_loss": total(self.dissipation_powers)} if self.form in MOVING else {}

    def works(self) -> list[str]:
        """Names of the works of forces along paths."""
        return ["contact"] if self.system.contacts else []

    def outputs(self) -> dict[str, SX]:
        """Quantities from which a motion is read."""
        system, rod = self.system, self.rod
        found = {
            "normal_force": column(system.normal_force),
            "moment": column(system.moment),
            "intrinsic_curvature": rod.intrinsic_curvature,
            "intrinsic_stretch": rod.intrinsic_stretch,
            "kinetic_energy": system.kinetic_energy.total,
            "load_energy": system.load_potential.total - self._moment_work(),
            "contact_force": self.contact_forces,
            "contact_path": contact_paths(system.contacts),
        }
        if self.form is not RodForm.ARCS:
            found |= rod.outputs() | {"elastic_energy": total(rod.stored_energies())}
        return found


def _nonzero_slope(slope: SX, system: System) -> SX:
    """Pressures per swelling (B,), none of them zero [Pa/m3]."""
    least = MIN_REL_PRESSURE_SLOPE / system.parameter("compliance", system.bellow.compliance)
    return SX(ca.if_else(ca.fabs(slope) < least, least, slope))
