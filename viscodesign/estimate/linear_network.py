"""A linear network solved mode by mode."""

from __future__ import annotations

import numpy as np

from viscodesign.estimate.modal_response import FilterStart, first_order, second_order, start_of
from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property

FAST = 1e5
"""Rate times run from which a mode is taken as settled."""


@dataclass(frozen=True)
class LinearNetwork:
    """N nodes that store, driven by U pressures; amounts relative to the start's filling.

    ``conductance`` (N, N) with held pressures on the diagonal, ``feed`` (N, U)
    [m3/(Pa s)], ``capacity`` (N,) [m3/Pa], ``drive`` (T, U) pressures above the baseline,
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
    """(Q,) pressure per rate of flow of each tube; none (0,) [kg/m4]."""
    resistance: np.ndarray
    """(Q,) [Pa s/m3]"""
    impedance: np.ndarray
    """(Q,) what shapes the modes: resistance, and inertance over a time of the run [Pa s/m3]."""
    start: FilterStart
    tubes: np.ndarray
    """(Q, N + U): conductance of each tube between the nodes, to tell flows."""
    ends: np.ndarray
    """(Q, N + U): share that each of them has in the mean pressure of a tube's known ends."""

    def pressures(
        self, taken: np.ndarray | None = None, head: np.ndarray | None = None
    ) -> np.ndarray:
        """Gauge pressures (T, N).

        ``taken`` (T, B) volumes that the bellows take up besides; ``head`` (T, B) pressure
        that the fluid's weight gives them against the inlet. Bellows are the first nodes.
        """
        given = self.pushed.copy()
        if taken is not None:
            given[:, : taken.shape[1]] -= taken
        # y = p - given / capacity has no derivative of what is given: C y' = -G p + feed u.
        # The mean mode of a sealed part has the rate zero and stays: its amount is kept.
        root, rate, modes = self._modes
        jump = given / self.capacity
        pull = self.drive @ self.feed.T - jump @ self.conductance
        if head is not None:
            pull = pull + head @ self.conductance[: head.shape[1]]
        forced = (pull / root) @ modes
        found = self._respond(rate, forced, modes / root[:, None])
        return np.asarray(self.baseline + (found @ modes.T) / root + jump)

    @cached_property
    def _modes(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Root of the capacities (N,), rates (N,) and modes (N, N) of the network at rest."""
        root = np.sqrt(self.capacity)
        matrix = self.conductance / np.outer(root, root)
        rate, modes = np.linalg.eigh((matrix + matrix.T) / 2)
        return root, np.where(rate < 1e-12 * max(float(rate[-1]), 1e-300), 0.0, rate), modes

    def _respond(self, rate: np.ndarray, forced: np.ndarray, modes: np.ndarray) -> np.ndarray:
        if self.inertance.size:
            # A mode with the flows f a: (sum I f^2) a' + (sum R f^2) a = rate y, y' = -rate a.
            # Exact where all tubes have one ratio of inertance to resistance.
            flows = self.tubes[:, : len(modes)] @ modes
            lost = self.resistance @ flows**2 + 1e-300
            delay = self.inertance @ flows**2 / lost + 1e-30
            return second_order(
                delay, rate**2 / lost, self.time, forced * (rate / lost), self.start
            )
        settled = np.where(rate > 0, forced[0] / np.where(rate > 0, rate, 1.0), 0.0)
        # What settles far within every step follows at once.
        found = forced / np.where(rate > 0, rate, 1.0)
        slow = rate * self.time[-1] < FAST
        filters = -rate[slow], self.time, forced[:, slow]
        found[:, slow] = first_order(*filters, start_of(self.start, settled[slow], *filters))
        return np.asarray(found)

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """Flow of every tube (T, Q) [m3/s]."""
        driven = np.asarray(self._above(pressure) @ self.tubes.T)
        if not self.inertance.size:
            return driven
        # Inertance: a flow comes up to what drives it after a while.
        driven = driven * (self.impedance / self.resistance)
        delay = self.inertance / self.resistance
        filters = -1 / delay, self.time, driven / delay
        return first_order(*filters, start_of(self.start, driven[0], *filters))

    def tube_pressures(self, pressure: np.ndarray) -> np.ndarray:
        """Mean gauge pressure of every tube (T, Q), from those of the nodes (T, N) [Pa]."""
        return np.asarray(self.baseline + self._above(pressure) @ self.ends.T)

    def _above(self, pressure: np.ndarray) -> np.ndarray:
        """Pressures of nodes and inlets above the baseline (T, N + U) [Pa]."""
        return np.concatenate([pressure - self.baseline, self.drive], axis=1)


@dataclass(frozen=True)
class UniformNetwork:
    """One pressure per connected network; the same questions."""

    held: np.ndarray
    """(T, N) gauge pressures of nodes that an inlet feeds [Pa]."""
    sealed: tuple[np.ndarray, ...]
    """Indices of the nodes of every sealed part."""
    capacity: np.ndarray
    pushed: np.ndarray
    baseline: float

    def pressures(
        self, taken: np.ndarray | None = None, head: np.ndarray | None = None
    ) -> np.ndarray:
        """Gauge pressures (T, N), as for a linear network; a sealed part shares what it holds."""
        given = self.pushed.copy()
        if taken is not None:
            given[:, : taken.shape[1]] -= taken
        found = self.held.copy()
        for part in self.sealed:
            shared = given[:, part].sum(axis=1) / self.capacity[part].sum()
            found[:, part] = self.baseline + shared[:, None]
        if head is not None:
            found[:, : head.shape[1]] += head
        return found

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """None: where the pressure is uniform nothing depends on them (T, 0)."""
        return np.zeros((len(pressure), 0))
