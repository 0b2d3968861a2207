"""Integrals of what is a formula of the time: no unknown, hence no integrator, has a part in it."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.model.formulation import Formulas
from viscodesign.solve.problem import Problem

PER_SWING = 2
"""Parts of an input's swing that are integrated each by itself at both ends of an interval, at
first: it may swing there, and then no more."""
LONGER = 3.0
"""How many times longer each part is than the one before it, away from those ends."""
POINTS = 4
"""Points of Gauss in each."""
EXACT = 1e-6
"""Change of the integral by a halving of all parts, of the largest, at which it is taken as exact;
each part may have its even share of it. What is left then is some hundred times less."""
ROUND_OFF = 1e-15
"""The same of a single part."""
MOST_HALVINGS = 50
MOST_PARTS = 300_000
"""Parts that are halved at once, at most: a second's work. What more there is stays as it is."""
BLOCK = 1_000
"""Intervals that are looked at together."""


def timed_integrals(problem: Problem, first: int, count: int) -> np.ndarray:
    """Of the timed rates from edge ``first`` to each of the ``count`` edges that follow (n, m).

    Parts are halved, each by itself, until that changes little: an input may do in a
    millionth of an interval all that it does.
    """
    sums = np.zeros((problem.equations.timed_quadrature.numel(), count))
    if not sums.size:
        return sums
    for begin in range(0, count, BLOCK):
        end = min(begin + BLOCK, count)
        sums[:, begin:end] = _Block(problem, first + begin, end - begin).integrals()
    return np.asarray(np.cumsum(sums, axis=1))


class _Block:
    """Some intervals, and the parts into which they are cut."""

    def __init__(self, problem: Problem, first: int, count: int) -> None:
        equations = problem.equations
        self.edges = problem.schedule.edges[first : first + count + 1]
        self._pieces = problem.schedule.pieces[first : first + count].T
        self._numbers = problem.numbers()
        self._rates = equations.compiled(_rates)
        self._spacing = (equations.swing_time or float(self.edges[-1])) / PER_SWING

    def integrals(self) -> np.ndarray:
        """Of each rate over each interval (n, m)."""
        begins, ends, owner = _parts(self.edges, self._spacing)
        found = self._gauss(begins, ends, owner)
        settled = np.zeros((len(found), len(self.edges) - 1))
        for _ in range(MOST_HALVINGS):
            middles = (begins + ends) / 2
            halves = self._gauss(begins, middles, owner), self._gauss(middles, ends, owner)
            finer = halves[0] + halves[1]
            whole = settled + _by_owner(finer, owner, settled.shape[1])
            largest = np.max(np.abs(np.cumsum(whole, axis=1)))
            change = np.max(np.abs(finer - found), axis=0)
            loose = change > largest * max(EXACT / len(begins), ROUND_OFF)
            if not loose.any() or 2 * np.count_nonzero(loose) > MOST_PARTS:
                return np.asarray(whole)
            settled += _by_owner(finer[:, ~loose], owner[~loose], settled.shape[1])
            found = np.concatenate([half[:, loose] for half in halves], axis=1)
            begins, ends = (
                np.concatenate([begins[loose], middles[loose]]),
                np.concatenate([middles[loose], ends[loose]]),
            )
            owner = np.tile(owner[loose], 2)
        return np.asarray(settled + _by_owner(found, owner, settled.shape[1]))

    def _gauss(self, begins: np.ndarray, ends: np.ndarray, owner: np.ndarray) -> np.ndarray:
        """Integrals of the rates over parts (n, parts)."""
        pieces, length = self._pieces[:, owner], ends - begins
        told = np.zeros((self._rates.numel_out(0), len(begins)))
        for place, weight in zip(*np.polynomial.legendre.leggauss(POINTS), strict=True):
            at = begins + (place + 1) / 2 * length
            values = np.array(self._rates(at[None, :], pieces, self._numbers))
            told += weight / 2 * length * values
        return told


def _parts(edges: np.ndarray, spacing: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Begins, ends and intervals of parts: as short as ``spacing`` at both ends of an interval."""
    length = np.diff(edges)
    # Each half of an interval: (LONGER^n - 1)/(LONGER - 1) times its first part.
    reach = 1 + (LONGER - 1) / 2 * length / spacing
    counts = np.where(length <= spacing, 0, np.ceil(np.log(reach) / np.log(LONGER))).astype(int)
    begins, ends, owner = [], [], []
    for count in np.unique(counts):
        own = np.flatnonzero(counts == count)
        grown = np.concatenate([[0.0], np.cumsum(LONGER ** np.arange(count))])
        half = grown / (2 * grown[-1]) if count else grown
        share = np.concatenate([half, 1 - half[-2::-1]]) if count else np.array([0.0, 1.0])
        cuts = edges[own][:, None] + length[own][:, None] * share
        cuts[:, -1] = edges[own + 1]
        begins.append(cuts[:, :-1].ravel())
        ends.append(cuts[:, 1:].ravel())
        owner.append(np.repeat(own, len(share) - 1))
    return np.concatenate(begins), np.concatenate(ends), np.concatenate(owner)


def _by_owner(values: np.ndarray, owner: np.ndarray, count: int) -> np.ndarray:
    """Values (n, parts) added up over each interval (n, count)."""
    return np.array([np.bincount(owner, row, count) for row in values])


def _rates(equations: Formulas) -> ca.Function:
    """(time, pieces, numbers) -> timed rates over the size of an energy (n,)."""
    arguments = [equations.time, equations.pieces, equations.parameters]
    return ca.Function("timed", arguments, [equations.timed_quadrature])
