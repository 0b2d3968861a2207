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
    [m3/(Pa s)], ``capacity`` (S, N) [m3/Pa], ``drive`` (U, T) pressures above the baseline,
    ``pushed`` (N, T) volume that plungers push into a node [m3].
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
        """Gauge pressures (S, N, T).

        ``taken`` (S, B, T) volumes that the bellows take up besides; ``head`` (S, B, T) pressure
        that the fluid's weight gives them against the inlet. Bellows are the first nodes.
        """
        # y = p - given / capacity has no derivative of what is given: C y' = -G p + feed u.
        # The mean mode of a sealed part has the rate zero and stays: its amount is kept.
        rate, shapes = self._modes
        forcing = shapes.swapaxes(1, 2)
        forced = (forcing @ self.feed) @ self.drive
        given = given_volumes(self.pushed, taken)
        jump = None if given is None else given / self.capacity[..., None]
        if jump is not None:
            forced -= (forcing @ self.conductance.swapaxes(1, 2)) @ jump
        if head is not None:
            lifted = self.conductance[:, : head.shape[1]].swapaxes(1, 2)
            forced += (forcing @ lifted) @ head
        found = shapes @ self._respond(rate, forced, shapes)
        found += self.baseline
        return np.asarray(found if jump is None else found + jump)

    @cached_property
    def _modes(self) -> tuple[np.ndarray, np.ndarray]:
        """Rates (S, N) and shapes (S, N, N) of the modes at rest, whose capacities are one."""
        root = np.sqrt(self.capacity)
        matrix = self.conductance / (root[:, :, None] * root[:, None])
        rate, modes = np.linalg.eigh((matrix + matrix.swapaxes(1, 2)) / 2)
        rate = np.where(rate < 1e-12 * np.maximum(rate[:, -1:], 1e-300), 0.0, rate)
        return rate, modes / root[..., None]

    @cached_property
    def _has_inertance(self) -> np.ndarray:
        """(S,)"""
        return np.asarray(np.any(self.inertance > 0.0, axis=1))

    def _respond(self, rate: np.ndarray, forced: np.ndarray, shapes: np.ndarray) -> np.ndarray:
        """Modes (S, N, T) of all networks, as many filters."""
        late = self._has_inertance
        if late.all():
            return self._swing(rate, forced, shapes, late)
        if not late.any():
            return self._settle(rate, forced)
        found = np.empty_like(forced)
        found[late] = self._swing(rate[late], forced[late], shapes[late], late)
        found[~late] = self._settle(rate[~late], forced[~late])
        return found

    def _swing(
        self, rate: np.ndarray, drive: np.ndarray, shapes: np.ndarray, own: np.ndarray
    ) -> np.ndarray:
        """Modes (n, N, T) of networks with inertance, for ``drive`` (n, N, T); ``own`` (S,)."""
        # A mode with the flows f a: (sum I f^2) a' + (sum R f^2) a = rate y, y' = -rate a.
        # Exact where all tubes have one ratio of inertance to resistance.
        flows = (self.tubes[own, :, : shapes.shape[1]] @ shapes) ** 2
        lost = (self.resistance[own, None] @ flows + 1e-300)[:, 0]
        delay = (self.inertance[own, None] @ flows)[:, 0] / lost + 1e-30
        numbers = delay.ravel(), (rate**2 / lost).ravel()
        filtered = (drive * (rate / lost)[..., None]).reshape(-1, drive.shape[-1])
        return second_order(*numbers, self.time, filtered, self.start).reshape(drive.shape)

    def _settle(self, rate: np.ndarray, drive: np.ndarray) -> np.ndarray:
        """y' = drive - rate y (n, N, T)."""
        rates, forced = rate.ravel(), drive.reshape(-1, drive.shape[-1])
        # What settles far within every step follows at once.
        found = forced / np.where(rates > 0, rates, 1.0)[:, None]
        settled = np.where(rates > 0, found[:, 0], 0.0)
        slow = rates * self.time[-1] < FAST
        filters = -rates[slow], self.time, forced[slow]
        found[slow] = first_order(*filters, start_of(self.start, settled[slow], *filters))
        return found.reshape(drive.shape)

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """Flow of every tube (S, Q, T) [m3/s]."""
        driven = self._of_ends(self.tubes, pressure)
        late = self._has_inertance
        if late.any():
            # Inertance: a flow comes up to what drives it after a while.
            driven[late] = self._delayed(driven[late], late)
        return driven

    def _delayed(self, driven: np.ndarray, own: np.ndarray) -> np.ndarray:
        """Flows (n, Q, T) of networks with inertance; ``own`` (S,)."""
        resistance = self.resistance[own]
        driven = driven * (self.impedance[own] / resistance)[..., None]
        rate = (resistance / self.inertance[own]).ravel()
        drive = driven.reshape(len(rate), -1)
        filters = -rate, self.time, drive * rate[:, None]
        found = first_order(*filters, start_of(self.start, drive[:, 0], *filters))
        return found.reshape(driven.shape)

    def tube_pressures(self, pressure: np.ndarray) -> np.ndarray:
        """Mean gauge pressure of every tube (S, Q, T), from those of the nodes (S, N, T) [Pa]."""
        return self.baseline + self._of_ends(self.ends, pressure)

    def _of_ends(self, parts: np.ndarray, pressure: np.ndarray) -> np.ndarray:
        """Sums over the nodes (S, N, T) and inlets of parts (..., Q, N + U) of what they have
        above the baseline [Pa].
        """
        nodes = pressure.shape[1]
        above = parts[..., :nodes] @ (pressure - self.baseline)
        return np.asarray(above + parts[..., nodes:] @ self.drive)


@dataclass(frozen=True)
class UniformNetworks:
    """S networks with one pressure per connected part; the same questions."""

    held: np.ndarray
    """(N, T) gauge pressures of nodes that an inlet feeds [Pa]."""
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
        """Gauge pressures (S, N, T), as for linear networks; a sealed part shares what it holds."""
        found = np.repeat(self.held[None], len(self.capacity), axis=0)
        given = given_volumes(self.pushed, taken)
        for part in self.sealed:
            if given is not None:
                shared = given[:, part].sum(axis=1) / self.capacity[:, part].sum(axis=1)[:, None]
                found[:, part] = self.baseline + shared[:, None]
        if head is not None:
            found[:, : head.shape[1]] += head
        return found

    def flows(self, pressure: np.ndarray) -> np.ndarray:
        """None: where the pressure is uniform nothing depends on them (S, 0, T)."""
        return np.zeros((len(pressure), 0, pressure.shape[-1]))


def given_volumes(pushed: np.ndarray, taken: np.ndarray | None) -> np.ndarray | None:
    """Volumes that plungers push into the nodes (N, T), less what bellows take up (S, B, T).

    (S or 1, N, T); None where nothing is given.
    """
    if taken is None:
        return pushed[None] if pushed.any() else None
    given = np.repeat(pushed[None], len(taken), axis=0)
    given[:, : taken.shape[1]] -= taken
    return given
