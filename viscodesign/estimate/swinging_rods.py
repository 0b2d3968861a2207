"""Rods with inertia and damping under the pressures of their networks, several side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence

import numpy as np

from viscodesign.estimate.loaded_axis import Axes, LoadEstimates, loads_of
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
        self._setting = setting
        self._networks = networks
        self._loads_of_each = [loads_of(own) for own in terms]
        self._loads = LoadEstimates(setting, networks, self._loads_of_each)
        self._has_inertia = _each(terms, lambda t: t.resists_acceleration) > 0
        self._damping_time = _each(terms, lambda t: t.damping_time)
        bellows = np.zeros(setting.bellows)
        self._per_force = _each(terms, lambda t: bellows + t.volume_per_force)
        self._per_moment = _each(terms, lambda t: bellows + t.volume_per_moment)
        self._added_mass = np.array([_added_mass(setting.length, own) for own in terms])

    @cached_property
    def _pressure(self) -> np.ndarray:
        """Gauge pressures of all bellows, without feedback of the rod (S, T, B) [Pa]."""
        return np.array([found.pressure for found in average_all(self._networks)])

    def tips(self) -> np.ndarray:
        """The tips x + i z at every sample (S, T) [m]."""
        tip, moved = self._moving(self._first_axes())
        takes_up = np.any(self._per_force) or np.any(self._per_moment)
        if not (takes_up or self._loads.has_head):
            return tip
        uptake = self._volumes_taken_up(moved)
        found = average_all(self._networks)
        pressure = bellow_pressures(found, uptake, self._loads.head(moved))
        return self._moving(self._loads.axes_at(pressure, uptake))[0]

    def _first_axes(self) -> Axes:
        """The axes at the networks' pressures, those of equal networks and loads once."""
        networks, loads, first = self._networks, self._loads_of_each, dict[Hashable, int]()
        own = [first.setdefault((networks[k].key, loads[k]), k) for k in range(len(loads))]
        rows = list(first.values())
        some = LoadEstimates(
            self._setting, [networks[k] for k in rows], [loads[k] for k in rows]
        ).axes_at(self._pressure[rows])
        return some.take([rows.index(k) for k in own])

    # -- inertia and damping ----------------------------------------------------

    def _moving(self, axes: Axes) -> tuple[np.ndarray, Axes]:
        """Tips (S, T), and the axes with the elastic strains that loads and inertia give."""
        tip = axes.nodes[..., -1]
        creeping = np.flatnonzero(~self._has_inertia & (self._damping_time > 0.0))
        if creeping.size:
            tip = tip.copy()
            tip[creeping] += self._creep_lag(tip[creeping], self._damping_time[creeping])
        if not np.any(self._has_inertia):
            return tip, axes
        # Inertial forces of the first mode are its stiffness times its lag.
        lag = self._modal_lag(axes.nodes, self.bending_rate, self._setting.straight)
        inertial = self._masses * self.bending_rate[:, None, None] ** 2 * lag
        bent, drawn = self._loads.elastic_strains(axes, inertial)
        moved = self._tip_displacement(axes, bent, drawn) + self._stretching_lag(axes)
        shear = self._loads.shear_angles(axes, inertial)
        if shear is not None:
            length = self._setting.length / self._setting.pieces
            moved = moved + axes.shear_displacement(shear, length).sum(axis=2)
        return tip + moved, axes.strained(bent, drawn)

    def _tip_displacement(self, axes: Axes, bent: np.ndarray, drawn: np.ndarray) -> np.ndarray:
        """How far small strains of the pieces move the tips (S, T) [m]."""
        setting, most = self._setting, self._setting.length
        turned = -1j * (axes.nodes[..., -1:] - axes.middle)
        parts = bent * turned + drawn * axes.direction
        moved = np.sum(parts, axis=2) * (setting.length / setting.pieces)
        return np.asarray(np.clip(moved.real, -most, most) + 1j * np.clip(moved.imag, -most, most))

    def _stretching_lag(self, axes: Axes) -> np.ndarray:
        """How far the first stretching mode moves the tips from their static length [m]."""
        setting = self._setting
        extended = axes.stretch.mean(axis=2, keepdims=True) * setting.length
        lag = self._modal_lag(extended, self.axial_rate, np.array([setting.length]))[..., 0]
        chord = axes.nodes[..., -1]
        return np.asarray(lag * chord / np.maximum(np.abs(chord), 1e-3 * setting.length))

    def _modal_lag(self, path: np.ndarray, rate: np.ndarray, rest: np.ndarray) -> np.ndarray:
        """How far a mode departs from its static path (S, T, K); zero without inertia."""
        setting = self._setting
        static = np.ascontiguousarray((path - rest).swapaxes(0, 1))
        # y'' / rate^2 + damping y' + y = static, divided by the damping time.
        damping = np.maximum(self._damping_time, 1e-9 / rate)
        numbers = 1 / (rate**2 * damping), 1 / damping
        # The two coordinates of a vector are channels of their own.
        drive = static.view(float) / damping[:, None]
        followed = second_order(*numbers, setting.time, drive, setting.start).view(static.dtype)
        lag = np.where(self._has_inertia[:, None], followed - static, 0.0)
        return np.asarray(lag.swapaxes(0, 1))

    def _creep_lag(self, path: np.ndarray, time: np.ndarray) -> np.ndarray:
        """How far massless damped rods lag behind their paths (S, T)."""
        setting = self._setting
        static = (path - setting.straight[-1]).swapaxes(0, 1)
        filters = -1 / time, setting.time, static / time
        start = start_of(setting.start, static[0], *filters)
        return np.asarray((first_order(*filters, start) - static).swapaxes(0, 1))

    @cached_property
    def _masses(self) -> np.ndarray:
        return self._loads.masses(self._pressure)

    @cached_property
    def _distributed_mass(self) -> np.ndarray:
        return self._loads.distributed_mass(self._pressure)

    @cached_property
    def bending_rate(self) -> np.ndarray:
        """Angular frequency of the first bending mode (S,) [1/s]."""
        setting = self._setting
        mass = EFFECTIVE_MASS * self._distributed_mass * (1 + self._added_mass)
        stiffness = 3 * setting.bending_stiffness / setting.length**3
        return np.asarray(np.sqrt(stiffness / (mass + self._loads.tip_mass)))

    @cached_property
    def axial_rate(self) -> np.ndarray:
        """Angular frequency of the first stretching mode (S,) [1/s]."""
        mass = 4 / math.pi**2 * self._distributed_mass + self._loads.tip_mass
        stiffness = self._setting.extension_stiffness / self._setting.length
        return np.asarray(np.sqrt(stiffness / mass))

    # -- feedback of the rod to the fluid ---------------------------------------

    def _volumes_taken_up(self, axes: Axes) -> np.ndarray:
        """Volumes that the forces in the axes give the bellows (S, T, B) [m3]."""
        setting = self._setting
        bending, extension = setting.piece_stiffnesses
        moment = bending * axes.load_curvature @ setting.share
        normal = extension * axes.load_stretch @ setting.share
        force = self._per_force[:, None] * np.concatenate([normal, normal], axis=-1)
        return np.asarray(
            force + self._per_moment[:, None] * np.concatenate([-moment, moment], axis=-1)
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
