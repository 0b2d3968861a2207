"""Cells of time, at whose points inputs are interpolated by polynomials."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.modal_system import ModalSystem
from viscodesign.solve.numerics.exponential_weights import cell_points
from viscodesign.solve.problem import Problem
from viscodesign.solve.time_only_integrals import RULE, graded_parts


@dataclass(frozen=True)
class CellRules:
    """How time is cut into cells."""

    points: tuple[int, ...] = (6, 12)
    """Gauss-Legendre points of a cell: the first number with which few cells need cutting."""
    max_loose: float = 0.1
    """Share of the cells that counts as few."""
    least_swing: float = 1e-7
    """Shortest swing beside a corner that is looked for, in durations of the run."""
    decays_per_cell: float = 8.0
    """Decays of the fastest mode in the first cell after a corner: only there it moves."""
    input_rel_tol: float = 3e-13
    """Error of interpolating an input in a cell, over its largest value."""
    least_input: float = 1e-3
    """Departure of an input to which errors are relative at least, over its terms."""
    input_noise: float = 1e-9
    """The same, up to which it may be round-off."""
    noise_ratio: float = 0.1
    """Ratio of it to that before halving, from which it is."""
    max_halved: int = 300_000
    """Cells that are halved at once, at most: a second's work."""
    max_cuts: int = 40
    """Times that a cell is halved to resolve the inputs."""


CELL_RULES = CellRules()
SMALLEST_NORMAL = np.finfo(float).tiny


@dataclass(frozen=True)
class ModeCells:
    """Cells of time, with what depends on time alone at their points."""

    begins: np.ndarray
    """(c,)"""
    lengths: np.ndarray
    """(c,)"""
    owner: np.ndarray
    """(c,): interval of each, counted from the first."""
    values: np.ndarray
    """(D + nq + k, c, P): inputs, quadratic rates at zero unknowns, their derivatives there."""

    def __getitem__(self, some: np.ndarray) -> ModeCells:
        values = self.values[:, some]
        return ModeCells(self.begins[some], self.lengths[some], self.owner[some], values)


def in_order(parts: Sequence[ModeCells]) -> ModeCells:
    """All cells together, ascending in time."""
    if len(parts) == 1 and np.all(np.diff(parts[0].begins) > 0.0):
        return parts[0]
    joined = ModeCells(
        np.concatenate([part.begins for part in parts]),
        np.concatenate([part.lengths for part in parts]),
        np.concatenate([part.owner for part in parts]),
        np.concatenate([part.values for part in parts], axis=1),
    )
    return joined[np.argsort(joined.begins)]


class CellGrid:
    """Cells of consecutive intervals, cut until they resolve the inputs."""

    def __init__(
        self, problem: Problem, system: ModalSystem, intervals: slice, origin: np.ndarray
    ) -> None:
        """``origin`` (nx + nz,): the unknowns at the first edge of the intervals."""
        first, stop = intervals.start, intervals.stop
        self.problem, self.system, self.origin = problem, system, origin
        self.points = cell_points(CELL_RULES.points[0])
        self.edges = problem.schedule.edges[first : stop + 1]
        self.pieces = problem.schedule.pieces[first:stop]
        changes = problem.schedule.pieces.changes - first
        self.corners = np.zeros(stop - first, dtype=bool)
        self.corners[changes[(changes >= 0) & (changes < stop - first)]] = True
        self.corners[0] |= first == 0
        self.input_count = len(system.input_rows)

    def cells(self) -> ModeCells:
        """Cells that resolve the inputs."""
        begins, ends, owner = graded_parts(self.edges, self._spacing())
        for count in CELL_RULES.points:
            self.points = cell_points(count)
            cells = self._evaluated(begins, ends - begins, owner)
            size = np.max(np.abs(cells.values[: self.input_count]), axis=(1, 2), initial=0.0)
            size = np.maximum(size, CELL_RULES.least_input * self.system.input_terms(self.origin))
            error = self._input_errors(cells, size)
            if np.count_nonzero(error > CELL_RULES.input_rel_tol) <= CELL_RULES.max_loose * len(
                error
            ):
                break
        fine: list[ModeCells] = []
        before = np.full(len(error), np.inf)
        for _ in range(CELL_RULES.max_cuts):
            # What does not fall when cells are halved is round-off of times and inputs.
            noisy = (error < CELL_RULES.input_noise) & (error > CELL_RULES.noise_ratio * before)
            loose = (error > CELL_RULES.input_rel_tol) & ~noisy
            if not loose.any() or np.count_nonzero(loose) > CELL_RULES.max_halved:
                break
            fine.append(cells[~loose])
            before = np.tile(error[loose], 2)
            cells = self.halved(cells[loose])
            error = self._input_errors(cells, size)
        return in_order([*fine, cells])

    def _spacing(self) -> np.ndarray:
        """Length of the first and the last cell of each interval."""
        duration, swing = float(self.problem.schedule.edges[-1]), self.problem.equations.swing_time
        fastest = np.max(np.abs(self.system.rates), initial=0.0)
        spacing = np.full(len(self.edges) - 1, (swing or duration) / RULE.parts_per_swing)
        if not swing:  # some input jumps, and nothing is known of how fast the others swing
            beside = self.corners.copy()
            beside[:-1] |= self.corners[1:]
            spacing[beside] = CELL_RULES.least_swing * duration
        if fastest:
            decays = CELL_RULES.decays_per_cell / fastest
            spacing[self.corners] = np.minimum(spacing[self.corners], decays)
        return spacing

    def _input_errors(self, cells: ModeCells, size: np.ndarray) -> np.ndarray:
        """Estimated error of interpolation of the inputs, over their sizes, in each cell (c,)."""
        missed = self.next_coefficients(cells.values[: self.input_count])
        missed = np.max(missed / np.maximum(size, SMALLEST_NORMAL)[:, None], axis=0, initial=0.0)
        return self._response(missed, cells.lengths, len(self.points.share))

    def _response(self, missed: np.ndarray, lengths: np.ndarray, count: int) -> np.ndarray:
        """Error of the fastest mode and of the input's integral, by what interpolation missed.

        A Legendre polynomial of that order hardly moves a mode that is slow within the cell: by
        z (z/2)^n/(2n + 1)!! of its size, with n points.
        """
        half = np.max(np.abs(self.system.rates), initial=0.0) * lengths / 2
        odd = np.sum(np.log(np.arange(1, 2 * count + 2, 2)))
        with np.errstate(divide="ignore"):
            share = np.log(2) + (count + 1) * np.log(half) - odd
        return np.asarray(np.maximum(missed * np.exp(np.minimum(share, 0.0)), missed**2))

    def next_coefficients(self, values: np.ndarray) -> np.ndarray:
        """Legendre coefficients (..., c) beyond the last, extrapolated from the last four."""
        last = np.abs(values @ self.points.coefficients[-4:].T)
        before, after = last[..., :2].max(axis=-1), last[..., 2:].max(axis=-1)
        return np.asarray(after * np.minimum(after / np.maximum(before, SMALLEST_NORMAL), 1.0))

    def halved(self, cells: ModeCells) -> ModeCells:
        """Each of the cells in two."""
        half = cells.lengths / 2
        begins = np.concatenate([cells.begins, cells.begins + half])
        return self._evaluated(begins, np.tile(half, 2), np.tile(cells.owner, 2))

    def _evaluated(self, begins: np.ndarray, lengths: np.ndarray, owner: np.ndarray) -> ModeCells:
        times = begins[:, None] + lengths[:, None] * self.points.theta[:-1]
        values = self.inputs_at(times.ravel(), np.repeat(owner, len(self.points.share)))
        return ModeCells(begins, lengths, owner, values.reshape(len(values), len(begins), -1))

    def inputs_at(self, times: np.ndarray, owner: np.ndarray) -> np.ndarray:
        """What depends on time alone (D + nq + k, N) at N instants in their intervals."""
        return self.system.inputs_at(self.origin, times, self.pieces[owner])
