"""Integrals of rates that depend on time alone: no integrator is needed for them."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulas import Formulas
from viscodesign.solve.problem import Problem
from viscodesign.storage.distinct import distinct


@dataclass(frozen=True)
class PartRule:
    """How intervals are cut into parts for adaptive quadrature."""

    parts_per_swing: int = 2
    """Parts of an input's swing at both ends of an interval, at first: it may swing there, and
    then no more."""
    growth: float = 3.0
    """Ratio of a part's length to the one before it, away from those ends."""
    gauss_points: int = 4
    rel_tol: float = 1e-6
    """Change of the integral by halving all parts, over the largest, at which it has converged;
    each part may have its even share of it. The error left is some hundred times smaller."""
    round_off: float = 1e-15
    """The same of a single part."""
    max_halvings: int = 50
    max_parts: int = 300_000
    """Parts that are halved at once, at most: a second's work. Further ones stay as they are."""
    intervals_at_once: int = 1_000


RULE = PartRule()


def timed_integrals(problem: Problem, first: int, count: int) -> np.ndarray:
    """Integrals (n, m) of the rates from edge ``first`` to each of the m = ``count`` following.

    Each part is halved until its integral hardly changes: an input may do all its work in a
    millionth of an interval.
    """
    sums = np.zeros((problem.equations.time_only_integrals, count))
    if not sums.size:
        return sums
    for begin in range(0, count, RULE.intervals_at_once):
        end = min(begin + RULE.intervals_at_once, count)
        sums[:, begin:end] = _Intervals(problem, first + begin, end - begin).integrals()
    return np.asarray(np.cumsum(sums, axis=1))


class _Intervals:
    """Consecutive intervals, and the parts into which they are cut."""

    def __init__(self, problem: Problem, first: int, count: int) -> None:
        equations = problem.equations
        self.edges = problem.schedule.edges[first : first + count + 1]
        self._pieces = problem.schedule.pieces[first : first + count].T
        self._numbers = problem.numbers()
        self._rates = equations.compiled(_rates)
        self._spacing = (equations.swing_time or float(self.edges[-1])) / RULE.parts_per_swing

    def integrals(self) -> np.ndarray:
        """Integral of each rate over each interval (n, m)."""
        begins, ends, owner = graded_parts(self.edges, self._spacing)
        found = self._gauss(begins, ends, owner)
        settled = np.zeros((len(found), len(self.edges) - 1))
        for _ in range(RULE.max_halvings):
            middles = (begins + ends) / 2
            halves = self._gauss(begins, middles, owner), self._gauss(middles, ends, owner)
            finer = halves[0] + halves[1]
            whole = settled + _by_owner(finer, owner, settled.shape[1])
            largest = np.max(np.abs(np.cumsum(whole, axis=1)))
            change = np.max(np.abs(finer - found), axis=0)
            loose = change > largest * max(RULE.rel_tol / len(begins), RULE.round_off)
            if not loose.any() or 2 * np.count_nonzero(loose) > RULE.max_parts:
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
        total = np.zeros((self._rates.numel_out(0), len(begins)))
        for place, weight in zip(*np.polynomial.legendre.leggauss(RULE.gauss_points), strict=True):
            at = begins + (place + 1) / 2 * length
            values = np.array(self._rates(at[None, :], pieces, self._numbers))
            total += weight / 2 * length * values
        return total


def graded_parts(
    edges: np.ndarray, spacing: float | np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Begin, end and interval of every part, in no order.

    They are as short as ``spacing`` at both ends of each interval; one for all, or one for each.
    """
    length = np.diff(edges)
    # Each half of an interval: (growth^n - 1)/(growth - 1) times its first part.
    reach = 1 + (RULE.growth - 1) / 2 * length / spacing
    growths = np.ceil(np.log(reach) / np.log(RULE.growth))
    counts = np.where(length <= spacing, 0, growths).astype(int)
    begins, ends, owner = [], [], []
    for count in distinct(counts):
        own = np.flatnonzero(counts == count)
        grown = np.concatenate([[0.0], np.cumsum(RULE.growth ** np.arange(count))])
        half = grown / (2 * grown[-1]) if count else grown
        share = np.concatenate([half, 1 - half[-2::-1]]) if count else np.array([0.0, 1.0])
        cuts = edges[own][:, None] + length[own][:, None] * share
        cuts[:, -1] = edges[own + 1]
        begins.append(cuts[:, :-1].ravel())
        ends.append(cuts[:, 1:].ravel())
        owner.append(np.repeat(own, len(share) - 1))
    return np.concatenate(begins), np.concatenate(ends), np.concatenate(owner)


def _by_owner(values: np.ndarray, owner: np.ndarray, count: int) -> np.ndarray:
    """Values (n, parts) summed over each interval (n, count)."""
    return np.array([np.bincount(owner, row, count) for row in values])


def _rates(equations: Formulas) -> ca.Function:
    """(time, pieces, numbers) -> timed rates over the size of an energy (n,)."""
    arguments = [equations.time, equations.pieces, equations.parameters]
    return ca.Function("timed", arguments, [equations.time_only_quadrature])
