"""A quick estimate of the motion: good to tens of percent, in milliseconds.

It answers one question: how far does the tip move when a term is added or removed?
Linear throughout, each part exact or a well-known first estimate:

- the network is a linear one, solved mode by mode for the input as it is; what is not
  linear enters by its mean over the motion (`network_estimate`);
- the axis is a row of arcs with the curvature that the pressures give; loads bend it
  further by their moments about it (`loaded_axis`);
- inertial forces are those of the first bending mode and the first stretching mode.

A term contributes to the sums of an estimate as it does to those of the balances
(`EstimateTerm`); which terms exist is not known here.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from viscodesign.estimate.loaded_axis import Axis, LoadEstimate
from viscodesign.estimate.modal_response import first_order, second_order, start_of
from viscodesign.estimate.network_estimate import NetworkEstimate
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers
from viscodesign.storage.cached_property import cached_property

FIRST_BENDING = 3.5160
"""First root of a clamped-free beam, squared: its angular frequency times t_s."""
EFFECTIVE_MASS = 3 / FIRST_BENDING**2
"""Mass at the tip that would swing at the same frequency, over the beam's mass."""


@dataclass(frozen=True)
class MotionEstimate:
    """The motion that follows from a set of terms."""

    setting: EstimateSetting
    terms: tuple[EstimateTerm, ...] = ()

    def plus(self, *terms: EstimateTerm) -> MotionEstimate:
        """The same with more terms."""
        return replace(self, terms=(*self.terms, *terms))

    @cached_property
    def network(self) -> NetworkEstimate:
        """Pressures and flows."""
        return NetworkEstimate.of(self.setting, self.terms)

    @cached_property
    def loads(self) -> LoadEstimate:
        """Masses and steady forces."""
        return LoadEstimate.of(self.network, self.terms)

    @property
    def has_inertia(self) -> bool:
        """Whether masses resist acceleration; without, the rod is quasi-static."""
        return any(term.resists_acceleration for term in self.terms)

    @property
    def damping_time(self) -> float:
        """Retardation time of the rod [s]."""
        return sum(term.damping_time for term in self.terms)

    @cached_property
    def _uptake(self) -> tuple[Numbers, Numbers]:
        """Volume that a bellow takes up per normal force [m3/N] and per moment [m3/(N m)]."""
        terms = self.terms
        return sum(t.volume_per_force for t in terms), sum(t.volume_per_moment for t in terms)

    @cached_property
    def tip(self) -> np.ndarray:
        """The tip at every sample (T, 2) [m]."""
        tip, moved = self._moving(self.loads.axis)
        if self.loads.has_head or any(np.any(own) for own in self._uptake):
            uptake = self._volumes_taken_up(moved)
            pressure = self._pressure_with_feedback(moved, uptake)
            tip, _ = self._moving(self.loads.axis_at(pressure, uptake))
        return tip

    def distance(self, other: MotionEstimate) -> float:
        """Largest distance of the two tips over the output times [m]."""
        apart = (self.tip - other.tip)[self.setting.output_mask]
        found = float(np.max(np.hypot(apart[:, 0], apart[:, 1])))
        return found if math.isfinite(found) else math.inf

    # -- inertia and damping ----------------------------------------------------

    def _moving(self, axis: Axis) -> tuple[np.ndarray, Axis]:
        """Tip (T, 2), and the axis with the elastic strains that loads and inertia give it."""
        tip = axis.nodes[:, -1]
        if not self.has_inertia:
            if self.damping_time > 0.0:
                tip = tip + self._creep_lag(tip)
            return tip, axis
        # Inertial forces of the first mode are its stiffness times its lag.
        rate = self.bending_rate()
        lag = self._modal_lag(axis.nodes, rate, self.setting.straight)
        inertial = self.loads.masses(self.network.pressure)[..., None] * rate**2 * lag
        bent, drawn = self.loads.elastic_strains(axis, inertial)
        moved = self._tip_displacement(axis, bent, drawn) + self._stretching_lag(axis)
        shear = self.loads.shear_angles(axis, inertial)
        if shear is not None:
            length = self.setting.length / shear.shape[1]
            moved = moved + axis.sheared(shear, length).nodes[:, -1] - axis.nodes[:, -1]
        return tip + moved, axis.strained(bent, drawn)

    def _tip_displacement(self, axis: Axis, bent: np.ndarray, drawn: np.ndarray) -> np.ndarray:
        """How far small strains of the pieces move the tip (T, 2) [m]."""
        length = self.setting.length / bent.shape[1]
        arm = axis.nodes[:, -1:, :] - axis.middle
        turned = np.stack((arm[..., 1], -arm[..., 0]), axis=-1)
        parts = bent[..., None] * turned + drawn[..., None] * axis.direction
        limit = self.setting.length
        return np.asarray(np.clip(np.sum(parts, axis=1) * length, -limit, limit))

    def _stretching_lag(self, axis: Axis) -> np.ndarray:
        """How far the first stretching mode moves the tip from its static length (T, 2) [m]."""
        setting = self.setting
        extended = axis.stretch.mean(axis=1, keepdims=True) * setting.length
        lag = self._modal_lag(extended, self.axial_rate(), np.array([setting.length]))
        chord = axis.nodes[:, -1]
        size = np.maximum(np.hypot(chord[:, :1], chord[:, 1:]), 1e-3 * setting.length)
        return np.asarray(lag * chord / size)

    def _modal_lag(self, path: np.ndarray, rate: float, rest: np.ndarray) -> np.ndarray:
        """How far a mode departs from its static path (T, ...)."""
        setting = self.setting
        static = (path - rest).reshape(len(path), -1)
        # y'' / rate^2 + damping y' + y = static, divided by the damping time.
        damping = max(self.damping_time, 1e-9 / rate)
        followed = second_order(
            np.array([1 / (rate**2 * damping)]),
            np.array([1 / damping]),
            setting.time,
            static / damping,
            setting.start,
        )
        return np.asarray(followed - static).reshape(path.shape)

    def _creep_lag(self, path: np.ndarray) -> np.ndarray:
        """How far a massless damped rod lags behind a path (T, M)."""
        setting, time = self.setting, self.damping_time
        static = path - setting.straight[-1]
        filters = np.array([-1 / time]), setting.time, static / time
        start = start_of(setting.start, static[0], *filters)
        return np.asarray(first_order(*filters, start) - static)

    def bending_rate(self) -> float:
        """Angular frequency of the first bending mode [1/s]."""
        length, loads = self.setting.length, self.loads
        laws = [term.modal_mass for term in self.terms if term.modal_mass]
        added = sum(law(length, bool(self.damping_time)) for law in laws)
        mass = EFFECTIVE_MASS * loads.distributed_mass * (1 + added)
        stiffness = 3 * self.setting.bending_stiffness / length**3
        return math.sqrt(stiffness / (mass + loads.tip_mass))

    def axial_rate(self) -> float:
        """Angular frequency of the first stretching mode [1/s]."""
        mass = 4 / math.pi**2 * self.loads.distributed_mass + self.loads.tip_mass
        return math.sqrt(self.setting.extension_stiffness / self.setting.length / mass)

    # -- feedback of the rod to the fluid ---------------------------------------

    def _volumes_taken_up(self, axis: Axis) -> np.ndarray:
        """Volumes that the forces in the axis give the bellows (T, B) [m3]."""
        setting = self.setting
        per_force, per_moment = self._uptake
        bending, extension = setting.piece_stiffnesses
        moment = bending * axis.load_curvature @ setting.share
        normal = extension * axis.load_stretch @ setting.share
        force = per_force * np.concatenate([normal, normal], axis=1)
        return force + per_moment * np.concatenate([-moment, moment], axis=1)

    def _pressure_with_feedback(self, axis: Axis, uptake: np.ndarray) -> np.ndarray:
        """Pressures with volumes that the rod takes up, and with the fluid's head (T, B) [Pa]."""
        network, _ = self.network.averaged
        return network.pressures(uptake, self.loads.head(axis))[:, : self.setting.bellows]
