"""The numbers of a problem as compiled formulas, and their sparse derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import casadi as ca
import numpy as np

from viscodesign.compiled.problem_trace import ProblemTrace
from viscodesign.compiled.row_functions import RowFunction
from viscodesign.errors import Fault
from viscodesign.lazy_dataclass import dataclass

SX = ca.SX


class ProblemNumbers(NamedTuple):
    """All numbers of a problem that follow from the free ones."""

    parameters: np.ndarray
    """(p,), as `Equations.parameter_values`."""
    pieces: np.ndarray
    """(m, c): coefficients of the inlets in every stretch between two stops."""
    initial_piece: np.ndarray
    """(c,): those just before t = 0."""
    stops: np.ndarray
    """(m + 1,): 0, every corner of an input, and the end of the run [s]."""
    cycle_pieces: np.ndarray = np.zeros((0, 0))
    """Those of one period of the inputs, where a run starts on its limit cycle; else none."""
    cycle_stops: np.ndarray = np.zeros(0)
    """The same of one period [s]."""

    def row(self, k: int | np.ndarray) -> ProblemNumbers:
        """One of several rows of numbers, which are one axis more in front; or some of them."""
        return ProblemNumbers(*(np.ascontiguousarray(part[k]) for part in self))

    def zeros(self) -> ProblemNumbers:
        """As many numbers, all zero."""
        return ProblemNumbers(*(np.zeros_like(part) for part in self))

    def plus(self, other: ProblemNumbers) -> ProblemNumbers:
        """The sum, number by number."""
        return ProblemNumbers(*(one + more for one, more in zip(self, other, strict=True)))

    def flat(self) -> np.ndarray:
        """All of them in a row (n,)."""
        return np.concatenate([part.ravel() for part in self])


Shapes = tuple[tuple[int, ...], ...]


def unflattened(flat: np.ndarray, shapes: Shapes) -> ProblemNumbers:
    """Numbers from a row of them (n, ...), with the axes that follow."""
    ends = np.cumsum([int(np.prod(shape)) for shape in shapes])
    parts = np.split(flat, ends[:-1])
    rest = flat.shape[1:]
    return ProblemNumbers(*(p.reshape(*s, *rest) for p, s in zip(parts, shapes, strict=True)))


@dataclass(frozen=True)
class NumberSlopes:
    """Derivatives of all numbers by the free ones at some values: entries, rows and columns."""

    entries: np.ndarray
    rows: np.ndarray
    columns: np.ndarray
    shapes: Shapes
    count: int
    """Number of free numbers."""

    def push_forward(self, dots: np.ndarray) -> ProblemNumbers:
        """Rates of the numbers where the free ones change at rates (f,)."""
        size = sum(int(np.prod(shape)) for shape in self.shapes)
        rates = np.bincount(self.rows, self.entries * np.asarray(dots)[self.columns], size)
        return unflattened(rates, self.shapes)

    def pull_back(self, bars: ProblemNumbers) -> np.ndarray:
        """Gradient (f,) of the sum of ``bars`` times the numbers."""
        weights = self.entries * bars.flat()[self.rows]
        return np.bincount(self.columns, weights, self.count)

    def dense(self) -> ProblemNumbers:
        """The derivatives of each number, with one more axis of length f."""
        size = sum(int(np.prod(shape)) for shape in self.shapes)
        found = np.zeros((size, self.count))
        found[self.rows, self.columns] = self.entries
        return unflattened(found, self.shapes)


@dataclass(frozen=True)
class Stuck:
    """Free numbers that can move to neither side: beside their value, other formulas hold."""

    places: dict[int, str]
    """By the position of each: where, in words."""

    def faults(self, names: Sequence[str], values: np.ndarray, what: str) -> list[Fault]:
        """``what`` cannot be had of each, and what to do."""
        hint = "has other formulas beside it; give another value"
        return [
            Fault(f"{what} at {values[k]:g}: {place} {hint}", names[k])
            for k, place in self.places.items()
        ]


class Branch:
    """Numbers of a problem as functions of the free ones, valid near some values.

    ``function`` is a CasADi function: values (f,) -> (parameters (p,), pieces (m, c),
    initial_piece (c,), stops (m + 1,), and pieces and stops of a cycle), all dense.
    """

    def __init__(self, trace: ProblemTrace, stuck: Stuck) -> None:
        self.stuck = stuck
        self.parameter_names = trace.parameter_names
        self.structure = trace.structure
        symbols, names = trace.symbols, [*ProblemNumbers._fields]
        results = [
            *(trace.parameters, trace.pieces, trace.initial_piece, trace.stops),
            *(trace.cycle_pieces, trace.cycle_stops),
        ]
        self.function = ca.Function("scene_numbers", [symbols], results, ["values"], names)
        self._shapes = tuple(
            part.shape if name.endswith("pieces") else part.shape[:1]
            for name, part in zip(names, results, strict=True)
        )
        # In rows, as numpy has them.
        flat = ca.densify(ca.vertcat(*(ca.vec(part.T) for part in results)))
        slopes = ca.jacobian(flat, symbols)
        rows, columns = slopes.sparsity().get_triplet()
        self._rows, self._columns = np.array(rows, dtype=int), np.array(columns, dtype=int)
        margins = trace.tape.margins()
        self._conditions = margins.numel()
        self._all = RowFunction([symbols], ca.vertcat(margins, flat), is_merged=False)
        self._slopes = ca.Function("slopes", [symbols], [ca.densify(slopes.nz[:])])
        self.is_used = np.bincount(self._columns, minlength=symbols.numel()) > 0
        """(f,) Whether anything depends on each of the free numbers."""

    def at(self, values: np.ndarray) -> ProblemNumbers | None:
        """The numbers at values (f,); None where other formulas hold."""
        is_valid, numbers = self.rows(values[None])
        return numbers.row(0) if is_valid[0] else None

    def rows(self, values: np.ndarray) -> tuple[np.ndarray, ProblemNumbers]:
        """Whether these formulas hold (m,), and the numbers, for m rows of values (m, f)."""
        found = self._all(values)
        margins, flat = np.split(found, [self._conditions], axis=1)
        rows = ProblemNumbers(*(np.moveaxis(p, -1, 0) for p in unflattened(flat.T, self._shapes)))
        return np.all(margins >= 0.0, axis=1), rows

    def slopes(self, values: np.ndarray) -> NumberSlopes:
        """Their derivatives."""
        entries = self._slopes(values).full().ravel()
        return NumberSlopes(entries, self._rows, self._columns, self._shapes, len(values))
