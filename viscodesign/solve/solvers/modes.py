"""Linear equations by their modes: no steps, and no error but that of resolving the input.

In a cell of time, inputs are interpolated at Gauss-Legendre points; the response of every mode
to that is exact, whatever its rate. Cells are cut until they resolve the inputs, and the rates
of the balances' integrals, to round-off or nearly so. The tolerance is not used.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.numerics.common_signals import combined
from viscodesign.solve.numerics.exponential_weights import weights
from viscodesign.solve.numerics.linear_recurrence import marched
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.solvers.mode_cells import (
    CELL_RULES,
    SMALLEST_NORMAL,
    CellGrid,
    ModeCells,
    in_order,
)
from viscodesign.solve.statics import Start


@dataclass(frozen=True)
class ModeRules:
    """How accurate integrals of rates are, and how much is solved at once."""

    integral_rel_tol: float = 1e-9
    """Estimated error of a cell's integral of a rate, over that of all cells at once."""
    least_integral: float = 1e-5
    """Integral, over the size of an energy, to which errors are relative at least."""
    noise: float = 1e-13
    """Part of the largest term of a rate that is round-off."""
    max_rate_cuts: int = 10
    """Times that cells are halved to resolve the rates."""
    numbers_at_once: int = 300_000
    """Modes times points held in memory, about."""
    max_states: int = 400
    """Up to which it is chosen automatically."""
    same_length_rel: float = 1e-11
    """Difference of cells that have the same length but for round-off."""
    few_lengths: int = 8
    """Different lengths of cells up to which each is handled separately."""


RULES = ModeRules()


class LinearModes(Solver):
    """The modes of linear equations with constant coefficients, each solved independently."""

    name: ClassVar[str] = "modes"
    order: ClassVar[int] = 40
    title: ClassVar[str] = "Modes: linear equations, exact in time"
    tip_error_per_tolerance: ClassVar[float] = 1e-3
    is_exact: ClassVar[bool] = True

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Only linear equations have modes."""
        return problem.modal_system is not None

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Finding the modes takes the cube of their number: beyond some hundreds, steps pay."""
        return problem.equations.states.count <= RULES.max_states

    def remedies(self) -> Iterator[tuple[str, Solver]]:
        """None: there is nothing to be more cautious with."""
        return iter(())

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, as many at once as memory allows."""
        begin, total = first, np.zeros(self.nothing()[2].shape[0])
        done: list[Columns] = []
        while begin < stop:
            end = min(begin + self._at_once(), stop)
            columns = _Stretch(self.problem, here, begin, end).solve(work)
            states, algebraics, integrals = columns[0], columns[1], columns[2] + total[:, None]
            done.append((states, algebraics, integrals))
            here, total, begin = Start(states[:, -1], algebraics[:, -1]), integrals[:, -1], end
        joined = [np.concatenate(parts, axis=1) for parts in zip(*done, strict=True)]
        return (joined[0], joined[1], joined[2]), None

    def _at_once(self) -> int:
        """Intervals that are solved together."""
        return max(RULES.numbers_at_once // (CELL_RULES.points[0] * self.problem.unknowns), 8)


class _Stretch:
    """Consecutive intervals, solved all at once."""

    def __init__(self, problem: Problem, here: Start, first: int, stop: int) -> None:
        assert problem.modal_system is not None
        self.problem, self.system = problem, problem.modal_system
        self.origin = np.concatenate([here.states, here.algebraics])
        """States and algebraic unknowns (nx + nz,) at the first edge."""
        self.grid = CellGrid(problem, self.system, slice(first, stop), self.origin)
        begin = float(self.grid.edges[0])
        tail = problem.tail(begin, self.grid.pieces[0])
        rows = evaluate(problem.equations.function, here.states, here.algebraics, *tail)
        self.first_rows = np.concatenate([np.array(row).ravel() for row in rows])[self.system.order]
        """Values of the rows there and then."""
        first_inputs = self.grid.inputs_at(np.array([begin]), np.array([0]))
        self.first_inputs = first_inputs[: self.grid.input_count]

    def solve(self, work: Work) -> Columns:
        """States, algebraic unknowns and integrals at the edges but the first."""
        cells = self.grid.cells()
        for cut in range(RULES.max_rate_cuts + 1):
            signals, rows = self._signals(cells)
            begins, inside = self._modes(cells, signals, rows)
            integrals, loose = self._integrals(cells, signals, rows, inside)
            if cut == RULES.max_rate_cuts or not loose.any():
                break
            cells = in_order([cells[~loose], self.grid.halved(cells[loose])])
        work.steps += len(cells.begins)
        swept = (signals @ self.grid.points.share) * cells.lengths
        last = np.cumsum(np.bincount(cells.owner, minlength=len(self.grid.edges) - 1)) - 1
        states = self._states(begins[:, last + 1], rows, np.cumsum(swept, axis=1)[:, last])
        algebraics = self._algebraics(states)
        count, origin = len(states), self.origin[:, None]
        states, algebraics = origin[:count] + states, origin[count:] + algebraics
        return states, algebraics, np.cumsum(integrals, axis=1)[:, last]

    def _signals(self, cells: ModeCells) -> tuple[np.ndarray, np.ndarray]:
        """Signals (S, c, P), the first of which is one, and the rows as their sums (rows, S)."""
        inputs = cells.values[: self.grid.input_count]
        moved = inputs.reshape(self.grid.input_count, -1) - self.first_inputs
        shares, signals = combined(moved)
        rows = np.zeros((len(self.first_rows), 1 + len(signals)))
        rows[:, 0] = self.first_rows
        rows[self.system.input_rows, 1:] = shares
        every = np.vstack([np.ones((1, signals.shape[1])), signals])
        return every.reshape(-1, *inputs.shape[1:]), rows

    # -- modes ------------------------------------------------------------------------------

    def _modes(
        self, cells: ModeCells, signals: np.ndarray, rows: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Modes at the beginning of every cell and at the end (n, c + 1), and inside (n, c, P)."""
        system, count = self.system, len(cells.lengths)
        drive = system.drive(rows[: len(system.live) + system.algebraics])
        force = (drive @ signals.reshape(len(signals), -1)).reshape(len(drive), count, -1)
        force = force * cells.lengths[:, None]
        decay, gain = np.empty((2, len(drive), count), dtype=drive.dtype)
        parts = []
        for own, length in _lengths(cells.lengths):
            found = weights(length[:, None] * system.rates, self.grid.points)
            decays = found.decay.transpose(1, 0, 2)
            if len(length) == 1:
                gains = force[:, own] @ found.response[0].transpose(0, 2, 1)
            else:
                each = found.response @ force[:, own].transpose(1, 0, 2)[..., None]
                gains = each[..., 0].transpose(1, 0, 2)
            decay[:, own], gain[:, own] = decays[:, :, -1], gains[:, :, -1]
            parts.append((own, decays[:, :, :-1], gains[:, :, :-1]))
        begins = marched(decay, gain, np.zeros(len(drive), dtype=drive.dtype))
        inside = np.empty_like(force)
        for own, decays, gains in parts:
            inside[:, own] = decays * begins[:, own, None] + gains
        return begins, inside

    def _integrals(
        self, cells: ModeCells, signals: np.ndarray, rows: np.ndarray, inside: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Integrals of the quadratic rates over every cell (nq, c), and which are inaccurate."""
        quadratics, shape = self.system.quadratics, cells.values.shape[1:]
        offsets = self.system.offsets(rows)
        known = cells.values[self.grid.input_count :].reshape(-1, shape[0] * shape[1])
        starts, slopes = known[: len(quadratics)], known[len(quadratics) :]
        signals, inside = (v.reshape(len(v), -1) for v in (signals, inside))
        values = np.empty_like(starts)
        for k, quadratic in enumerate(quadratics):
            own = slopes[quadratic.slope_rows]
            fixed = quadratic.fixed_slopes(self.origin[self.system.order[: len(offsets)]])
            values[k] = quadratic.values(starts[k], own, fixed, offsets, signals, inside)
        values, starts = (v.reshape(-1, *shape) for v in (values, starts))
        size = np.abs(values).max(axis=-1)
        noise = RULES.noise * np.abs(starts).max(axis=-1)
        tail = np.maximum(self.grid.next_coefficients(values) - noise, 0.0)
        error = cells.lengths * tail
        if np.isrealobj(self.system.rates):
            # Gauss' rule is exact to twice the order of the last coefficient. Vibrations, however,
            # may be small and not resolved.
            error = error * tail / np.maximum(np.maximum(size, tail), SMALLEST_NORMAL)
        scale = np.maximum(size @ cells.lengths, RULES.least_integral)
        loose = np.any(error > RULES.integral_rel_tol * scale[:, None], axis=0)
        return cells.lengths * (values @ self.grid.points.share), loose

    # -- columns ----------------------------------------------------------------------------

    def _states(self, modes: np.ndarray, rows: np.ndarray, swept: np.ndarray) -> np.ndarray:
        """Departures of the states (nx, m), from modes (n, m) and signals' integrals (S, m)."""
        system = self.system
        found = np.empty((len(system.live) + len(system.idle), modes.shape[1]))
        live = (system.shapes @ modes).real
        found[system.live] = live
        sums = system.idle_by[:, : len(live)] @ live
        found[system.idle] = sums + system.idle_drive(rows) @ swept
        return found

    def _algebraics(self, states: np.ndarray) -> np.ndarray:
        """Departures of the algebraic unknowns (nz, m) at the ends of the intervals."""
        system, count = self.system, states.shape[1]
        first, last = len(system.live), len(system.live) + system.algebraics
        values = np.repeat(self.first_rows[:, None], count, axis=1)
        if np.any((system.input_rows >= first) & (system.input_rows < last)):
            inputs = self.grid.inputs_at(self.grid.edges[1:], np.arange(count))
            values[system.input_rows] += inputs[: self.grid.input_count] - self.first_inputs
        return system.algebraics_of(states[system.live], values[first:last])


def _lengths(lengths: np.ndarray) -> Iterator[tuple[np.ndarray | slice, np.ndarray]]:
    """Cells, and their lengths: one for all that agree but for round-off, or one for each."""
    if np.ptp(lengths) <= RULES.same_length_rel * lengths[0]:
        yield slice(0, len(lengths)), lengths.mean(keepdims=True)
        return
    order = np.argsort(lengths, kind="stable")
    ranked = lengths[order]
    new = np.diff(ranked) > RULES.same_length_rel * ranked[:-1]
    firsts = np.concatenate([[0], np.flatnonzero(new) + 1])
    if len(firsts) > RULES.few_lengths + len(lengths) // 8:
        yield slice(0, len(lengths)), lengths
        return
    for begin, end in zip(firsts, [*firsts[1:], len(lengths)], strict=True):
        yield np.sort(order[begin:end]), ranked[begin:end].mean(keepdims=True)
