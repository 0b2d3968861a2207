"""The axis of the rod under its pressures and steady loads."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.estimate.network_estimate import NetworkEstimate
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.storage.cached_property import cached_property

LARGEST_LOAD_TURN = 3.0
"""Angle by which a load may bend one piece [rad]."""
LARGEST_SHEAR = 1.0
"""Angle by which a load may shear one piece [rad]."""
LOAD_ROUNDS = 2
LEAST_STRETCH = 0.05


@dataclass(frozen=True)
class Axis:
    """The axis as K pieces of arc at T samples."""

    nodes: np.ndarray
    """(T, K, 2) ends of the pieces [m]."""
    middle: np.ndarray
    """(T, K, 2) middles of their chords [m]."""
    direction: np.ndarray
    """(T, K, 2) unit tangents at the middles."""
    stretch: np.ndarray
    """(T, K)"""
    load_curvature: np.ndarray
    """(T, K) curvature by loads [1/m]."""
    load_stretch: np.ndarray
    """(T, K) stretch by loads [1]."""

    @property
    def across(self) -> np.ndarray:
        """(T, K, 2) unit vectors perpendicular to the axis."""
        return np.stack((self.direction[..., 1], -self.direction[..., 0]), axis=-1)

    def sheared(self, angle: np.ndarray, length: float) -> Axis:
        """The axis whose pieces (T, K) of this reference length also shear."""
        moved = (length * self.stretch * angle)[..., None] * self.across
        nodes = np.cumsum(moved, axis=1)
        return replace(self, nodes=self.nodes + nodes, middle=self.middle + nodes - moved / 2)

    def strained(self, curvature: np.ndarray, stretch: np.ndarray) -> Axis:
        """The same places, with more elastic strain (T, K) from loads."""
        return replace(
            self,
            load_curvature=self.load_curvature + curvature,
            load_stretch=self.load_stretch + stretch,
        )


@dataclass(frozen=True)
class LoadEstimate:
    """Masses and steady forces on the rod, and the axis that they bend."""

    network: NetworkEstimate
    acceleration: tuple[float, float]
    tip_force: tuple[float, float]
    tip_mass: float
    held_density: float
    shear_compliance: float

    @classmethod
    def of(cls, network: NetworkEstimate, terms: Sequence[EstimateTerm]) -> LoadEstimate:
        """The sums of all terms."""
        return cls(
            network,
            _sum_of_pairs([term.acceleration for term in terms]),
            _sum_of_pairs([term.tip_force for term in terms]),
            sum(term.tip_mass for term in terms),
            sum(term.held_density for term in terms),
            sum(term.shear_compliance for term in terms),
        )

    @property
    def setting(self) -> EstimateSetting:
        """What all estimates of the scene share."""
        return self.network.setting

    @property
    def axis(self) -> Axis:
        """The axis at the network's pressures."""
        loads = (self.acceleration, self.tip_force, self.tip_mass, self.held_density)
        key = (*self.network.key, *loads, self.shear_compliance)
        return self.setting.remembered(key, lambda: self.axis_at(self.network.pressure))

    @property
    def has_head(self) -> bool:
        """Whether the fluid's weight presses."""
        return bool(self.held_density * math.hypot(*self.acceleration))

    def axis_at(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> Axis:
        """The axis at pressures (T, B); ``uptake``: volumes that the rod adds (T, B) [m3]."""
        setting = self.setting
        curvature, stretch = (s @ setting.spread.T for s in self._strains(pressure))
        length = setting.length / setting.pieces
        force = self.masses(pressure, uptake)[..., None] * np.array(self.acceleration)
        force[:, -1] += self.tip_force
        axis = _unloaded(curvature, 1 + stretch, length)
        for _ in range(LOAD_ROUNDS if np.any(force) else 0):
            bent, drawn = self.elastic_strains(axis, force)
            shear = self.shear_angles(axis, force)
            axis = _unloaded(curvature + bent, 1 + stretch + drawn, length)
            axis = replace(axis, load_curvature=bent, load_stretch=drawn)
            axis = axis if shear is None else axis.sheared(shear, length)
        return axis

    def _strains(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch of every section (T, S)."""
        _, bend, extend = self.network.bellow(pressure)
        right, left = np.split(bend, 2, axis=1)
        return left - right, sum(np.split(extend, 2, axis=1), np.zeros_like(left))

    def masses(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Masses at the ends of the pieces (T or 1, K) [kg]."""
        setting = self.setting
        mass = setting.piece_masses * setting.length / setting.pieces * np.ones(setting.pieces)
        mass[-1] = mass[-1] / 2 + self.tip_mass
        return mass + self._held(pressure, uptake) if self.held_density else mass[None]

    def _held(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Mass of the fluid in every piece (T, K) [kg]."""
        setting, fluid = self.setting, self.network.fluid
        volume = setting.rest_volume + self.network.bellow(pressure)[0]
        amount = np.maximum(volume if uptake is None else volume + uptake, 0.0)
        if fluid is not None:
            amount *= fluid.density(pressure, setting.ambient)
        per_section = sum(np.split(amount, 2, axis=1), np.zeros((1, 1)))
        return np.asarray(self.held_density * per_section @ setting.share.T)

    @cached_property
    def distributed_mass(self) -> float:
        """Mass along the rod, the fluid's by its mean over the motion [kg]."""
        held = self._held(self.network.pressure) if self.held_density else np.zeros((1, 1))
        mean = float(np.mean(np.sum(held, axis=1)))
        return self.setting.mass_per_length * self.setting.length + mean

    def head(self, axis: Axis) -> np.ndarray:
        """Pressure that the weight of the fluid adds in every bellow (T, B) [Pa]."""
        depth = (axis.middle @ np.array(self.acceleration)) @ self.setting.share
        return self.held_density * np.concatenate([depth, depth], axis=1)

    def elastic_strains(self, axis: Axis, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch (T, K) that balance forces (T, K, 2) at the ends of the pieces."""
        setting, middle, nodes = self.setting, axis.middle, axis.nodes
        carried = _sum_to_tip(force)
        torque = _sum_to_tip(nodes[..., 1] * force[..., 0] - nodes[..., 0] * force[..., 1])
        moment = torque - (middle[..., 1] * carried[..., 0] - middle[..., 0] * carried[..., 1])
        normal = np.sum(axis.direction * carried, axis=-1)
        length = setting.length / nodes.shape[1]
        most = LARGEST_LOAD_TURN
        bending, extension = setting.piece_stiffnesses
        turn = np.clip(moment / bending * length, -most, most)
        return turn / length, normal / extension

    def shear_angles(self, axis: Axis, force: np.ndarray) -> np.ndarray | None:
        """Shear of the pieces (T, K) [rad] by the same forces; None where they do not shear."""
        if self.shear_compliance == 0.0:
            return None
        across = np.sum(axis.across * _sum_to_tip(force), axis=-1)
        most = LARGEST_SHEAR
        return np.asarray(np.clip(self.shear_compliance * across, -most, most))


def _sum_of_pairs(pairs: Sequence[tuple[float, float]]) -> tuple[float, float]:
    return sum(x for x, _ in pairs), sum(z for _, z in pairs)


def _unloaded(curvature: np.ndarray, stretch: np.ndarray, length: float) -> Axis:
    """The axis of pieces with these total strains (T, K), none of them from loads."""
    stretch = np.maximum(stretch, LEAST_STRETCH)
    nodes, angles = arc_nodes(curvature, stretch, length, 1)
    ends = np.concatenate([np.zeros((len(nodes), 1, 2)), nodes], axis=1)
    turned = angles - curvature * length / 2
    return Axis(
        nodes=nodes,
        middle=(ends[:, 1:] + ends[:, :-1]) / 2,
        direction=np.stack((np.sin(turned), np.cos(turned)), axis=-1),
        stretch=stretch,
        load_curvature=np.zeros_like(curvature),
        load_stretch=np.zeros_like(stretch),
    )


def _sum_to_tip(values: np.ndarray) -> np.ndarray:
    """Sums from each piece to the tip, along the second axis."""
    return np.asarray(np.cumsum(values[:, ::-1], axis=1)[:, ::-1])
