"""The axis of the rod under its pressures and steady loads, for several estimates side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.estimate.laws_by_row import WallsByRow, rows_by_law
from viscodesign.estimate.network_estimate import NetworkEstimate
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass

LARGEST_LOAD_TURN = 3.0
"""Angle by which a load may bend one piece [rad]."""
LARGEST_SHEAR = 1.0
"""Angle by which a load may shear one piece [rad]."""
LOAD_ROUNDS = 2
MIN_STRETCH = 0.05
TINY = 1e-30


@dataclass(frozen=True)
class Axes:
    """S axes as K pieces of arc at T samples; vectors are complex numbers x + i z."""

    nodes: np.ndarray
    """(S, T, K) ends of the pieces [m]."""
    middle: np.ndarray
    """(S, T, K) middles of their chords [m]."""
    direction: np.ndarray
    """(S, T, K) unit tangents at the middles."""
    stretch: np.ndarray
    """(S, T, K)"""
    load_curvature: np.ndarray
    """(S, T, K) curvature by loads [1/m]."""
    load_stretch: np.ndarray
    """(S, T, K) stretch by loads [1]."""

    def take(self, rows: Sequence[int]) -> Axes:
        """Some of the axes, each as often as it is named."""
        return Axes(
            self.nodes[rows],
            self.middle[rows],
            self.direction[rows],
            self.stretch[rows],
            self.load_curvature[rows],
            self.load_stretch[rows],
        )

    def shear_displacement(self, angle: np.ndarray, length: float) -> np.ndarray:
        """How far pieces (S, T, K) of this reference length move their own ends by shear [m]."""
        return np.asarray(-1j * length * self.stretch * angle * self.direction)

    def sheared(self, angle: np.ndarray, length: float) -> Axes:
        """The axes whose pieces (S, T, K) of this reference length also shear."""
        moved = self.shear_displacement(angle, length)
        nodes = np.cumsum(moved, axis=2)
        return replace(self, nodes=self.nodes + nodes, middle=self.middle + nodes - moved / 2)

    def strained(self, curvature: np.ndarray, stretch: np.ndarray) -> Axes:
        """The same places, with more elastic strain (S, T, K) from loads."""
        return replace(
            self,
            load_curvature=self.load_curvature + curvature,
            load_stretch=self.load_stretch + stretch,
        )


Loads = tuple[complex, complex, float, float, float]
"""Acceleration x + i z [m/s2], tip force x + i z [N], tip mass [kg], held density [kg/m3], shear
angle per force [1/N]."""


def loads_of(terms: Sequence[EstimateTerm]) -> Loads:
    """The sums of all terms."""
    return (
        sum((complex(*term.acceleration) for term in terms), 0j),
        sum((complex(*term.tip_force) for term in terms), 0j),
        sum(term.tip_mass for term in terms),
        sum(term.held_density for term in terms),
        sum(term.shear_compliance for term in terms),
    )


class LoadEstimates:
    """Masses and steady forces on S rods, and the axes that they bend."""

    def __init__(
        self, setting: EstimateSetting, networks: Sequence[NetworkEstimate], loads: Sequence[Loads]
    ) -> None:
        self.setting = setting
        acceleration, force, tip_mass, density, shear = zip(*loads, strict=True)
        self.acceleration, self.tip_force = np.array(acceleration), np.array(force)
        self.tip_mass, self.held_density = np.array(tip_mass), np.array(density)
        self.shear_compliance = np.array(shear)
        self._bellow = WallsByRow(setting, [one.wall for one in networks])
        self._fluids = list(rows_by_law([one.fluid for one in networks]))

    @property
    def has_head(self) -> bool:
        """Whether the fluid's weight presses in any of them."""
        return bool(np.any(self.held_density * np.abs(self.acceleration)))

    def axes_at(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> Axes:
        """The axes at pressures (S, T, B); ``uptake``: volumes that the rod adds [m3]."""
        setting = self.setting
        curvature, stretch = (s @ setting.spread.T for s in self._strains(pressure))
        length = setting.length / setting.pieces
        force = self.masses(pressure, uptake) * self.acceleration[:, None, None]
        force[..., -1] += self.tip_force[:, None]
        axes = _unloaded(curvature, 1 + stretch, length)
        for _ in range(LOAD_ROUNDS if np.any(force) else 0):
            bent, drawn = self.elastic_strains(axes, force)
            shear = self.shear_angles(axes, force)
            axes = _unloaded(curvature + bent, 1 + stretch + drawn, length)
            axes = replace(axes, load_curvature=bent, load_stretch=drawn)
            axes = axes if shear is None else axes.sheared(shear, length)
        return axes

    def _strains(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch of every section (S, T, sections)."""
        _, bend, extend = self._bellow(pressure)
        sections = self.setting.sections
        return (
            bend[..., sections:] - bend[..., :sections],
            extend[..., sections:] + extend[..., :sections],
        )

    def masses(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Masses at the ends of the pieces (S, T or 1, K) [kg]."""
        setting = self.setting
        own = setting.piece_masses * setting.length / setting.pieces
        mass = own * np.ones((len(pressure), 1, setting.pieces))
        mass[..., -1] = mass[..., -1] / 2 + self.tip_mass[:, None]
        return np.asarray(mass + self._held(pressure, uptake))

    def _held(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Mass of the fluid in every piece (S, T, K); (S, 1, K) where none of it counts [kg]."""
        setting, density = self.setting, self.held_density
        if not density.any():
            return np.zeros((len(pressure), 1, setting.pieces))
        volume = setting.rest_volume + self._bellow(pressure)[0]
        amount = np.maximum(volume if uptake is None else volume + uptake, 0.0)
        for fluid, rows in self._fluids:
            if fluid is not None:
                amount[rows] *= fluid.density(pressure[rows], setting.ambient)
        per_section = amount[..., : setting.sections] + amount[..., setting.sections :]
        return np.asarray(density[:, None, None] * per_section @ setting.share.T)

    def distributed_mass(self, pressure: np.ndarray) -> np.ndarray:
        """Mass along the rods (S,), the fluid's by its mean over the motion [kg]."""
        mean = np.mean(np.sum(self._held(pressure), axis=2), axis=1)
        return np.asarray(self.setting.mass_per_length * self.setting.length + mean)

    def head(self, axes: Axes) -> np.ndarray:
        """Pressure that the weight of the fluid adds in every bellow (S, T, B) [Pa]."""
        down = self.acceleration.conj()[:, None, None]
        depth = (axes.middle * down).real @ self.setting.share
        both = np.concatenate([depth, depth], axis=-1)
        return np.asarray(self.held_density[:, None, None] * both)

    def elastic_strains(self, axes: Axes, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch that balance forces (S, T, K) at the ends of the pieces."""
        setting = self.setting
        carried = _sum_to_tip(force)
        torque = _sum_to_tip((axes.nodes.conj() * force).imag)
        moment = (axes.middle.conj() * carried).imag - torque
        normal = (axes.direction.conj() * carried).real
        length = setting.length / setting.pieces
        most = LARGEST_LOAD_TURN
        bending, extension = setting.piece_stiffnesses
        turn = np.clip(moment * (length / bending), -most, most)
        return turn / length, normal / extension

    def shear_angles(self, axes: Axes, force: np.ndarray) -> np.ndarray | None:
        """Shear of the pieces (S, T, K) [rad] by the same forces; None where none shears."""
        if not self.shear_compliance.any():
            return None
        across = -(axes.direction.conj() * _sum_to_tip(force)).imag
        angle = self.shear_compliance[:, None, None] * across
        return np.asarray(np.clip(angle, -LARGEST_SHEAR, LARGEST_SHEAR))


def _unloaded(curvature: np.ndarray, stretch: np.ndarray, length: float) -> Axes:
    """The axes of pieces with these total strains (S, T, K), none of them from loads."""
    stretch = np.maximum(stretch, MIN_STRETCH)
    half_turn = curvature * (length / 2)
    middle_turn = 2 * np.cumsum(half_turn, axis=2) - half_turn
    # The sine of an angle over the angle, also at zero.
    angle = np.where(half_turn == 0.0, TINY, half_turn)
    direction = np.empty(curvature.shape, dtype=complex)
    direction.real, direction.imag = np.sin(middle_turn), np.cos(middle_turn)
    chord = length * stretch * (np.sin(angle) / angle) * direction
    nodes = np.cumsum(chord, axis=2)
    nothing = np.zeros_like(curvature)
    return Axes(nodes, nodes - chord / 2, direction, stretch, nothing, nothing)


def _sum_to_tip(values: np.ndarray) -> np.ndarray:
    """Sums from each piece to the tip, along the third axis."""
    return np.asarray(np.cumsum(values[..., ::-1], axis=2)[..., ::-1])
