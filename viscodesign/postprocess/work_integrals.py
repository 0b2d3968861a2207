"""Work integrals evaluated after the solution, and the energies they are balanced against.

A work is the integral of a force along a path, both known at the solved times only. Groups of
intervals share one polynomial; comparing it with two of half the degree gives the uncertainty.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.boundary_work import FORCE_AND_PATH
from viscodesign.solve.problem import Problem
from viscodesign.storage.distinct import distinct
from viscodesign.storage.lru_cache import LruCache

ENERGIES = ("fluid_energy", "kinetic_energy", "load_energy", "elastic_energy")

Rows = Mapping[str, np.ndarray]


@dataclass(frozen=True)
class PathIntegralRule:
    """How works are summed over samples."""

    group: int = 4
    """Intervals that share one polynomial; the last group of a stretch may have up to three
    more."""
    error_share: float = 1.0
    """Error of a polynomial's integral over its distance from that of two of half the degree: a
    fifteenth where these are quadratic and all is smooth, but up to all of it where samples barely
    resolve an oscillation."""
    linear_error_share: float = 1 / 6
    """The same of a single straight line, over the change of the force times that of the path."""


RULE = PathIntegralRule()


class EnergyTable:
    """Energies and works of every edge, as one row of numbers."""

    def __init__(self, problem: Problem) -> None:
        equations = problem.equations
        self._size = equations.energy_size
        self._rates = list(equations.rates)
        self._by_parts: dict[str, np.ndarray] = {}
        self._sampled: dict[str, np.ndarray] = {}
        for name, split in equations.work_splits.items():
            order = problem.places if name == "coupling" else slice(None)
            self._by_parts[name] = np.flatnonzero(split.by_parts[order])
            self._sampled[name] = np.flatnonzero(split.sampled[order])
        self.sums = any(map(len, self._sampled.values()))
        """Whether any work is summed over rows, rather than integrated."""
        self._spans: dict[str, slice] = {}
        self.width = 0
        for part, count in self._parts():
            self._spans[part] = slice(self.width, self.width + count)
            self.width += count

    def _parts(self) -> Iterator[tuple[str, int]]:
        yield from (("time", 1), ("energies", len(ENERGIES)), ("integrals", len(self._rates)))
        for name, which in self._by_parts.items():
            yield from (("ends of " + name, int(len(which) > 0)),)
        for name, which in self._sampled.items():
            yield from (("force of " + name, len(which)), ("path of " + name, len(which)))

    def of(self, time: np.ndarray, values: Rows, integrals: np.ndarray) -> np.ndarray:
        """Rows (m, width) of edges with outputs (m, n) and integrals (nq, m)."""
        rows = np.zeros((len(time), self.width))
        rows[:, self._spans["time"]] = time[:, None]
        rows[:, self._spans["integrals"]] = self._size * integrals.T
        first = self._spans["energies"].start
        for k, name in enumerate(ENERGIES, start=first):
            if name in values:
                rows[:, k] = values[name][:, 0]
        for name, (force, path) in FORCE_AND_PATH.items():
            if name not in self._sampled:
                continue
            parts, sampled = self._by_parts[name], self._sampled[name]
            if len(parts):
                product = values[force][:, parts] * values[path][:, parts]
                rows[:, self._spans["ends of " + name]] = product.sum(axis=1, keepdims=True)
            rows[:, self._spans["force of " + name]] = values[force][:, sampled]
            rows[:, self._spans["path of " + name]] = values[path][:, sampled]
        return rows

    def energies(self, rows: np.ndarray) -> np.ndarray:
        """Stored energies (m, kinds) [J]."""
        return np.asarray(rows[:, self._spans["energies"]])

    def lost(self, rows: np.ndarray) -> np.ndarray:
        """Energy dissipated since the start (m,) [J]."""
        lost = self._integral("tube_loss", rows) + self._integral("material_loss", rows)
        return np.asarray(lost)

    def integrated(self, work: str, rows: np.ndarray) -> np.ndarray:
        """The part of a work that needs no sum over rows (m,) [J], up to a constant."""
        ends = self._spans.get("ends of " + work, slice(0, 0))
        return np.asarray(self._integral(work, rows) + rows[:, ends].sum(axis=1))

    def summed(
        self, work: str, rows: np.ndarray, cuts: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Its other part between rows ``cuts`` (g + 1,), and the uncertainty of that (g,) [J]."""
        span = self._spans.get("force of " + work, slice(0, 0))
        if span.start == span.stop:
            return np.zeros(len(cuts) - 1), np.zeros(len(cuts) - 1)
        force, path = rows[:, span], rows[:, self._spans["path of " + work]]
        return path_integrals(rows[:, 0], force, path, cuts)

    def _integral(self, rate: str, rows: np.ndarray) -> np.ndarray:
        if rate not in self._rates:
            return np.zeros(len(rows))
        return np.asarray(rows[:, self._spans["integrals"].start + self._rates.index(rate)])


def group_ends(first: int, last: int, stop: int) -> np.ndarray:
    """Ends, up to edge ``stop``, of the groups of intervals from edge ``first`` to ``last``.

    ``first`` may be the end of any group but the last.
    """
    ends = np.arange(first + RULE.group, min(last, stop) + 1, RULE.group)
    ends = ends[ends + RULE.group <= last]
    return np.append(ends, last) if stop >= last > first else ends


def path_integrals(
    time: np.ndarray, force: np.ndarray, path: np.ndarray, cuts: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Integrals (g,) of force d(path) over groups of intervals, and their uncertainties (g,).

    ``time`` (m,); ``force``, ``path`` (m, n), summed over columns; the groups extend from one of
    the rows ``cuts`` (g + 1,) to the next. Inside a group both are polynomials through their
    values.
    """
    found, unsure = np.zeros((2, len(cuts) - 1))
    for which, rows, weights in _group_weights(time, cuts):
        found[which], unsure[which] = weights.integrals(force[rows], path[rows])
    return found, unsure


class _Weights:
    """Weights of forces and paths in integrals over groups of equal size, at times (g, k + 1)."""

    def __init__(self, time: np.ndarray) -> None:
        middle = time.shape[1] // 2
        self._whole = _polynomial(time)
        self._halves = [
            (part, _polynomial(time[:, part]))
            for part in (slice(0, middle + 1), slice(middle, None))
            if time.shape[1] > 2
        ]

    def integrals(self, force: np.ndarray, path: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Integrate forces over paths (g, k + 1, n)."""
        whole = _weighted(force, self._whole, path)
        if not self._halves:  # a single interval
            change = np.sum((force[:, 1] - force[:, 0]) * (path[:, 1] - path[:, 0]), axis=1)
            return whole, RULE.linear_error_share * np.abs(change)
        parts = sum(_weighted(force[:, h], own, path[:, h]) for h, own in self._halves)
        return whole, RULE.error_share * np.abs(whole - parts)


Groups = list[tuple[np.ndarray, np.ndarray, _Weights]]
"""Which groups have one size, their rows, and their weights."""
_LATEST: LruCache[Groups] = LruCache(16)
"""Those of the latest runs: other solutions have the same times."""
MAX_KEPT_ROWS = 5_000


def _group_weights(time: np.ndarray, cuts: np.ndarray) -> Groups:
    def made() -> Groups:
        sizes, groups = np.diff(cuts), []
        for size in distinct(sizes):
            which = np.flatnonzero(sizes == size)
            rows = cuts[which, None] + np.arange(size + 1)
            groups.append((which, rows, _Weights(time[rows])))
        return groups

    if len(time) > MAX_KEPT_ROWS:
        return made()
    return _LATEST.get((time.tobytes(), cuts.tobytes()), made)


def _polynomial(time: np.ndarray) -> np.ndarray:
    degree = np.arange(time.shape[1])
    share = (time - time[:, :1]) / (time[:, -1:] - time[:, :1])
    inverse = np.linalg.inv(share[:, :, None] ** degree)
    # Of monomials: the integral of s^i d(s^j) from 0 to 1 is j/(i + j).
    monomials = degree[None, :] / np.maximum(degree[:, None] + degree[None, :], 1)
    return np.asarray(np.swapaxes(inverse, 1, 2) @ monomials @ inverse)


def _weighted(force: np.ndarray, weights: np.ndarray, path: np.ndarray) -> np.ndarray:
    return np.asarray(np.sum(force * (weights @ path), axis=(1, 2)))
