"""The contract of a rod's discretisation: everything that the balances and the solvers ask of it.

The planar, extensible rod has internal forces, and an intrinsic curvature and stretch in every
section. How finitely many unknowns describe its shape is the matter of one
discretisation; nothing outside its files knows. A new one

1. subclasses `RodSymbols`: its coordinates q as symbols, their rates, and, for a mixed method,
   internal unknowns; masses, strains and energies in them. The elastic potential is stationary
   in the internal unknowns, which gives as many algebraic equations;
2. states the sizes of coordinates, internal unknowns, forces and these equations, for scaling;
3. subclasses `RodDiscretisation`, which answers with numbers: the coordinates of the unloaded
   rod, the drawn axis and the strains of a solved motion, the order in which a stability test
   may eliminate the unknowns, the geometry of an iteration's steps, the mesh for an accuracy;
4. is chosen in `build_problem.build`; its `shearable` variant takes its place where cross sections
   may turn against the axis (`System.let_shear`).

A rod that no load bends consists of circular arcs and needs no discretisation at all
(`arc_shape`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from typing import Self

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import SCENE_NUMBER, Numbers
from viscodesign.model.step_geometry import StepGeometry

SX = ca.SX

MINIMUM_EDGES = 4


@dataclass(frozen=True, eq=False)
class SectionNumbers:
    """Numbers of sections that differ, each one for all or an array (S,); in SI."""

    bending_stiffness: Numbers = field(metadata=SCENE_NUMBER)
    """Infinite where a section does not bend [N m2]."""
    extension_stiffness: Numbers = field(metadata=SCENE_NUMBER)
    """Infinite where a section does not stretch [N]."""
    mass_per_length: Numbers = field(metadata=SCENE_NUMBER)


@dataclass(frozen=True)
class Body:
    """The actuator as a beam, in SI."""

    length: float = field(metadata=SCENE_NUMBER)
    sections: int
    bending_stiffness: float = field(metadata=SCENE_NUMBER)
    extension_stiffness: float = field(metadata=SCENE_NUMBER)
    mass_per_length: float = field(metadata=SCENE_NUMBER)
    varied: SectionNumbers | None = None
    """Numbers of every section, where they differ; those above then are of a uniform
    body that is as soft and as heavy as a whole."""
    members: tuple[Body, ...] = ()
    """Several bodies side by side, whose sections are counted in a row; the numbers above
    then are of one that stands for all. Empty for a single one."""

    @property
    def section_length(self) -> float:
        """Reference length of one section of a single body [m]."""
        return self.length / self.sections

    @property
    def section_lengths(self) -> Numbers:
        """Reference length of a section, one for all or of each (S,) [m]."""
        if not self.members:
            return self.section_length
        each = [np.full(own.sections, own.section_length) for own in self.members]
        return np.concatenate(each)

    @property
    def masses_per_length(self) -> Numbers:
        """Mass per length, one for all sections or of each (S,) [kg/m]."""
        if self.members:
            each = [own.masses_per_length * np.ones(own.sections) for own in self.members]
            return np.concatenate(each)
        return self.mass_per_length if self.varied is None else self.varied.mass_per_length

    @property
    def lengths(self) -> list[float]:
        """Lengths of all bodies [m]."""
        return [own.length for own in self.members or (self,)]


@dataclass(frozen=True)
class Softness:
    """Stiffness of the uniform body over that of every section (S,) [1]."""

    bending: SX
    extension: SX


@dataclass(frozen=True)
class RodParameters:
    """Stiffnesses and masses of the rod as symbols, so that one build serves many values."""

    bending_stiffness: SX
    extension_stiffness: SX
    section_length: SX
    mass_per_length: SX
    """One for all sections, or of each (S,)."""
    length: SX
    shear_stiffness: SX | None = None
    """None where cross sections stay perpendicular to the axis; one or (S,) [N]."""
    softness: Softness | None = None
    """None where the stiffnesses are the same in all sections."""
    tip_moment: SX | None = None
    """Moment at the tip where it is known [N m]; None: a symbol of its own."""
    members: tuple[RodParameters, ...] = ()
    """Parameters of every rod where there are several; the others then are typical ones."""

    def stiffened(self, bending: SX, extension: SX) -> RodParameters:
        """The same rods with their stiffnesses times these factors [1]."""
        return replace(
            self,
            bending_stiffness=bending * self.bending_stiffness,
            extension_stiffness=extension * self.extension_stiffness,
            members=tuple(own.stiffened(bending, extension) for own in self.members),
        )


@dataclass(frozen=True)
class PointMass:
    """A mass [kg] lumped at a point of the rod, with its position and velocity as symbols."""

    mass: SX
    position: SX
    velocity: SX


class RodSymbols(ABC):
    """The rod's unknowns as symbols, and what follows from them."""

    coordinates: SX
    """Generalised coordinates q (n,)."""
    rates: SX
    """Their rates in time (n,): dq/dt."""
    internal: SX
    """Unknowns of a mixed method that the shape determines (m,); empty where there are none."""
    coordinate_size: SX
    section_length: SX
    """Reference length of a section, as the mesh sums it up; of several rods (S,) [m]."""
    intrinsic_curvature: SX
    """Intrinsic curvature of every section, as symbols (S,) [1/m]."""
    intrinsic_stretch: SX
    """Intrinsic stretch of every section, as symbols (S,) [1]."""
    tip_moment: SX
    """Moment applied at the tip, a symbol [N m]."""

    def __init__(self, parameters: RodParameters) -> None:
        self._parameters = parameters

    @property
    def bending_stiffness(self) -> SX:
        """Bending stiffness [N m2]; `System.scale_stiffness` changes it."""
        return self._parameters.bending_stiffness

    @property
    def extension_stiffness(self) -> SX:
        """Extension stiffness [N]."""
        return self._parameters.extension_stiffness

    @property
    def rods(self) -> Sequence[RodSymbols]:
        """Each rod by itself, where there are several; else this one."""
        return (self,)

    @property
    def section_angles(self) -> SX:
        """Coordinates besides, of a shearable rod: angles of cross sections (k,) [rad]."""
        return SX(0, 1)

    @property
    def section_rates(self) -> SX:
        """Their rates in time (k,) [rad/s]."""
        return SX(0, 1)

    @property
    def strain_rates(self) -> SX:
        """Strain rates that are unknowns where the rod has mass and is damped (k,) [1/(m s)]."""
        return SX(0, 1)

    @property
    def strain_rate_size(self) -> SX:
        """Size of the strain rates, times the time scale [1/m]."""
        return 1 / self.coordinate_size

    @property
    def strain_rate_values(self) -> SX:
        """What they are, by coordinates and rates (k,)."""
        return SX(0, 1)

    @property
    @abstractmethod
    def tip(self) -> SX:
        """Position of the tip (2,) [m]."""

    @property
    @abstractmethod
    def tip_angle(self) -> SX:
        """Angle of the cross section at the tip, from +z towards +x [rad]."""

    @property
    @abstractmethod
    def section_ends(self) -> list[SX]:
        """Position of every section's far end (2,) [m], clamp first; the last is the tip's."""

    @abstractmethod
    def tip_turns(self) -> list[SX]:
        """Rotations, each local, through whose sum a moment at the tip does its work [rad]."""

    @property
    @abstractmethod
    def force_size(self) -> SX:
        """By which the generalised forces are divided."""

    @property
    @abstractmethod
    def internal_size(self) -> SX:
        """Sizes of the internal unknowns (m,)."""

    @property
    @abstractmethod
    def internal_scale(self) -> SX:
        """Positive factors (m,) by which the potential's slopes in them become residuals."""

    @abstractmethod
    def masses(self) -> list[PointMass]:
        """All masses that the rod carries, lumped at points."""

    @abstractmethod
    def add_tip_mass(self, mass: SX) -> None:
        """Hang a point mass [kg] on the tip."""

    @abstractmethod
    def add_carried_mass(self, per_section: list[SX]) -> None:
        """Distribute a mass [kg] along each section, first at the clamp."""

    @abstractmethod
    def dissipation_powers(self, time: SX) -> list[SX]:
        """Each stiffness times its squared strain rate and ``time``, integrated [W].

        One local term for each part of the rod. ``time``: retardation time, one for all sections
        or of each (S,) [s].

        The power that a Kelvin-Voigt material dissipates. It depends on the motion alone; a rigid
        rotation has none. In the strain rates that are unknowns it is stationary, so that half its
        gradient in the rates of the coordinates is the force.
        """

    @abstractmethod
    def rotary_energies(self, inertia_per_length: SX) -> list[SX]:
        """Kinetic energies of the turning cross sections [J].

        ``inertia_per_length``: one for all sections or of each (S,) [kg m].
        """

    @abstractmethod
    def elastic_energies(self) -> list[SX]:
        """Elastic energies of the parts of the rod [J], each local.

        Their sum is stationary in the internal unknowns; its gradient in the coordinates is minus
        the internal forces, and that in the intrinsic strains minus what is conjugate to them.
        """

    @abstractmethod
    def stored_energies(self) -> list[SX]:
        """What the parts store [J], that of a moment at the tip included.

        Where loads change slowly, their sum changes by the work of the loads and of the intrinsic
        strains alone; the moment does its work along `tip_angle`.
        """

    @abstractmethod
    def outputs(self) -> dict[str, SX]:
        """Named quantities from which `RodDiscretisation` reads a solved motion."""


Values = Mapping[str, np.ndarray]
"""Named outputs, each (T, n)."""
ROD_VALUES = ("position", "angle", "stretch", "shear_angle")
"""Names of those that rods have, as far as they do."""


@dataclass(frozen=True)
class RodDiscretisation(ABC):
    """A way to describe the rod by finitely many unknowns, with the numbers of one body."""

    body: Body
    edges_per_section: int

    @classmethod
    @abstractmethod
    def suggested(cls, body: Body, accuracy: float, largest_turn: float) -> Self:
        """The mesh whose tip error should meet ``accuracy`` [lengths of the rod].

        ``largest_turn``: intrinsic turn of one section [rad].
        """

    @abstractmethod
    def shearable(self) -> RodDiscretisation:
        """The same mesh for a rod whose cross sections may turn against the axis."""

    @abstractmethod
    def symbols(self, parameters: RodParameters) -> RodSymbols:
        """The unknowns as symbols."""

    @abstractmethod
    def unloaded_coordinates(self, curvature: np.ndarray, stretch: np.ndarray) -> np.ndarray:
        """Scaled coordinates (n,) of the unloaded rod, then angles of cross sections (k,).

        ``curvature`` (S,) [1/m per reference length], ``stretch`` (S,) total stretch [1].
        """

    def rods(self, values: Values) -> list[tuple[RodDiscretisation, Values]]:
        """Each rod by itself with its named outputs, where there are several; else this one."""
        return [(self, values)]

    @abstractmethod
    def section_strains(self, values: Values) -> tuple[np.ndarray, np.ndarray]:
        """Smallest stretch [1] and turn [rad] of every section, each (T, S)."""

    @abstractmethod
    def axis(self, values: Values, points: int) -> tuple[np.ndarray, np.ndarray]:
        """Axis (T, K, 2) [m], the clamp left out, K >= ``points``, and tip angle (T,) [rad]."""

    @abstractmethod
    def angle_jump(self, values: Values) -> tuple[int, int] | None:
        """First row (T,) before which the axis folds onto itself, and the section (from 0).

        None where it nowhere does, or where there is a single row.
        """

    @abstractmethod
    def elimination_order(self) -> tuple[np.ndarray, np.ndarray]:
        """Order in which internal unknowns and coordinates are eliminated without pivoting.

        Of all unknowns, internal ones counted first, angles of cross sections last: the order, and
        which of them, in that order, are internal.
        """

    @abstractmethod
    def step_geometry(self, coordinates: slice) -> StepGeometry:
        """How iterations step in a vector that holds these in this slice, angles last."""
