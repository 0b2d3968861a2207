"""What the energy balance needs of a motion, edge by edge."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from viscodesign.model.boundary_work import FORCE_AND_PATH
from viscodesign.postprocess.path_integral import path_integrals
from viscodesign.solve.problem import Problem

ENERGIES = ("fluid_energy", "kinetic_energy", "load_energy", "elastic_energy")

Rows = Mapping[str, np.ndarray]


class EnergyTable:
    """What the energy balance needs of every edge, as one row of numbers."""

    def __init__(self, problem: Problem) -> None:
        equations = problem.equations
        self._size = equations.energy_size
        self._rates = list(equations.rates)
        self._by_parts: dict[str, np.ndarray] = {}
        self._sampled: dict[str, np.ndarray] = {}
        for name, way in equations.ways.items():
            order = problem.places if name == "coupling" else slice(None)
            self._by_parts[name] = np.flatnonzero(way.by_parts[order])
            self._sampled[name] = np.flatnonzero(way.sampled[order])
        self.sums = any(map(len, self._sampled.values()))
        """Whether anything is summed over rows, rather than integrated."""
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
        """Rows (m, width) of edges whose outputs are (m, n), whose integrals (nq, m)."""
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
        """Stored (m, kinds) [J]."""
        return np.asarray(rows[:, self._spans["energies"]])

    def lost(self, rows: np.ndarray) -> np.ndarray:
        """Lost since the start (m,) [J]."""
        lost = self._integral("tube_loss", rows) + self._integral("material_loss", rows)
        return np.asarray(lost)

    def told(self, work: str, rows: np.ndarray) -> np.ndarray:
        """A work as far as it needs no sum over rows (m,) [J], up to a constant."""
        ends = self._spans.get("ends of " + work, slice(0, 0))
        return np.asarray(self._integral(work, rows) + rows[:, ends].sum(axis=1))

    def summed(
        self, work: str, rows: np.ndarray, cuts: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """The rest of it between rows ``cuts`` (g + 1,), and its uncertainty (g,) [J]."""
        span = self._spans.get("force of " + work, slice(0, 0))
        if span.start == span.stop:
            return np.zeros(len(cuts) - 1), np.zeros(len(cuts) - 1)
        force, path = rows[:, span], rows[:, self._spans["path of " + work]]
        return path_integrals(rows[:, 0], force, path, cuts)

    def _integral(self, rate: str, rows: np.ndarray) -> np.ndarray:
        if rate not in self._rates:
            return np.zeros(len(rows))
        return np.asarray(rows[:, self._spans["integrals"].start + self._rates.index(rate)])
