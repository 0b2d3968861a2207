"""The axis of the rod under its pressures and steady loads, for several estimates side by side."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.estimate.axis_loops import axes_laid, axes_strained, moment_of, sum_to_tip
from viscodesign.estimate.laws_by_row import Rows, WallsByRow, rows_by_law
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


@dataclass(frozen=True)
class Axes:
    """S axes as K pieces of arc at T samples: numbers (S, K, T), and vectors (S, 2, K, T) with
    their parts x and z.
    """

    nodes: np.ndarray
    """Vectors to the ends of the pieces [m]."""
    middle: np.ndarray
    """Vectors to the middles of their chords [m]."""
    direction: np.ndarray
    """Unit tangents at the middles."""
    stretch: np.ndarray
    load_curvature: np.ndarray
    """Curvature by loads [1/m]."""
    load_stretch: np.ndarray
    """Stretch by loads [1]."""

    @property
    def tip(self) -> np.ndarray:
        """Vectors to the tips (S, 2, T) [m]."""
        return np.asarray(self.nodes[:, :, -1])

    def take(self, rows: Rows) -> Axes:
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
        """How far pieces (S, K, T) of this reference length move their own ends by shear [m]."""
        return np.asarray((length * self.stretch * angle)[:, None] * turned_back(self.direction))

    def sheared(self, angle: np.ndarray, length: float) -> Axes:
        """The axes whose pieces (S, K, T) of this reference length also shear."""
        moved = self.shear_displacement(angle, length)
        nodes = np.tri(moved.shape[2]) @ moved
        return replace(self, nodes=self.nodes + nodes, middle=self.middle + nodes - moved / 2)

    def strained(self, curvature: np.ndarray, stretch: np.ndarray) -> Axes:
        """The same places, with more elastic strain (S, K, T) from loads."""
        return replace(
            self,
            load_curvature=self.load_curvature + curvature,
            load_stretch=self.load_stretch + stretch,
        )


def turned_back(vectors: np.ndarray) -> np.ndarray:
    """Vectors (S, 2, ...) a quarter turn back, from z to x."""
    return np.stack([vectors[:, 1], -vectors[:, 0]], axis=1)


Loads = tuple[tuple[float, float], tuple[float, float], float, float, float]
"""Acceleration (x, z) [m/s2], tip force (x, z) [N], tip mass [kg], held density [kg/m3], shear
angle per force [1/N]."""


def loads_of(terms: Sequence[EstimateTerm]) -> Loads:
    """The sums of all terms."""
    return (
        _sum_of_vectors(term.acceleration for term in terms),
        _sum_of_vectors(term.tip_force for term in terms),
        sum(term.tip_mass for term in terms),
        sum(term.held_density for term in terms),
        sum(term.shear_compliance for term in terms),
    )


def _sum_of_vectors(vectors: Iterable[tuple[float, float]]) -> tuple[float, float]:
    x, z = 0.0, 0.0
    for own_x, own_z in vectors:
        x, z = x + own_x, z + own_z
    return x, z


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
    def has_head(self) -> np.ndarray:
        """Whether the fluid's weight presses in its bellows (S,)."""
        return np.asarray((self.held_density != 0.0) & np.any(self.acceleration, axis=1))

    def axes_at(
        self,
        pressure: np.ndarray,
        masses: np.ndarray | None = None,
        uptake: np.ndarray | None = None,
    ) -> Axes:
        """The axes at pressures (S, B, T); ``masses``: those at these pressures, where known.

        ``uptake``: volumes that the rod adds [m3].
        """
        setting = self.setting
        curvature, stretch = (setting.spread @ s for s in self._strains(pressure))
        stretch += 1
        length = setting.length / setting.pieces
        force = self.masses(pressure, uptake) if masses is None else masses
        force = force[:, None] * self.acceleration[..., None, None]
        force[:, :, -1] += self.tip_force[..., None]
        axes = _unloaded(curvature, stretch, length)
        for _ in range(LOAD_ROUNDS if np.any(force) else 0):
            bent, drawn = self.elastic_strains(axes, force)
            shear = self.shear_angles(axes, force)
            axes = _unloaded(curvature + bent, stretch + drawn, length)
            axes = replace(axes, load_curvature=bent, load_stretch=drawn)
            axes = axes if shear is None else axes.sheared(shear, length)
        return axes

    def _strains(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch of every section (S, sections, T)."""
        _, bend, extend = self._bellow(pressure)
        sections = self.setting.sections
        return (
            bend[:, sections:] - bend[:, :sections],
            extend[:, sections:] + extend[:, :sections],
        )

    def masses(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Masses at the ends of the pieces (S, K, T or 1) [kg]."""
        setting = self.setting
        own = setting.piece_masses * setting.length / setting.pieces
        mass = own * np.ones((len(pressure), setting.pieces))
        mass[:, -1] = mass[:, -1] / 2 + self.tip_mass
        return np.asarray(mass[..., None] + self._held(pressure, uptake))

    def _held(self, pressure: np.ndarray, uptake: np.ndarray | None = None) -> np.ndarray:
        """Mass of the fluid in every piece (S, K, T); (S, K, 1) where none of it counts [kg]."""
        setting, density = self.setting, self.held_density
        if not density.any():
            return np.zeros((len(pressure), setting.pieces, 1))
        volume = np.reshape(setting.rest_volume, (-1, 1)) + self._bellow(pressure)[0]
        amount = np.maximum(volume if uptake is None else volume + uptake, 0.0)
        for fluid, rows in self._fluids:
            if fluid is not None:
                amount[rows] *= fluid.density(pressure[rows], setting.ambient)
        per_section = amount[:, : setting.sections] + amount[:, setting.sections :]
        return np.asarray(density[:, None, None] * (setting.share @ per_section))

    def distributed_mass(self, pressure: np.ndarray) -> np.ndarray:
        """Mass along the rods (S,), the fluid's by its mean over the motion [kg]."""
        mean = np.mean(np.sum(self._held(pressure), axis=1), axis=1)
        return np.asarray(self.setting.mass_per_length * self.setting.length + mean)

    def head(self, axes: Axes) -> np.ndarray:
        """Pressure that the weight of the fluid adds in every bellow (S, B, T) [Pa]."""
        across, along = (down[:, None, None] for down in self.acceleration.T)
        down = axes.middle[:, 0] * across + axes.middle[:, 1] * along
        depth = self.setting.share.T @ down
        both = np.concatenate([depth, depth], axis=1)
        return np.asarray(self.held_density[:, None, None] * both)

    def elastic_strains(self, axes: Axes, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Curvature and stretch that balance forces (S, 2, K, T or 1) at the ends of the pieces."""
        setting = self.setting
        length = setting.length / setting.pieces
        bending, extension = (own * np.ones(setting.pieces) for own in setting.piece_stiffnesses)
        vectors = axes.nodes, axes.middle, axes.direction
        turned, drawn = axes_strained(
            (bending / length, extension), vectors, force, LARGEST_LOAD_TURN
        )
        return turned / length, drawn

    def shear_angles(self, axes: Axes, force: np.ndarray) -> np.ndarray | None:
        """Shear of the pieces (S, K, T) [rad] by the same forces; None where none shears."""
        if not self.shear_compliance.any():
            return None
        across = moment_of(sum_to_tip(force), axes.direction)
        angle = self.shear_compliance[:, None, None] * across
        return np.asarray(np.clip(angle, -LARGEST_SHEAR, LARGEST_SHEAR))


def _unloaded(curvature: np.ndarray, stretch: np.ndarray, length: float) -> Axes:
    """The axes of pieces with these total strains (S, K, T), none of them from loads."""
    stretch = np.maximum(stretch, MIN_STRETCH)
    nothing = np.zeros_like(curvature)
    return Axes(*axes_laid(curvature, stretch, length), stretch, nothing, nothing)
