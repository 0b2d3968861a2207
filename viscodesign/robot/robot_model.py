"""A robot in numbers: one rigid body, its legs grouped by design, and its feet.

What is left out: yaw and sideways motion of the body, friction across the legs' planes, the mass
of the legs apart from their feet (it is part of the body's), and gyroscopic moments.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.robot.leg_equations import LOAD, LegFunctions, matrices
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.leg_rod import STRAIN_POINTS
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True, eq=False)
class RigidBody:
    """The body that the legs carry."""

    mass: float
    """All but the feet [kg]."""
    pitch_inertia: float
    roll_inertia: float
    """About the centre of mass [kg m2]."""


@dataclass(frozen=True, eq=False)
class Feet:
    """Equal feet: discs in the legs' planes that roll on the ground."""

    mass: float
    radius: float
    friction: float

    @property
    def inertia(self) -> float:
        """Inertia of a ball about its centre [kg m2], with a floor for a point."""
        return 0.4 * self.mass * max(self.radius, MIN_GYRATION) ** 2


MIN_GYRATION = 1e-3
"""Radius whose inertia a smaller foot has: a point could turn at any speed [m]."""


@dataclass(frozen=True, eq=False)
class LegGroup:
    """Legs of one design."""

    functions: LegFunctions
    legs: np.ndarray
    """Their numbers in the robot (l,)."""
    mounts: np.ndarray
    """(l, 5): hips from the centre of mass, tilt, lean."""
    sources: np.ndarray
    """Index of each leg's source (l,)."""

    @cached_property
    def places(self) -> np.ndarray:
        """Where the coordinates of each leg stand: body, then its foot (l, 7)."""
        feet = BODY + FOOT * self.legs[:, None] + np.arange(FOOT)
        return np.hstack([np.tile(np.arange(BODY), (len(feet), 1)), feet])

    @property
    def strain_numbers(self) -> int:
        """Numbers of a leg that its damping remembers."""
        return 2 * STRAIN_POINTS * len(self.functions.design.free_sections)


@dataclass(frozen=True, eq=False)
class LegStates:
    """Loads, pressures, strains and contents of the legs of a group."""

    load: np.ndarray
    """(l, 3)"""
    pressure: np.ndarray
    """Gauge, of bellows and junctions (l, n) [Pa]."""
    strains: np.ndarray
    content: np.ndarray
    """As volume at ambient density (l, n) [m3]."""
    inflow: np.ndarray
    """Net flow into every node, then out of the source, likewise (l, n + 1) [m3/s]."""


@dataclass(frozen=True, eq=False)
class LinearisedLegs:
    """Legs of a group about a place, their own unknowns eliminated."""

    reaction: np.ndarray
    """Generalised force that the legs take, at unchanged place (l, 7)."""
    stiffness: np.ndarray
    """Its derivative with respect to the place (l, 7, 7)."""
    own: np.ndarray
    """Step of load and pressures at unchanged place (l, m)."""
    own_by_place: np.ndarray
    """(l, m, 7)"""


@dataclass(frozen=True, eq=False)
class RobotModel:
    """All numbers of a robot."""

    body: RigidBody
    feet: Feet
    groups: tuple[LegGroup, ...]
    leg_names: tuple[str, ...]
    source_names: tuple[str, ...]
    damping_time: float
    gravity: tuple[float, float]
    """Along x and z of the ground's axes [m/s2]."""

    @property
    def count(self) -> int:
        """Number of legs."""
        return len(self.leg_names)

    @property
    def source_of(self) -> tuple[int, ...]:
        """Index of each leg's source, by leg."""
        found = np.zeros(self.count, dtype=int)
        for group in self.groups:
            found[group.legs] = group.sources
        return tuple(found.tolist())

    @property
    def size(self) -> int:
        """Number of coordinates: body, then feet."""
        return BODY + FOOT * self.count

    @cached_property
    def masses(self) -> np.ndarray:
        """Mass or inertia of every coordinate (size,)."""
        body, feet = self.body, self.feet
        own = [body.mass, body.mass, body.pitch_inertia, body.roll_inertia]
        return np.array([*own, *[feet.mass, feet.mass, feet.inertia] * self.count])

    @property
    def mass(self) -> float:
        """Mass of everything [kg]."""
        return self.body.mass + self.count * self.feet.mass

    @property
    def weight(self) -> float:
        """Force on level ground [N]."""
        return self.mass * float(np.hypot(*self.gravity))

    @cached_property
    def weights(self) -> np.ndarray:
        """Generalised force of gravity (size,) [N, N m]."""
        found = np.zeros(self.size)
        for axis, pull in enumerate(self.gravity):
            at = [axis, *range(BODY + axis, self.size, FOOT)]
            found[at] = self.masses[at] * pull
        return found

    @cached_property
    def contact_rows(self) -> np.ndarray:
        """Derivatives of all gaps, then of all slips, by the coordinates (2c, size)."""
        c = self.count
        rows, at = np.zeros((2 * c, self.size)), BODY + FOOT * np.arange(c)
        rows[np.arange(c), at + 1] = -1.0
        rows[c + np.arange(c), at] = 1.0
        rows[c + np.arange(c), at + 2] = self.feet.radius
        return rows

    def gaps(self, place: np.ndarray) -> np.ndarray:
        """Height of the feet's lowest points over the ground (c,) [m]."""
        return np.asarray(-place[BODY + 1 :: FOOT] - self.feet.radius)

    def hip_heights(self, place: np.ndarray) -> np.ndarray:
        """Height of the hips over the ground, by group and leg (c,) [m]."""
        pitch, roll = place[2], place[3]
        x, y, z = np.concatenate([group.mounts[:, :3] for group in self.groups]).T
        below = z * np.cos(roll) + y * np.sin(roll)
        return np.asarray(x * np.sin(pitch) - below * np.cos(pitch) - place[1])

    @cached_property
    def _matrix_places(self) -> list[np.ndarray]:
        return [
            (group.places[:, :, None] * self.size + group.places[:, None, :]).ravel()
            for group in self.groups
        ]

    def assembled(self, legs: Sequence[LinearisedLegs]) -> tuple[np.ndarray, np.ndarray]:
        """Reaction (size,) and stiffness (size, size) of all legs."""
        n, force, matrix = self.size, np.zeros(self.size), np.zeros(self.size**2)
        for group, places, own in zip(self.groups, self._matrix_places, legs, strict=True):
            force += np.bincount(group.places.ravel(), own.reaction.ravel(), n)
            matrix += np.bincount(places, own.stiffness.ravel(), n * n)
        return force, matrix.reshape(n, n)


def linearised(
    group: LegGroup,
    place: np.ndarray,
    legs: LegStates,
    before: LegStates,
    source: np.ndarray,
    step: tuple[float, float],
    *,
    hold_pressures: bool = False,
) -> LinearisedLegs:
    """Legs about a place (7 each), with their own unknowns eliminated.

    ``source``: gauge pressures of their sources (l, 1) [Pa]; ``step``: step [s] and damping time
    over the step. With ``hold_pressures`` the pressures are given.
    """
    functions, count = group.functions, len(group.legs)
    numbers = np.tile(np.array(step), (count, 1))
    residual, reaction, by_own, by_place = functions.linearised.rows(
        [place, legs.load, legs.pressure, group.mounts, before.strains, before.content, source,
         numbers],
        count,
    )  # fmt: skip
    m = LOAD if hold_pressures else functions.unknowns
    rows = functions.unknowns + BODY + FOOT
    own, at = matrices(by_own, rows)[:, :, :m], matrices(by_place, rows)
    right = np.concatenate([residual[:, :m, None], at[:, :m]], axis=2)
    solved = -np.linalg.solve(own[:, :m], right)
    force_by_own = own[:, -(BODY + FOOT) :]
    stiffness = at[:, -(BODY + FOOT) :] + force_by_own @ solved[:, :, 1:]
    force = reaction + (force_by_own @ solved[:, :, :1])[:, :, 0]
    return LinearisedLegs(force, stiffness, solved[:, :, 0], solved[:, :, 1:])
