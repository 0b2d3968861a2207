"""Rods with inertia and damping under the pressures of their networks, several side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence

import numpy as np

from viscodesign.estimate.laws_by_row import Rows, rows_by_law
from viscodesign.estimate.loaded_axis import Axes, LoadEstimates, loads_of, turned_back
from viscodesign.estimate.modal_response import first_order, second_order, start_of
from viscodesign.estimate.network_estimate import NetworkEstimate, average_all, bellow_pressures
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import EstimateTerm
from viscodesign.model.scene_number import Numbers
from viscodesign.storage.cached_property import cached_property

FIRST_BENDING = 3.5160
"""First root of a clamped-free beam, squared: its angular frequency times t_s."""
EFFECTIVE_MASS = 3 / FIRST_BENDING**2
"""Mass at the tip that would swing at the same frequency, over the beam's mass."""


class SwingingRods:
    """S rods of one setting, by the networks and the terms (S,) of each."""

    def __init__(
        self,
        setting: EstimateSetting,
        networks: Sequence[NetworkEstimate],
        terms: Sequence[Sequence[EstimateTerm]],
    ) -> None:
        self.setting = setting
        self.networks = networks
        self.loads_of_each = [loads_of(own) for own in terms]
        self.loads = LoadEstimates(setting, networks, self.loads_of_each)
        self.has_inertia = _each(terms, lambda t: t.resists_acceleration) > 0
        self.damping_time = _each(terms, lambda t: t.damping_time)
        bellows = np.zeros(setting.bellows)
        self.per_force = _each(terms, lambda t: bellows + t.volume_per_force)
        self.per_moment = _each(terms, lambda t: bellows + t.volume_per_moment)
        self._added_mass = np.array([_added_mass(setting.length, own) for own in terms])

    def tips(self) -> np.ndarray:
        """The tips x, z at every sample (S, 2, T) [m]."""
        found = np.empty((len(self.networks), 2, len(self.setting.time)))
        kinds = zip(self.has_inertia.tolist(), self._changes_pressures.tolist(), strict=True)
        for (_, changes_pressures), rows in rows_by_law(list(kinds)):
            alike = _RodsAlike(self, rows)
            found[rows] = alike.tips(alike.answered() if changes_pressures else alike.axes)
        return found

    @property
    def _changes_pressures(self) -> np.ndarray:
        """Whether forces in the rod, or the weight of the fluid, change the pressures (S,)."""
        takes_up = np.any((self.per_force != 0.0) | (self.per_moment != 0.0), axis=1)
        return np.asarray(takes_up | self.loads.has_head)

    # -- at the networks' pressures, those of equal networks and loads once -------

    @cached_property
    def _kinds(self) -> tuple[list[int], list[int]]:
        """Rods without equal networks and loads, and which of them is like each of all (S,)."""
        first = dict[Hashable, int]()
        keys = [(n.key, own) for n, own in zip(self.networks, self.loads_of_each, strict=True)]
        own = [first.setdefault(key, k) for k, key in enumerate(keys)]
        rows = list(first.values())
        return rows, [rows.index(k) for k in own]

    @cached_property
    def _undisturbed(self) -> tuple[LoadEstimates, np.ndarray, np.ndarray]:
        """Loads, pressures of all bellows [Pa] and masses [kg] of those, without feedback."""
        rows = self._kinds[0]
        networks = [self.networks[k] for k in rows]
        loads = LoadEstimates(self.setting, networks, [self.loads_of_each[k] for k in rows])
        pressure = np.array([found.pressure for found in average_all(networks)])
        return loads, pressure, loads.masses(pressure)

    @cached_property
    def axes(self) -> Axes:
        """The axes of all rods, but for what inertia and feedback do to them."""
        loads, pressure, masses = self._undisturbed
        found, (rows, like) = loads.axes_at(pressure, masses), self._kinds
        return found if len(rows) == len(like) else found.take(np.array(like))

    @cached_property
    def masses(self) -> np.ndarray:
        """Masses at the ends of the pieces (S, K, T or 1) [kg]."""
        return np.asarray(self._undisturbed[2][self._kinds[1]])

    @cached_property
    def _distributed_mass(self) -> np.ndarray:
        loads, pressure, _ = self._undisturbed
        return loads.distributed_mass(pressure)[self._kinds[1]]

    @cached_property
    def bending_rate(self) -> np.ndarray:
        """Angular frequency of the first bending mode (S,) [1/s]."""
        setting = self.setting
        mass = EFFECTIVE_MASS * self._distributed_mass * (1 + self._added_mass)
        stiffness = 3 * setting.bending_stiffness / setting.length**3
        return np.asarray(np.sqrt(stiffness / (mass + self.loads.tip_mass)))

    @cached_property
    def axial_rate(self) -> np.ndarray:
        """Angular frequency of the first stretching mode (S,) [1/s]."""
        mass = 4 / math.pi**2 * self._distributed_mass + self.loads.tip_mass
        stiffness = self.setting.extension_stiffness / self.setting.length
        return np.asarray(np.sqrt(stiffness / mass))


class _RodsAlike:
    """Some of the rods (n,): all with inertia or all without."""

    def __init__(self, rods: SwingingRods, rows: Rows) -> None:
        self._setting = rods.setting
        own = np.arange(len(rods.networks))[rows]
        self._networks = [rods.networks[k] for k in own]
        loads = [rods.loads_of_each[k] for k in own]
        self._loads = LoadEstimates(rods.setting, self._networks, loads)
        self._has_inertia = bool(rods.has_inertia[own[0]])
        self._damping_time = rods.damping_time[rows]
        self._per_force, self._per_moment = rods.per_force[rows], rods.per_moment[rows]
        self.axes = rods.axes.take(rows)
        self._masses = rods.masses[rows]
        self._bending_rate, self._axial_rate = rods.bending_rate[rows], rods.axial_rate[rows]

    def tips(self, axes: Axes) -> np.ndarray:
        """Tips (n, 2, T) of rods that would be at these axes without inertia and damping [m]."""
        tip = axes.tip
        if not self._has_inertia:
            return self._crept(tip)
        inertial = self._inertial(axes)
        bent, drawn = self._loads.elastic_strains(axes, inertial)
        moved = self._tip_displacement(axes, bent, drawn) + self._stretching_lag(axes)
        shear = self._loads.shear_angles(axes, inertial)
        if shear is not None:
            length = self._setting.length / self._setting.pieces
            moved += axes.shear_displacement(shear, length).sum(axis=2)
        return np.asarray(tip + moved)

    # -- inertia and damping ----------------------------------------------------

    def _inertial(self, axes: Axes) -> np.ndarray:
        """Inertial forces at the ends of the pieces (n, 2, K, T): the first mode's stiffness times
        its lag [N].
        """
        lag = self._modal_lag(axes.nodes - self._setting.straight[..., None], self._bending_rate)
        lag *= (self._masses * self._bending_rate[:, None, None] ** 2)[:, None]
        return lag

    def _tip_displacement(self, axes: Axes, bent: np.ndarray, drawn: np.ndarray) -> np.ndarray:
        """How far small strains of the pieces move the tips (n, 2, T) [m]."""
        setting, most = self._setting, self._setting.length
        turned = turned_back(axes.tip[:, :, None] - axes.middle)
        parts = bent[:, None] * turned + drawn[:, None] * axes.direction
        moved = np.sum(parts, axis=2) * (setting.length / setting.pieces)
        return np.asarray(np.clip(moved, -most, most))

    def _stretching_lag(self, axes: Axes) -> np.ndarray:
        """How far the first stretching mode moves the tips from their static length [m]."""
        length = self._setting.length
        lag = self._modal_lag((axes.stretch.mean(axis=1) - 1) * length, self._axial_rate)
        chord = axes.tip
        size = np.maximum(np.hypot(chord[:, 0], chord[:, 1]), 1e-3 * length)
        return np.asarray((lag / size)[:, None] * chord)

    def _modal_lag(self, static: np.ndarray, rate: np.ndarray) -> np.ndarray:
        """How far a mode departs from its static path (n, ..., T), from the straight rod."""
        setting = self._setting
        # y'' / rate^2 + damping y' + y = static, divided by the damping time.
        damping = np.maximum(self._damping_time, 1e-9 / rate)
        numbers = 1 / (rate**2 * damping), 1 / damping
        drive = static / damping.reshape(-1, *[1] * (static.ndim - 1))
        return np.asarray(second_order(*numbers, setting.time, drive, setting.start) - static)

    def _crept(self, tip: np.ndarray) -> np.ndarray:
        """Tips (n, 2, T) of massless rods, of which the damped ones lag behind their paths."""
        damped, setting = self._damping_time > 0.0, self._setting
        if not damped.any():
            return tip
        rate, static = 1 / self._damping_time[damped], tip[damped] - setting.straight[:, -1:]
        filters = -rate, setting.time, static * rate[:, None, None]
        found = tip.copy()
        found[damped] += first_order(*filters, start_of(setting.start, static[..., 0], *filters))
        found[damped] -= static
        return found

    # -- feedback of the rod to the fluid ---------------------------------------

    def answered(self) -> Axes:
        """The axes at pressures that the rod's forces and the fluid's weight have changed."""
        axes = self.axes
        if self._has_inertia:
            axes = axes.strained(*self._loads.elastic_strains(axes, self._inertial(axes)))
        uptake = self._volumes_taken_up(axes)
        found = average_all(self._networks)
        pressure = bellow_pressures(found, uptake, self._loads.head(axes))
        return self._loads.axes_at(pressure, uptake=uptake)

    def _volumes_taken_up(self, axes: Axes) -> np.ndarray:
        """Volumes that the forces in the axes give the bellows (n, B, T) [m3]."""
        setting = self._setting
        bending, extension = (np.reshape(own, (-1, 1)) for own in setting.piece_stiffnesses)
        moment = setting.share.T @ (bending * axes.load_curvature)
        normal = setting.share.T @ (extension * axes.load_stretch)
        force = self._per_force[..., None] * np.concatenate([normal, normal], axis=1)
        return np.asarray(
            force + self._per_moment[..., None] * np.concatenate([-moment, moment], axis=1)
        )


def _each(
    terms: Sequence[Sequence[EstimateTerm]], value: Callable[[EstimateTerm], Numbers]
) -> np.ndarray:
    """Sums over the terms of every rod (S, ...)."""
    nothing = value(EstimateTerm())
    return np.array([sum((value(term) for term in own), nothing) for own in terms], dtype=float)


def _added_mass(length: float, terms: Sequence[EstimateTerm]) -> float:
    """Mass that is added to the first bending mode, relative [1]."""
    is_damped = any(term.damping_time for term in terms)
    return sum(term.modal_mass(length, is_damped) for term in terms if term.modal_mass)
