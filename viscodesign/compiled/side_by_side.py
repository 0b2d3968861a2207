"""Runs of many rows of numbers side by side, in native code, without what derivatives need."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from viscodesign.compiled.problem_at import problem_at, strictest
from viscodesign.compiled.reading import Reading
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.start import StartFunction
from viscodesign.compiled.stretches import (
    CONSISTENT,
    MAX_STAGE_CORRECTIONS,
    ROUND_OFF_CORRECTION,
    edges_of,
    outputs_between,
)
from viscodesign.model import formulas as of
from viscodesign.model.equations import LEADING_QUANTITIES
from viscodesign.native.row_marches import RowMarches, march_rows, sums_of_rows
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.solvers.rodas_stretch import first_step


class SolvedRows(NamedTuple):
    """Some rows of many."""

    rows: np.ndarray
    """(k,): which they are."""
    columns: np.ndarray
    """(k, T, columns)"""


class _Rows(NamedTuple):
    """What the steps of every row need; the first axis is the rows."""

    numbers: ProblemNumbers
    parameters: np.ndarray
    """As `Problem.numbers`."""
    of_assembly: np.ndarray
    rest_amounts: np.ndarray
    motion_times: np.ndarray
    swing_times: np.ndarray

    def some(self, rows: np.ndarray) -> _Rows:
        """Some of them."""
        numbers, *others = self
        return _Rows(numbers.row(rows), *(part[rows] for part in others))


class SideBySide:
    """Solves rows of numbers of one structure at once: their starts, their steps, their columns.

    A row that is solved has the columns that it has alone. Rows that need more than the straight
    way, or whose run ends with a failure, are left out: whoever asks solves these one by one.
    Stateless.
    """

    def __init__(
        self,
        problem: Problem,
        tolerance: float,
        times: np.ndarray,
        start: StartFunction,
        reading: Reading,
    ) -> None:
        local = problem.equations.local
        assert local is not None, "whoever takes native steps has it"
        self._problem, self._times, self._start, self._reading = problem, times, start, reading
        self._steps = NativeSteps(problem, tolerance)
        self._compiled, self._mass = local.compiled, local.form.balances.mass

    def solve(self, numbers: ProblemNumbers) -> SolvedRows:
        """Rows of m, the first axis of ``numbers``."""
        rows = self._rows(numbers)
        here, is_found = self._start.near(numbers.initial_piece, numbers.parameters)
        left = np.flatnonzero(is_found)
        unknowns, is_found = self._marched(rows.some(left), here[left])
        left, unknowns = left[is_found], unknowns[is_found]
        columns, is_found = self._read(rows.some(left), unknowns)
        return SolvedRows(left[is_found], columns[is_found])

    def _rows(self, numbers: ProblemNumbers) -> _Rows:
        count = len(numbers.parameters)
        quantities = self._problem.equations.taped(of.quantities)
        found = quantities.rows([numbers.parameters], count)[:LEADING_QUANTITIES]
        sealed, rest, _, motion, swing, _ = found
        parameters = np.concatenate([np.ones((count, 1)), sealed, numbers.parameters], axis=1)
        of_assembly = self._compiled.numbers_of(parameters)
        return _Rows(numbers, parameters, of_assembly, rest, motion[:, 0], swing[:, 0])

    # -- steps ----------------------------------------------------------------------

    def _marched(self, rows: _Rows, here: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Unknowns (m, T, nx + nz) at the output times, and which rows got to the end (m,).

        ``here`` (m, nx + nz): where they start.
        """
        count, stops = len(here), rows.numbers.stops
        found = np.zeros((count, len(self._times), self._problem.unknowns))
        outputs = [outputs_between(own, self._times) for own in stops]
        left, taken, sizes = np.arange(count), np.zeros(count, dtype=int), None
        for k in range(stops.shape[1] - 1):
            Y, is_found = self._begun(rows.some(left), here, k)
            left, Y = left[is_found], Y[is_found]
            if not len(left):
                break
            sizes = None if sizes is None else sizes[is_found]
            own = [outputs[row][k] for row in left]
            marches = self._over(rows.some(left), Y, k, own, sizes)
            for row, part, y, after in zip(left, own, Y, marches.outputs, strict=True):
                if k == 0:
                    found[row, : part.start] = y[: found.shape[2]]
                found[row, part] = after[: part.stop - part.start, : found.shape[2]]
            taken[left] += marches.steps
            is_found = marches.finished & (taken[left] <= self._problem.max_steps)
            left, sizes = left[is_found], marches.sizes[is_found]
            here = marches.y[is_found, : found.shape[2]]
        return found, np.isin(np.arange(count), left)

    def _over(
        self, rows: _Rows, Y: np.ndarray, k: int, outputs: list[slice], sizes: np.ndarray | None
    ) -> RowMarches:
        """Over stretch ``k``, with ``outputs`` of every row in it.

        ``sizes`` (m,): steps that suited what came before [s]; None at the start.
        """
        stops = rows.numbers.stops
        edges = [
            edges_of(own, k, self._times[part]) for own, part in zip(stops, outputs, strict=True)
        ]
        lengths = np.array([own[-1] for own in edges]) - stops[:, k]
        if sizes is None:
            first = np.array(
                [first_step(*own) for own in zip(rows.motion_times, lengths, strict=True)]
            )
        else:
            first = np.minimum(sizes, lengths)
        scales = rows.motion_times, rows.swing_times, lengths, stops[:, -1]
        settings = [self._steps.settings(*own) for own in zip(*scales, strict=True)]
        structure = self._steps.assembly, self._compiled.lu, self._mass, rows.of_assembly
        return march_rows(*structure, Y, settings, first, edges, self._problem.max_steps)

    def _begun(self, rows: _Rows, here: np.ndarray, k: int) -> tuple[np.ndarray, np.ndarray]:
        """Y (m, length) with consistent unknowns where stretch ``k`` begins, and which count (m,).

        As `Stretches.begin`, row by row.
        """
        assembly, algebraic = self._steps.assembly, self._compiled.algebraic
        times, pieces = rows.numbers.stops[:, k], rows.numbers.pieces[:, k]
        blank = np.zeros((len(here), self._problem.equations.integrals))
        y = np.concatenate([here, blank], axis=1)
        y = self._steps.with_sums(y, times, pieces, rows.parameters)
        drives, one = np.zeros((len(y), assembly.drives)), np.ones((len(y), 1))
        Y = np.concatenate([y, drives, times[:, None], pieces, one], axis=1)
        is_found, before = np.zeros(len(Y), dtype=bool), np.full(len(Y), np.inf)
        still = np.arange(len(Y))
        for _ in range(MAX_STAGE_CORRECTIONS):
            if not len(still):
                break
            J, residual = sums_of_rows(assembly, rows.of_assembly[still], Y[still])
            step = algebraic.steps(J, residual)
            size = np.max(np.abs(step), axis=1, initial=0.0)
            is_round_off = (size <= ROUND_OFF_CORRECTION) & (size > before[still] / 2)
            is_done = (size <= CONSISTENT) | is_round_off
            is_found[still[is_done]] = True
            before[still] = size
            goes_on = ~is_done & np.isfinite(size)
            still = still[goes_on]
            Y[still, : assembly.unknowns] += step[goes_on]
        return Y, is_found

    # -- columns --------------------------------------------------------------------

    def _read(self, rows: _Rows, unknowns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Columns (m, T, columns), and which motions have a meaning up to the end (m,)."""
        numbers = [rows.numbers.row(k) for k in range(len(unknowns))]
        both = zip(numbers, unknowns, strict=True)
        read = [self._reading.read(self._times, own, values) for own, values in both]
        if not read:
            return np.zeros((0, len(self._times), 0)), np.zeros(0, dtype=bool)
        columns = np.array([found.columns for found, _ in read])
        endings, looked_at = self._reading.endings, [values for _, values in read]
        limits = strictest(self._problem, rows.rest_amounts, rows.numbers.parameters)
        times = np.tile(self._times, len(read))
        if endings.failure(limits, times, np.concatenate(looked_at)) is None:
            return columns, np.ones(len(read), dtype=bool)
        # One of them ends, or two of them together look as if: each has limits of its own.
        alone = [problem_at(self._problem, self._times, own) for own in numbers]
        each = zip(alone, looked_at, strict=True)
        passed = [endings.failure(own, self._times, values) is None for own, values in each]
        return columns, np.array(passed)
