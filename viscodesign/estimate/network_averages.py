"""Means over the motion of several networks, and the pressures that follow from them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.estimate.laws_by_row import WallsByRow, rows_by_law
from viscodesign.estimate.linear_network import LinearNetworks, UniformNetworks
from viscodesign.estimate.setting import EstimateSetting

if TYPE_CHECKING:
    from viscodesign.estimate.network_estimate import NetworkEstimate

AVERAGING_ROUNDS = 6
"""Rounds in which means over the motion converge at most, to a few thousandths."""
SETTLED = 3e-4
"""Change of a pressure in a round, relative to the swing, after which there is no other round."""
MIN_PRESSURE = 0.02
"""Absolute pressure, relative to the ambient, below which a linear network is not followed."""
MIN_VOLUME = 0.02
"""The same for a bellow's volume, relative to that at rest."""


def averaged(
    setting: EstimateSetting, members: Sequence[NetworkEstimate]
) -> tuple[LinearNetworks | UniformNetworks, np.ndarray]:
    """Networks of equal structure with their means, and pressures of their bellows (S, B, T).

    Means over the motion follow from it, and it from them. Always from the same start, and as many
    rounds where they do not settle: the remainder of the iteration is then alike in two estimates,
    and their difference shows the term. Those of a network that has settled stay, whatever is
    computed beside it.
    """
    averages = _Averages(setting, members)
    networks = averages.networks()
    pressure = _first_pressures(setting, networks, members)
    rows = np.flatnonzero([m.is_nonlinear for m in members])
    if not len(rows):
        return networks, pressure[:, : setting.bellows]
    moving, own, met = averages.take(rows), networks.take(rows), pressure[rows]
    for _ in range(AVERAGING_ROUNDS):
        moving.update(own, met)
        own = moving.networks()
        before, met = met, own.pressures()
        averages.put(rows, moving)
        pressure[rows] = met
        changed = np.max(np.abs(met - before), axis=(1, 2), initial=0.0)
        left = np.flatnonzero(~(changed <= SETTLED * setting.swing))
        if not len(left):
            break
        if len(left) < len(rows):
            rows, moving, own, met = rows[left], moving.take(left), own.take(left), met[left]
    return averages.networks(), pressure[:, : setting.bellows]


def _first_pressures(
    setting: EstimateSetting,
    networks: LinearNetworks | UniformNetworks,
    members: Sequence[NetworkEstimate],
) -> np.ndarray:
    """Pressures (S, N, T) before any mean is known: members differ in what is linear alone."""
    kinds = [(m.distributed, m.storage, m.inertance) for m in members]
    new = {kind: kinds.index(kind) for kind in kinds if kind not in setting.first_pressures}
    if new:
        found = networks.take(list(new.values())).pressures()
        setting.first_pressures.update(zip(new, found, strict=True))
    return np.array([setting.first_pressures[kind] for kind in kinds])


class _Averages:
    """Compliances of bellows and resistances of tubes, by their means."""

    def __init__(self, setting: EstimateSetting, members: Sequence[NetworkEstimate]) -> None:
        self._setting = setting
        self._members = members
        self._bellow = WallsByRow(setting, [m.wall for m in members])
        self._fluids = [(f, r) for f, r in rows_by_law([m.fluid for m in members]) if f]
        self._losses = [(f, r) for f, r in rows_by_law([m.losses for m in members]) if f]
        tubes = len(setting.resistance)
        self._inertance = np.array([m.inertance or (0.0,) * tubes for m in members])
        self._nodes = setting.nodes_storing(name for name, _ in members[0].storage)
        self._stored = setting.stored(self._nodes, [dict(m.storage) for m in members])
        self._compliance = np.full((len(members), setting.bellows), setting.compliance)
        self._multiplier = np.ones((len(members), tubes))
        self._thinness = np.ones_like(self._multiplier)
        self._loss = _Secant()

    def take(self, rows: np.ndarray) -> _Averages:
        """Those of some of the networks (n,)."""
        some = _Averages(self._setting, [self._members[k] for k in rows])
        some._compliance = self._compliance[rows]
        some._multiplier, some._thinness = self._multiplier[rows], self._thinness[rows]
        some._loss = self._loss.take(rows)
        return some

    def put(self, rows: np.ndarray, some: _Averages) -> None:
        """Take over the means of some of the networks (n,)."""
        self._compliance[rows] = some._compliance
        self._multiplier[rows], self._thinness[rows] = some._multiplier, some._thinness

    def networks(self) -> LinearNetworks | UniformNetworks:
        """Those with the present means."""
        return self._setting.networks(
            self._nodes,
            self._stored,
            self._compliance,
            self._multiplier * self._thinness,
            self._inertance,
            uniform=not self._members[0].distributed,
        )

    def update(self, networks: LinearNetworks | UniformNetworks, pressure: np.ndarray) -> None:
        """Means over the motion at pressures (S, N, T)."""
        if isinstance(networks, LinearNetworks) and (self._losses or self._fluids):
            flow = networks.flows(pressure)
            # A jump's first instant would count for a whole step: the later end represents it.
            work = flow[..., 1:] ** 2 * np.diff(self._setting.time) + 1e-300
            share = work / np.sum(work, axis=2, keepdims=True)
            self._lose(flow, share)
            self._thin(networks.tube_pressures(pressure), share)
        self._yield(pressure[:, : self._setting.bellows])

    def _lose(self, flow: np.ndarray, share: np.ndarray) -> None:
        """Loss of every tube over that of slow laminar flow, from flows (S, Q, T)."""
        mean = np.ones_like(self._multiplier)
        for (first, *others), rows in self._losses:
            own = flow[rows].swapaxes(1, 2)
            loss = first(own)
            for law in others:
                loss = loss + law(own) - 1
            mean[rows] = np.sum(loss.swapaxes(1, 2)[..., 1:] * share[rows], axis=2)
        self._multiplier = np.exp(self._loss(np.log(self._multiplier), np.log(mean)))

    def _thin(self, pressure: np.ndarray, share: np.ndarray) -> None:
        """Mean density of the fluid in all tubes over that in each, at pressures (S, Q, T).

        In a row of tubes the thinner gas flows faster, and loses more of the pressure.
        """
        ambient, self._thinness = self._setting.ambient, self._thinness.copy()
        for fluid, rows in self._fluids:
            gauge = self._absolute(pressure[rows]) - ambient
            ratios = np.asarray(fluid.density(gauge, ambient))
            density = np.sum(ratios[..., 1:] * share[rows], axis=2)
            self._thinness[rows] = np.mean(density, axis=1, keepdims=True) / density

    def _absolute(self, pressure: np.ndarray) -> np.ndarray:
        """Absolute pressures; a linear network knows no vacuum [Pa]."""
        ambient = self._setting.ambient
        return np.maximum(ambient + pressure, MIN_PRESSURE * ambient)

    def _yield(self, pressure: np.ndarray) -> None:
        """Volume per pressure of every bellow, over its own range of pressures (S, B, T)."""
        setting = self._setting
        low, high = pressure.min(axis=2), pressure.max(axis=2)
        spread = np.maximum(high - low, 1e-3 * setting.swing)
        ends = ((low + high) / 2)[..., None] + spread[..., None] * np.array([-0.5, 0.5])
        gained = np.diff(self._bellow(ends)[0])[..., 0]
        self._compliance = np.maximum(gained / spread, 1e-3 * setting.compliance)
        if not self._fluids:
            return
        rest = np.reshape(setting.rest_volume, (-1, 1))
        volume = rest + self._bellow(pressure)[0]
        volume = np.maximum(volume, MIN_VOLUME * rest)[..., 1:]
        moved = np.abs(np.diff(pressure)) + 1e-9 * setting.swing
        share = moved / np.sum(moved, axis=2, keepdims=True)
        for fluid, rows in self._fluids:
            own = fluid.compliance(volume[rows], self._absolute(pressure[rows][..., 1:]))
            self._compliance[rows] += np.sum(own * share[rows], axis=2)


FIRST_STEP = 0.5
"""Part of the way to what a value gives that it goes before its slope is known: halfway neither of
both extremes, all lost in the tubes or nothing, is missed by much."""
SLOPES = -1.0, 0.0
"""Slopes of what a value gives by the value that are believed."""


class _Secant:
    """Values that are to be what they give, each sought by its own secant (Wegstein 1958)."""

    def __init__(self, before: tuple[np.ndarray, np.ndarray] | None = None) -> None:
        self._before = before

    def take(self, rows: np.ndarray) -> _Secant:
        """The same for some of the values (n, ...)."""
        if self._before is None:
            return _Secant()
        value, given = self._before
        return _Secant((value[rows], given[rows]))

    def __call__(self, value: np.ndarray, given: np.ndarray) -> np.ndarray:
        """The next values, from the present ones and what they give."""
        part: np.ndarray | float = FIRST_STEP
        if self._before is not None:
            moved = value - self._before[0]
            slope = (given - self._before[1]) / np.where(moved == 0.0, np.inf, moved)
            part = 1 / (1 - np.clip(slope, *SLOPES))
        self._before = value, given
        return np.asarray(value + part * (given - value))
