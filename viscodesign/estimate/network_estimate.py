"""Pressures and flows of the network, by a linear one with mean properties."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from viscodesign.estimate.linear_network import LinearNetworks, UniformNetworks
from viscodesign.estimate.network_averages import averaged
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.term import CompressibleFluid, EstimateTerm, LossLaw, WallLaw
from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class AveragedNetwork:
    """One of several networks that were averaged side by side."""

    networks: LinearNetworks | UniformNetworks
    row: int
    pressure: np.ndarray
    """Gauge pressures of all bellows, without feedback of the rod (B, T) [Pa]."""


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

    @cached_property
    def key(self) -> tuple[object, ...]:
        """Everything that the pressures depend on, within one setting."""
        laws = (self.distributed, self.wall, self.fluid)
        return (*laws, self.storage, self.losses, self.inertance)

    @property
    def is_nonlinear(self) -> bool:
        """Whether any law enters by its mean."""
        return self.wall is not None or self.fluid is not None or bool(self.losses)

    @property
    def averaged(self) -> AveragedNetwork:
        """The network with its means over the motion, and its pressures."""
        return average_all([self])[0]

    @property
    def pressure(self) -> np.ndarray:
        """Gauge pressures of all bellows, without feedback of the rod (T, B) [Pa]."""
        return self.averaged.pressure.T

    def flows(self) -> np.ndarray:
        """Flows of all tubes (T, Q) [m3/s]."""
        networks = self._alone
        return np.asarray(networks.flows(networks.pressures())[0].T)

    def tube_pressures(self) -> np.ndarray:
        """Mean gauge pressures of all tubes (T, Q) [Pa]; pressures must be distributed."""
        networks = self._alone
        assert isinstance(networks, LinearNetworks)
        return np.asarray(networks.tube_pressures(networks.pressures())[0].T)

    @property
    def _alone(self) -> LinearNetworks | UniformNetworks:
        found = self.averaged
        return found.networks.take([found.row])


def average_all(wanted: Sequence[NetworkEstimate]) -> list[AveragedNetwork]:
    """Networks of one setting with their means, those of equal structure side by side."""
    setting = wanted[0].setting
    alike: defaultdict[tuple[bool, tuple[str, ...]], dict[object, NetworkEstimate]]
    alike = defaultdict(dict)
    for one in wanted:
        if one.key not in setting.averages:
            stores = setting.stores(name for name, _ in one.storage)
            alike[one.distributed, stores][one.key] = one
    for group in alike.values():
        networks, pressure = averaged(setting, list(group.values()))
        for row, key in enumerate(group):
            setting.averages[key] = AveragedNetwork(networks, row, pressure[row])
    return [setting.averages[one.key] for one in wanted]


def bellow_pressures(
    found: Sequence[AveragedNetwork], taken: np.ndarray, head: np.ndarray
) -> np.ndarray:
    """Gauge pressures of the bellows (S, B, T) of networks with volumes taken up, and heads."""
    pressure = np.empty_like(taken)
    kinds = {id(one.networks): one.networks for one in found}
    for key, networks in kinds.items():
        own = [k for k, one in enumerate(found) if id(one.networks) == key]
        some = networks.take([found[k].row for k in own])
        pressure[own] = some.pressures(taken[own], head[own])[:, : taken.shape[1]]
    return pressure
