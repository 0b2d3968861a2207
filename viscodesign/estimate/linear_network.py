"""Linear networks solved mode by mode, several side by side."""

from __future__ import annotations

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
    """(S, Q) pressure per rate of flow of each tube; none (S, 0) [kg/m4]."""
    resistance: np.ndarray
    """(S, Q) [Pa s/m3]"""
    impedance: np.ndarray
    """(S, Q) what shapes the modes: resistance, and inertance over a time of the run [Pa s/m3]."""
    start: FilterStart
    tubes: np.ndarray
    """(S, Q, N + U): conductance of each tube between the nodes, to tell flows."""
    ends: np.ndarray
    """(Q, N + U): share that each of them has in the mean pressure of a tube's known ends."""

    def take(self, rows: list[int]) -> LinearNetworks:
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

    def _respond(self, rate: np.ndarray, forced: np.ndarray, modes: np.ndarray) -> np.ndarray:
        """Modes (S, T, N) of all networks, as many filters."""
        drive = forced.swapaxes(0, 1).reshape(len(self.time), -1)
        if self.inertance.size:
            # A mode with the flows f a: (sum I f^2) a' + (sum R f^2) a = rate y, y' = -rate a.
            # Exact where all tubes have one ratio of inertance to resistance.
            flows = (self.tubes[..., : modes.shape[1]] @ modes) ** 2
            lost = (self.resistance[:, None] @ flows + 1e-300)[:, 0]
            delay = (self.inertance[:, None] @ flows)[:, 0] / lost + 1e-30
            numbers = delay.ravel(), (rate**2 / lost).ravel()
            drive = drive * (rate / lost).ravel()
            found = second_order(*numbers, self.time, drive, self.start)
        else:
            found = self._settle(rate.ravel(), drive)
        return found.reshape(len(self.time), *rate.shape).swapaxes(0, 1)

    def _settle(self, rate: np.ndarray, forced: np.ndarray) -> np.ndarray:
        """y' = forced - rate y (T, M)."""
        # What settles far within every step follows at once.
        found = forced / np.where(rate > 0, rate, 1.0)
        settled = np.where(rate > 0, found[0], 0.0)
        slow = rate * self.time[-1] < FAST
        filters = -rate[slow], self.time, forced[:, slow]
        found[:, slow] = first_order(*filters, start_of(self.start, settled[slow], *filters))
        return found

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """Flow of every tube (S, T, Q) [m3/s]."""
        driven = np.asarray(self._above(pressure) @ self.tubes.swapaxes(1, 2))
        if not self.inertance.size:
            return driven
        # Inertance: a flow comes up to what drives it after a while.
        driven = driven * (self.impedance / self.resistance)[:, None]
        delay = (self.inertance / self.resistance).ravel()
        drive = driven.swapaxes(0, 1).reshape(len(self.time), -1)
        filters = -1 / delay, self.time, drive / delay
        found = first_order(*filters, start_of(self.start, drive[0], *filters))
        return found.reshape(len(self.time), *self.resistance.shape).swapaxes(0, 1)

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

    def take(self, rows: list[int]) -> UniformNetworks:
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
