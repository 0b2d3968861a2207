"""The edge of the set of points that a tip can visit with inputs within limits.

In a linear network the bellows' pressures at a time are a weighted mean of the inlet's past. So
those that are largest in a direction of pressures come from an input that is at one of its limits
at every time, by the sign of the weight. The tip of a row of arcs follows from these pressures
exactly; in which direction they are to be large, the edge itself tells by its normals.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.lazy_dataclass import dataclass

DIRECTIONS, FEW_DIRECTIONS = 192, 36
"""Points of an edge; where each needs linear programs."""


@dataclass(frozen=True)
class EdgeRules:
    """How finely an edge is sought."""

    edge_rounds: int = 3
    """Times that the edge is moved outwards along its normals, and its points spread again."""
    edge_subdivision: int = 12
    near: float = 0.1
    """Points between two of an edge, and the longest move of one, relative to the edge's size."""
    past_steps: int = 600
    past_times: float = 14.0
    first_time: float = 1e-3
    """Steps of the past, its length in slowest time constants, and its first step in fastest
    ones."""
    coarse_samples: int = 16
    fine_samples: int = 128
    """Points of the shortest period at which a linear program keeps the limits, and its answer is
    looked at."""
    periods: int = 6
    """Periods of harmonics that are tried, from the fastest time constant to beyond the slowest."""


RULES = EdgeRules()


@dataclass(frozen=True, eq=False)
class LinearBellows:
    """Pressures of bellows that one inlet feeds: C p' = -G p + g u."""

    matrix: np.ndarray
    """(B, B) G [m3/(Pa s)]"""
    feed: np.ndarray
    """(B,) g"""
    stored: float
    """Compliance of a bellow [m3/Pa]."""

    def modes(self) -> tuple[np.ndarray, np.ndarray]:
        """Rates (B,) [1/s] and modes (B, B)."""
        rate, modes = np.linalg.eigh(self.matrix)
        return rate / self.stored, modes


Extreme = Callable[[np.ndarray], np.ndarray]
"""Pressures (B,) that are largest in a direction (B,)."""


@dataclass(frozen=True, eq=False)
class PastInput:
    """Extremes by any input within limits."""

    ages: np.ndarray
    """(S + 1,) edges of steps of the past, 0 is now [s]."""
    weights: np.ndarray
    """(S, B) of the inlet's pressure in each step."""
    limits: tuple[float, float]

    @classmethod
    def of(cls, bellows: LinearBellows, limits: tuple[float, float]) -> PastInput:
        """Step responses of a network to the past of its input."""
        rate, modes = bellows.modes()
        first, last = RULES.first_time / rate[-1], RULES.past_times / rate[0]
        ages = np.concatenate([[0.0], np.geomspace(first, last, RULES.past_steps)])
        left = np.exp(-np.outer(ages, rate))
        left[-1] = 0.0  # what was before counts as the last step
        parts = -np.diff(left, axis=0) / rate * (modes.T @ bellows.feed) / bellows.stored
        return cls(ages, parts @ modes.T, limits)

    def drive(self, direction: np.ndarray) -> np.ndarray:
        """(S,) The inlet's pressure in each step of the past."""
        low, high = self.limits
        return np.where(self.weights @ direction > 0.0, high, low)

    def __call__(self, direction: np.ndarray) -> np.ndarray:
        """(B,) The largest pressures in a direction."""
        found: np.ndarray = self.drive(direction) @ self.weights
        return found


class HarmonicExtremes:
    """Extremes by so many harmonics within limits, of the best of some periods."""

    def __init__(self, bellows: LinearBellows, limits: tuple[float, float], count: int) -> None:
        self._limits, self._count = limits, count
        rate, _ = bellows.modes()
        periods = 2 * math.pi * np.geomspace(0.5 / rate[-1], 4.0 / rate[0], RULES.periods)
        self._gains = [self._gain(bellows, period) for period in periods]
        self._levels = self._levels_at(RULES.coarse_samples * count)
        self._fine = self._levels_at(RULES.fine_samples * count)

    def _levels_at(self, samples: int) -> np.ndarray:
        """(samples, 1 + 2 N): the input in a period by mean, cosines and sines."""
        phases = 2 * math.pi * np.arange(samples) / samples
        turns = np.outer(phases, np.arange(1, self._count + 1))
        return np.concatenate([np.ones((samples, 1)), np.cos(turns), np.sin(turns)], axis=1)

    def within(self, amplitudes: np.ndarray) -> np.ndarray:
        """(1 + 2 N,) An input that keeps its limits between samples, too, by less amplitude."""
        low, high = self._limits
        mean = min(max(float(amplitudes[0]), low), high)
        swing = self._fine[:, 1:] @ amplitudes[1:]
        above, below = float(swing.max()), float(-swing.min())
        share = min(
            1.0,
            (high - mean) / above if above > high - mean else 1.0,
            (mean - low) / below if below > mean - low else 1.0,
        )
        return np.append(mean, share * amplitudes[1:])

    def _gain(self, bellows: LinearBellows, period: float) -> np.ndarray:
        """(B, 1 + 2 N): pressures at the beginning of a period by mean, cosines and sines."""
        orders = np.arange(1, self._count + 1)
        unit = np.eye(len(bellows.matrix))
        found = [
            np.linalg.solve(
                bellows.matrix + 2j * math.pi * k / period * bellows.stored * unit, bellows.feed
            )
            for k in orders
        ]
        transfer = np.array(found).T
        level = np.linalg.solve(bellows.matrix, bellows.feed)[:, None]
        return np.concatenate([level, transfer.real, transfer.imag], axis=1)

    def __call__(self, direction: np.ndarray) -> np.ndarray:
        """(B,) The largest pressures in a direction, by linear programs."""
        from scipy.optimize import linprog

        low, high = self._limits
        rows = np.concatenate([self._levels, -self._levels])
        ends = np.concatenate([np.full(len(self._levels), high), np.full(len(self._levels), -low)])
        high_size = max(abs(low), abs(high))
        best: np.ndarray | None = None
        for gain in self._gains:
            aim = direction @ gain
            aim = aim / max(float(np.abs(aim).max()), 1e-300)
            solved = linprog(-aim, rows, ends / high_size, bounds=(None, None))
            if solved.x is None:
                continue
            pressure = gain @ self.within(solved.x * high_size)
            if best is None or direction @ pressure > direction @ best:
                best = pressure
        assert best is not None, "constant inputs are within the limits"
        return best


def edge_pressures(
    extreme: Extreme, rod: ArcRod, middle: np.ndarray, directions: int = DIRECTIONS
) -> np.ndarray:
    """(N, B) Pressures of the points of the edge, in order around it, equally far apart.

    Pressures that can be had are a convex set: what lies between two of its points can be had.
    """
    slopes = rod.slopes(middle[None])[0]
    # Of a straight rod: x and z in their own sizes, so that directions are spread evenly.
    sizes = [max(float(row @ (extreme(row) - extreme(-row))), 1e-300) for row in slopes]
    angle = 2 * math.pi * np.arange(directions) / directions
    across = np.column_stack([np.cos(angle) / sizes[0], np.sin(angle) / sizes[1]])
    found = _spread(rod, np.array([extreme(own @ slopes) for own in across]), directions)
    for _ in range(RULES.edge_rounds):
        found = _spread(rod, _moved_out(extreme, rod, found), directions)
    # Points that were spread lie between extremes, and so within the edge.
    return _moved_out(extreme, rod, found)


def _spread(rod: ArcRod, pressures: np.ndarray, directions: int) -> np.ndarray:
    """The same edge by points that are equally far apart along it."""
    share = np.arange(RULES.edge_subdivision)[:, None, None] / RULES.edge_subdivision
    dense = (1 - share) * pressures + share * np.roll(pressures, -1, axis=0)
    dense = dense.transpose(1, 0, 2).reshape(-1, pressures.shape[1])
    dense = np.concatenate([dense, dense[:1]])
    steps = np.linalg.norm(np.diff(rod.tip(dense), axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0.0, along[-1], directions, endpoint=False)
    return np.column_stack([np.interp(wanted, along, column) for column in dense.T])


def _moved_out(extreme: Extreme, rod: ArcRod, pressures: np.ndarray) -> np.ndarray:
    """Points of the edge moved a little outwards along its normals, where that can be had."""
    tip, slopes = rod.tip(pressures), rod.slopes(pressures)
    most = RULES.near * float(np.ptp(tip, axis=0).max())
    way = np.roll(tip, -1, axis=0) - np.roll(tip, 1, axis=0)
    normal = np.column_stack([way[:, 1], -way[:, 0]])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    found = pressures.copy()
    for k in range(len(tip)):
        own = extreme(normal[k] @ slopes[k])
        step = rod.tip(own[None])[0] - tip[k]
        outwards = float(normal[k] @ step)
        if outwards > 0.0 and np.linalg.norm(step) < most:
            found[k] = own
    return found


class TwoInlets:
    """Extremes where each column has an inlet of its own at its first bellow."""

    def __init__(self, column: LinearBellows, limits: tuple[float, float]) -> None:
        self._past = PastInput.of(column, limits)

    def __call__(self, direction: np.ndarray) -> np.ndarray:
        """(B,) The largest pressures in a direction."""
        return np.concatenate([self._past(own) for own in np.split(direction, 2)])


def column_of(sections: int, resistance: float, stored: float) -> LinearBellows:
    """A column of bellows on a chain of equal tubes, fed at the clamp."""
    matrix = (2 * np.eye(sections) - np.eye(sections, k=1) - np.eye(sections, k=-1)) / resistance
    matrix[-1, -1] = 1 / resistance
    feed = np.zeros(sections)
    feed[0] = 1 / resistance
    return LinearBellows(matrix, feed, stored)
