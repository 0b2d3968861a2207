"""How an iteration goes from one set of unknowns to the next: straight, or along a rod's turns."""

from __future__ import annotations

import numpy as np

from viscodesign.model.unknowns import Unknowns


class Way:
    """Straight steps."""

    def step(self, y: np.ndarray, step: np.ndarray) -> np.ndarray:
        """The unknowns (n,) a step on."""
        return np.asarray(y + step)

    def beyond(self, before: np.ndarray, now: np.ndarray, ratio: float) -> np.ndarray:
        """What comes after two sets of unknowns, ``ratio`` of their distance on."""
        return np.asarray(now + ratio * (now - before))


STRAIGHT = Way()


class Turning(Way):
    """Steps that turn and stretch the chords between a rod's nodes; the rest goes straight.

    A straight step of nodes that turn about each other lengthens the chords in the second
    order, and an axis that hardly stretches lets only the tiniest of such steps pass.
    """

    def __init__(self, positions: slice) -> None:
        self.positions = positions

    def step(self, y: np.ndarray, step: np.ndarray) -> np.ndarray:
        after, chords = np.asarray(y + step), self._chords(y)
        # Equal to the straight step in the first order. One that is beyond numbers is judged by
        # whoever takes it, who then takes less of it.
        with np.errstate(over="ignore", invalid="ignore"):
            after[self.positions] = _nodes(chords * np.exp(self._chords(step) / chords))
        return after

    def beyond(self, before: np.ndarray, now: np.ndarray, ratio: float) -> np.ndarray:
        after, chords = np.asarray(now + ratio * (now - before)), self._chords(now)
        turns = np.log(chords / self._chords(before))
        after[self.positions] = _nodes(chords * np.exp(ratio * turns))
        return after

    def _chords(self, y: np.ndarray) -> np.ndarray:
        """From node to node, z + i x (edges,)."""
        x, z = y[self.positions].reshape(-1, 2).T
        return np.asarray(np.diff(z + 1j * x, prepend=0.0))


def _nodes(chords: np.ndarray) -> np.ndarray:
    """x and z of all nodes in turn (2 edges,)."""
    places = np.cumsum(chords)
    return np.column_stack((places.imag, places.real)).ravel()


def way_of(unknowns: Unknowns) -> Way:
    """The way that suits a vector of unknowns."""
    place = unknowns.blocks.get("position")
    return STRAIGHT if place is None else Turning(place.span)
