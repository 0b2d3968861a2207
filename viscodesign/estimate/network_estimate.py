"""Pressures and flows of the network, by a linear one with mean properties."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from viscodesign.estimate.linear_network import LinearNetwork, UniformNetwork
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import CompressibleFluid, EstimateTerm, LossLaw, WallLaw
from viscodesign.lazy_dataclass import dataclass

AVERAGING_ROUNDS = 6
"""Rounds in which means over the motion converge, to a few thousandths."""
LEAST_PRESSURE = 0.02
"""Absolute pressure, in parts of the ambient, below which a linear network is not followed."""
LEAST_VOLUME = 0.02
"""The same for a bellow's volume, in parts of that at rest."""


@dataclass(frozen=True)
class NetworkEstimate:
    """The network's sums, and the pressures that follow from them.

    Laws that are not linear (gas, wall, loss) enter by their mean over the motion.
    """

    setting: EstimateSetting
    distributed: bool
    wall: WallLaw | None
    fluid: CompressibleFluid | None
    storage: tuple[tuple[str, float], ...]
    losses: tuple[LossLaw, ...]
    inertance: tuple[float, ...]

    @classmethod
    def of(cls, setting: EstimateSetting, terms: Sequence[EstimateTerm]) -> NetworkEstimate:
        """The sums of all terms."""
        storage: defaultdict[str, float] = defaultdict(float)
        for node, stored in (entry for term in terms for entry in term.storage):
            storage[node] += stored
        inertances = [term.inertance for term in terms if term.inertance]
        return cls(
            setting,
            any(term.distributed for term in terms),
            next((term.wall for term in reversed(terms) if term.wall), None),
            next((term.fluid for term in reversed(terms) if term.fluid), None),
            tuple(sorted(storage.items())),
            tuple(term.flow_loss for term in terms if term.flow_loss),
            tuple(map(sum, zip(*inertances, strict=True))),
        )

    @property
    def pressure(self) -> np.ndarray:
        """Gauge pressures of all bellows, without feedback of the rod (T, B) [Pa]."""
        return self.averaged[1]

    @property
    def averaged(self) -> tuple[LinearNetwork | UniformNetwork, np.ndarray]:
        """The network with its means over the motion, and its pressures (T, B) [Pa]."""
        return self.setting.remembered(self.key, self._average)

    @property
    def key(self) -> tuple[object, ...]:
        """Everything that the pressures depend on, within one setting."""
        laws = (self.distributed, self.wall, self.fluid)
        return (*laws, self.storage, self.losses, self.inertance)

    def flows(self) -> np.ndarray:
        """Flows of all tubes (T, Q) [m3/s]."""
        network, _ = self.averaged
        return network.flows(network.pressures())

    def bellow(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest [m3], curvature [1/m] and stretch [1] of bellows at pressures."""
        if self.wall is not None:
            return self.wall(pressure)
        setting = self.setting
        return (
            setting.compliance * pressure,
            setting.curvature * pressure,
            setting.stretch * pressure,
        )

    def _average(self) -> tuple[LinearNetwork | UniformNetwork, np.ndarray]:
        """Means over the motion follow from it, and it from them.

        Always the same number of rounds from the same start: the remainder of the
        iteration is then alike in two estimates, and their difference shows the term.
        """
        setting = self.setting
        compliance = np.full(setting.bellows, setting.compliance)
        multiplier = np.ones(len(setting.resistance))
        network = self._linear(compliance, multiplier)
        pressure = network.pressures()
        for _ in range(AVERAGING_ROUNDS if self._is_nonlinear() else 0):
            thinness = np.ones(len(multiplier))
            if isinstance(network, LinearNetwork):
                flow = network.flows(pressure)
                if self.losses:
                    multiplier = np.sqrt(multiplier * self._mean_loss(flow))
                thinness = self._thinness(network.tube_pressures(pressure), flow)
            compliance = self._mean_compliance(pressure[:, : setting.bellows])
            network = self._linear(compliance, multiplier * thinness)
            pressure = network.pressures()
        return network, pressure[:, : setting.bellows]

    def _is_nonlinear(self) -> bool:
        return self.wall is not None or self.fluid is not None or bool(self.losses)

    def _linear(
        self, compliance: np.ndarray, multiplier: np.ndarray
    ) -> LinearNetwork | UniformNetwork:
        return self.setting.network(
            compliance,
            multiplier,
            dict(self.storage),
            np.array(self.inertance),
            uniform=not self.distributed,
        )

    def _mean_loss(self, flow: np.ndarray) -> np.ndarray:
        """Loss of every tube over that of slow laminar flow, from flows (T, Q) (Q,)."""
        first, *others = self.losses
        loss = first(flow)
        for law in others:
            loss = loss + law(flow) - 1
        return _mean_by_work(loss, flow, self.setting.time)

    def _thinness(self, pressure: np.ndarray, flow: np.ndarray) -> np.ndarray:
        """Mean density of the fluid in all tubes over that in each (Q,).

        In a row of tubes the thinner gas flows faster, and loses more of the pressure.
        """
        if self.fluid is None:
            return np.ones(flow.shape[1])
        setting = self.setting
        gauge = self._absolute(pressure) - setting.ambient
        ratios = np.asarray(self.fluid.density(gauge, setting.ambient))
        density = _mean_by_work(ratios, flow, setting.time)
        return np.asarray(np.mean(density) / density)

    def _absolute(self, pressure: np.ndarray) -> np.ndarray:
        """Absolute pressures; a linear network knows no vacuum [Pa]."""
        ambient = self.setting.ambient
        return np.maximum(ambient + pressure, LEAST_PRESSURE * ambient)

    def _mean_compliance(self, pressure: np.ndarray) -> np.ndarray:
        """Volume per pressure of every bellow, over its own range of pressures (B,) [m3/Pa]."""
        setting = self.setting
        low, high = pressure.min(axis=0), pressure.max(axis=0)
        spread = np.maximum(high - low, 1e-3 * setting.swing)
        middle = (low + high) / 2
        ends = [self.bellow(middle + side * spread / 2)[0] for side in (-1, 1)]
        stored = np.maximum((ends[1] - ends[0]) / spread, 1e-3 * setting.compliance)
        volume = setting.rest_volume + self.bellow(pressure)[0]
        if self.fluid is not None:
            volume = np.maximum(volume, LEAST_VOLUME * setting.rest_volume)
            moved = np.abs(np.diff(pressure, axis=0)) + 1e-9 * setting.swing
            own = self.fluid.compliance(volume, self._absolute(pressure))[1:]
            stored = stored + np.sum(own * moved, axis=0) / np.sum(moved, axis=0)
        return np.asarray(stored)


def _mean_by_work(values: np.ndarray, flow: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Means (Q,) of values (T, Q) over the motion, weighted by the work that slow flow takes."""
    # A jump's first instant would count for a whole step: the later end represents it.
    work = flow[1:] ** 2 * np.diff(time)[:, None] + 1e-300
    return np.asarray(np.sum(values[1:] * work, axis=0) / np.sum(work, axis=0))
