"""Derivatives of a march: back from its outputs, or forward along directions."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.algebraic_part import AlgebraicPart
from viscodesign.native.loops import DTYPES
from viscodesign.native.march import METHOD
from viscodesign.native.source.factors import SIDE
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly

PLACES = DTYPES["places"]


@dataclass(frozen=True)
class Differentiable:
    """A structure whose marches can be differentiated: n unknowns, nnz entries of the Jacobian."""

    lu: SparseLU
    mass: np.ndarray
    """(n,): 0 for algebraic rows."""
    rows: np.ndarray
    """(nnz,) row of every entry."""
    columns: np.ndarray
    """(nnz,)"""
    algebraic: AlgebraicPart
    kernels: np.ndarray
    """Four kernels for every pair of the assembly: slopes of the weighted results of the first and
    of the second, rates of both along a direction (4 pairs,)."""


@dataclass(frozen=True)
class Stretch:
    """What a march did over one smooth stretch of the inputs."""

    rest: np.ndarray
    """Coefficients of the inputs and constants: the end of Y."""
    edges: np.ndarray
    """(ne,) times of the outputs after the beginning [s]; the last one is the end."""
    steps: np.ndarray
    """Record of the steps taken, in their order, with or without their stages."""


@dataclass
class Bars:
    """Slopes of a number by all that a stretch depends on."""

    begin: np.ndarray
    """(n,) by the unknowns at its beginning."""
    rest: np.ndarray
    """By the coefficients of the inputs and constants."""
    ends: np.ndarray
    """(2,) by the times at which it begins and ends [1/s]."""
    numbers: np.ndarray
    """By the numbers of the assembly."""


@dataclass
class Dots:
    """Rates of all that a stretch depends on along d directions."""

    begin: np.ndarray
    """(d, n) of the unknowns at its beginning."""
    rest: np.ndarray
    """(d, nr) of the coefficients of the inputs and constants."""
    ends: np.ndarray
    """(d, 2) of the times at which it begins and ends [s]."""
    numbers: np.ndarray
    """(d, nn) of the numbers of the assembly."""

    def some(self, rows: slice) -> Dots:
        """Some of the directions."""
        return Dots(self.begin[rows], self.rest[rows], self.ends[rows], self.numbers[rows])


def pull_back(
    structure: Differentiable,
    assembly: Assembly,
    stretch: Stretch,
    weights: np.ndarray,
    end: np.ndarray,
) -> Bars:
    """Slopes of the sum of ``weights`` (ne, n) times outputs and ``end`` (n,) times the end."""
    n = assembly.unknowns
    if weights.shape != (len(stretch.edges), n) or end.shape != (n,):
        raise ValueError("needs a weight for every unknown at every edge and at the end")
    Y = np.concatenate([np.zeros(n + assembly.drives + 1), stretch.rest])
    Y_bar, y_bar = np.zeros(len(Y)), np.array(end, dtype=float)
    numbers, ends = np.zeros(len(assembly.all_numbers)), np.zeros(2)
    spread = structure.lu.count + 1 + len(assembly.drive_rows)
    size = 38 * n + 1 + _common_work(structure, assembly) + spread + assembly.drives + 1
    assembly.loops(
        "reverse",
        *_recorded(structure, assembly, stretch),
        np.ascontiguousarray(weights).reshape(-1),
        *(Y, y_bar, Y_bar, numbers, ends, np.empty(size)),
    )
    return Bars(y_bar, Y_bar[len(Y) - len(stretch.rest) :], ends, numbers)


def push_forward(
    structure: Differentiable, assembly: Assembly, stretch: Stretch, dots: Dots
) -> tuple[np.ndarray, np.ndarray]:
    """Rates of the outputs (d, ne, n) and of the unknowns at the end (d, n)."""
    count = len(dots.begin)
    found = [
        _push_some(structure, assembly, stretch, dots.some(slice(k, k + SIDE)))
        for k in range(0, count, SIDE)
    ]
    outputs, ends = zip(*found, strict=True)
    return np.concatenate(outputs), np.concatenate(ends)


def _push_some(
    structure: Differentiable, assembly: Assembly, stretch: Stretch, dots: Dots
) -> tuple[np.ndarray, np.ndarray]:
    """The same for up to SIDE directions."""
    n, (count, _) = assembly.unknowns, dots.begin.shape
    rest, own = len(stretch.rest), len(structure.rows)
    Y = np.concatenate([np.zeros(n + assembly.drives + 1), stretch.rest])
    Y_dot = np.zeros((count, len(Y)))
    Y_dot[:, len(Y) - rest :] = dots.rest
    y_dot = np.zeros((n, SIDE))
    y_dot[:, :count] = dots.begin.T
    outputs = np.empty((count, len(stretch.edges), n))
    spread, drives = structure.lu.count + 1 + len(assembly.drive_rows), assembly.drives + 1
    wide = 11 * n + drives + own + 2 * structure.lu.blocks
    groups = assembly.groups_with_kernels
    size = 20 * n + 1 + _common_work(structure, assembly) + spread + count * groups + SIDE * wide
    assembly.loops(
        "forward",
        *_recorded(structure, assembly, stretch),
        *(count, Y, y_dot.reshape(-1), Y_dot.reshape(-1), len(Y)),
        *(np.ascontiguousarray(dots.numbers).reshape(-1), dots.numbers.shape[1]),
        *(np.ascontiguousarray(dots.ends).reshape(-1), outputs.reshape(-1), np.empty(size)),
    )
    return outputs, y_dot.T[:count]


class Consistency:
    """Algebraic unknowns solved for with the states held, at the beginning of a stretch.

    Seldom done, and with pivots: these equations alone may have none in the order that suits a
    step. Raises `ZeroDivisionError` where they are singular.
    """

    def __init__(
        self,
        structure: Differentiable,
        assembly: Assembly,
        y: np.ndarray,
        time: float,
        rest: np.ndarray,
    ) -> None:
        self._structure, self._assembly = structure, assembly
        self._clock = assembly.unknowns + assembly.drives
        self._algebraic = structure.algebraic.is_algebraic
        self.Y = np.concatenate([y, np.zeros(assembly.drives), [time], rest])
        assembly.drive(self.Y)
        self._solve = structure.algebraic.solver(assembly.jacobian(self.Y))

    def correction(self) -> np.ndarray:
        """(n,) Newton's step towards consistent unknowns."""
        found = np.zeros(self._assembly.unknowns)
        residual = self._assembly.residual(self.Y)[self._algebraic]
        found[self._algebraic] = -self._solve(residual, transposed=False)
        return found

    def pull_back(self, weights: np.ndarray) -> Bars:
        """Slopes of weights (n,) times the consistent unknowns.

        ``begin``: by the states before, zero for algebraic unknowns; of ``ends`` the first.
        """
        own, assembly, n = self._structure, self._assembly, self._assembly.unknowns
        passed = np.zeros(n + 1)
        wanted = weights[self._algebraic]
        passed[:n][self._algebraic] = -self._solve(wanted, transposed=True)
        Y_bar, numbers = np.zeros(len(self.Y)), np.zeros(len(assembly.all_numbers))
        work = np.empty(assembly.width_of_slopes), np.empty(assembly.width_of_slopes)
        tables = (assembly.layout, assembly.kernels, own.kernels, assembly.idx, assembly.rows)
        assembly.loops(
            "slopes_at",
            *(*tables, assembly.all_numbers, self.Y, passed, Y_bar, numbers),
            *(np.empty(assembly.drives + 1), *work),
        )
        begin = np.where(self._algebraic, 0.0, weights + Y_bar[:n])
        return Bars(begin, Y_bar[self._clock + 1 :], np.array([Y_bar[self._clock], 0.0]), numbers)

    def push_forward(self, dots: Dots) -> np.ndarray:
        """Rates (d, n) of the consistent unknowns, for rates of the states before."""
        own, assembly, n = self._structure, self._assembly, self._assembly.unknowns
        found = np.where(self._algebraic, 0.0, dots.begin)
        work = np.empty(assembly.width_of_slopes), np.empty(assembly.width_of_slopes)
        tables = (assembly.layout, assembly.kernels, own.kernels, assembly.idx, assembly.rows)
        defects = np.empty((len(found), n + 1))
        for k, defect in enumerate(defects):
            Y_dot = np.zeros(len(self.Y))
            Y_dot[:n] = found[k]
            Y_dot[self._clock], Y_dot[self._clock + 1 :] = dots.ends[k, 0], dots.rest[k]
            numbers = np.ascontiguousarray(dots.numbers[k])
            assembly.loops(
                "rates_at",
                *(*tables, assembly.all_numbers, self.Y, Y_dot, numbers, defect, *work),
            )
        wanted = defects[:, :n][:, self._algebraic].T
        found[:, self._algebraic] = -self._solve(wanted, transposed=False).T
        return found


def _recorded(
    structure: Differentiable, assembly: Assembly, stretch: Stretch
) -> tuple[object, ...]:
    """Arguments that both directions have in common."""
    lu, steps = structure.lu, np.ascontiguousarray(stretch.steps)
    return (
        *(lu.layout_of(assembly.layout), assembly.kernels, structure.kernels, assembly.idx),
        *(assembly.rows, lu.entries_of(assembly.pos), assembly.all_numbers),
        *(assembly.drive_rows, assembly.drive_columns),
        *(lu.blocks, lu.own, lu.slots, lu.lu_start, lu.lu_columns, lu.diagonal),
        *(len(structure.rows), structure.rows, structure.columns, lu.place),
        *(structure.mass, METHOD, steps.reshape(-1), *steps.shape),
        *(np.ascontiguousarray(stretch.edges), len(stretch.edges)),
    )


def _common_work(structure: Differentiable, assembly: Assembly) -> int:
    """Numbers that either direction works with behind its own."""
    lu, drives = structure.lu, assembly.drives + 1
    spread = lu.count + 1 + len(assembly.drive_rows)
    return 6 * lu.blocks + lu.count + spread + 2 * drives + 2 * assembly.width_of_slopes
