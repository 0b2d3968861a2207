"""Linear networks solved mode by mode, several side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.estimate.modal_response import FilterStart, first_order, second_order, start_of
from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property

FAST = 1e5
"""Rate times run from which a mode is taken as settled."""


@dataclass(frozen=True)
class LinearNetworks:
    """S networks of N nodes that store, driven by U pressures; amounts relative to the start's.

    ``conductance`` (S, N, N) with held pressures on the diagonal, ``feed`` (S, N, U)
    [m3/(Pa s)], ``capacity`` (S, N) [m3/Pa], ``drive`` (T, U) pressures above the baseline,
    ``pushed`` (T, N) volume that plungers push into a node [m3].
    """

    time: np.ndarray
    conductance: np.ndarray
    feed: np.ndarray
    capacity: np.ndarray
    drive: np.ndarray
    pushed: np.ndarray
    baseline: float
    inertance: np.ndarray
    """(S, Q) pressure per rate of flow of each tube; a network has one in all tubes, or zeros
    [kg/m4]."""
    resistance: np.ndarray
    """(S, Q) [Pa s/m3]"""
    impedance: np.ndarray
    """(S, Q) what shapes the modes: resistance, and inertance over a time of the run [Pa s/m3]."""
    start: FilterStart
    tubes: np.ndarray
    """(S, Q, N + U): conductance of each tube between the nodes, to tell flows."""
    ends: np.ndarray
    """(Q, N + U): share that each of them has in the mean pressure of a tube's known ends."""

    def take(self, rows: Sequence[int] | np.ndarray) -> LinearNetworks:
        """Some of the networks, each as often as it is named."""
        names = "conductance", "feed", "capacity", "inertance", "resistance", "impedance", "tubes"
        return replace(self, **{name: getattr(self, name)[rows] for name in names})

    def pressures(
        self, taken: np.ndarray | None = None, head: np.ndarray | None = None
    ) -> np.ndarray:
        """Gauge pressures (S, T, N).

        ``taken`` (S, T, B) volumes that the bellows take up besides; ``head`` (S, T, B) pressure
        that the fluid's weight gives them against the inlet. Bellows are the first nodes.
        """
        # y = p - given / capacity has no derivative of what is given: C y' = -G p + feed u.
        # The mean mode of a sealed part has the rate zero and stays: its amount is kept.
        root, rate, modes = self._modes
        jump = given_volumes(self.pushed, taken) / self.capacity[:, None]
        pull = self.drive @ self.feed.swapaxes(1, 2) - jump @ self.conductance
        if head is not None:
            pull = pull + head @ self.conductance[:, : head.shape[-1]]
        forced = (pull / root[:, None]) @ modes
        found = self._respond(rate, forced, modes / root[..., None])
        return np.asarray(self.baseline + (found @ modes.swapaxes(1, 2)) / root[:, None] + jump)

    @cached_property
    def _modes(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Roots of the capacities (S, N), rates (S, N) and modes (S, N, N) at rest."""
        root = np.sqrt(self.capacity)
        matrix = self.conductance / (root[:, :, None] * root[:, None])
        rate, modes = np.linalg.eigh((matrix + matrix.swapaxes(1, 2)) / 2)
        return root, np.where(rate < 1e-12 * np.maximum(rate[:, -1:], 1e-300), 0.0, rate), modes

    @cached_property
    def _has_inertance(self) -> np.ndarray:
        """(S,)"""
        return np.asarray(np.any(self.inertance > 0.0, axis=1))

    def _respond(self, rate: np.ndarray, forced: np.ndarray, modes: np.ndarray) -> np.ndarray:
        """Modes (S, T, N) of all networks, as many filters."""
        drive, found = forced.swapaxes(0, 1), np.empty((len(self.time), *rate.shape))
        late = self._has_inertance
        if late.any():
            found[:, late] = self._swing(rate[late], drive[:, late], modes[late], late)
        if not late.all():
            found[:, ~late] = self._settle(rate[~late], drive[:, ~late])
        return found.swapaxes(0, 1)

    def _swing(
        self, rate: np.ndarray, drive: np.ndarray, modes: np.ndarray, own: np.ndarray
    ) -> np.ndarray:
        """Modes (T, n, N) of networks with inertance, for ``drive`` (T, n, N); ``own`` (S,)."""
        # A mode with the flows f a: (sum I f^2) a' + (sum R f^2) a = rate y, y' = -rate a.
        # Exact where all tubes have one ratio of inertance to resistance.
        flows = (self.tubes[own, :, : modes.shape[1]] @ modes) ** 2
        lost = (self.resistance[own, None] @ flows + 1e-300)[:, 0]
        delay = (self.inertance[own, None] @ flows)[:, 0] / lost + 1e-30
        numbers = delay.ravel(), (rate**2 / lost).ravel()
        filtered = (drive * (rate / lost)).reshape(len(drive), -1)
        return second_order(*numbers, self.time, filtered, self.start).reshape(drive.shape)

    def _settle(self, rate: np.ndarray, drive: np.ndarray) -> np.ndarray:
        """y' = drive - rate y (T, n, N)."""
        rates, forced = rate.ravel(), drive.reshape(len(drive), -1)
        # What settles far within every step follows at once.
        found = forced / np.where(rates > 0, rates, 1.0)
        settled = np.where(rates > 0, found[0], 0.0)
        slow = rates * self.time[-1] < FAST
        filters = -rates[slow], self.time, forced[:, slow]
        found[:, slow] = first_order(*filters, start_of(self.start, settled[slow], *filters))
        return found.reshape(drive.shape)

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """Flow of every tube (S, T, Q) [m3/s]."""
        driven = np.asarray(self._above(pressure) @ self.tubes.swapaxes(1, 2))
        late = self._has_inertance
        if late.any():
            # Inertance: a flow comes up to what drives it after a while.
            driven[late] = self._delayed(driven[late], late)
        return driven

    def _delayed(self, driven: np.ndarray, own: np.ndarray) -> np.ndarray:
        """Flows (n, T, Q) of networks with inertance; ``own`` (S,)."""
        resistance = self.resistance[own]
        driven = driven * (self.impedance[own] / resistance)[:, None]
        delay = (self.inertance[own] / resistance).ravel()
        drive = driven.swapaxes(0, 1).reshape(len(self.time), -1)
        filters = -1 / delay, self.time, drive / delay
        found = first_order(*filters, start_of(self.start, drive[0], *filters))
        return found.reshape(len(self.time), *resistance.shape).swapaxes(0, 1)

    def tube_pressures(self, pressure: np.ndarray) -> np.ndarray:
        """Mean gauge pressure of every tube (S, T, Q), from those of the nodes (S, T, N) [Pa]."""
        return np.asarray(self.baseline + self._above(pressure) @ self.ends.T)

    def _above(self, pressure: np.ndarray) -> np.ndarray:
        """Pressures of nodes and inlets above the baseline (S, T, N + U) [Pa]."""
        drive = np.broadcast_to(self.drive, (len(pressure), *self.drive.shape))
        return np.concatenate([pressure - self.baseline, drive], axis=-1)


@dataclass(frozen=True)
class UniformNetworks:
    """S networks with one pressure per connected part; the same questions."""

    held: np.ndarray
    """(T, N) gauge pressures of nodes that an inlet feeds [Pa]."""
    sealed: tuple[np.ndarray, ...]
    """Indices of the nodes of every sealed part."""
    capacity: np.ndarray
    """(S, N) [m3/Pa]"""
    pushed: np.ndarray
    baseline: float

    def take(self, rows: Sequence[int] | np.ndarray) -> UniformNetworks:
        """Some of the networks, each as often as it is named."""
        return replace(self, capacity=self.capacity[rows])

    def pressures(
        self, taken: np.ndarray | None = None, head: np.ndarray | None = None
    ) -> np.ndarray:
        """Gauge pressures (S, T, N), as for linear networks; a sealed part shares what it holds."""
        given = given_volumes(self.pushed, taken)
        found = np.repeat(self.held[None], len(self.capacity), axis=0)
        for part in self.sealed:
            shared = given[..., part].sum(axis=-1) / self.capacity[:, part].sum(axis=1)[:, None]
            found[..., part] = self.baseline + shared[..., None]
        if head is not None:
            found[..., : head.shape[-1]] += head
        return found

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """None: where the pressure is uniform nothing depends on them (S, T, 0)."""
        return np.zeros((*pressure.shape[:2], 0))


def given_volumes(pushed: np.ndarray, taken: np.ndarray | None) -> np.ndarray:
    """Volumes that plungers push into the nodes (T, N), less what bellows take up (S, T, B)."""
    if taken is None:
        return pushed[None]
    given = np.repeat(pushed[None], len(taken), axis=0)
    given[..., : taken.shape[-1]] -= taken
    return given
