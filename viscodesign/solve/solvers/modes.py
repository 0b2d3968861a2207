"""Linear equations by their modes: no steps, and no error but that of resolving the input.

In a cell of time, inputs are interpolated at Gauss-Legendre points; the response of every mode
to that is exact, whatever its rate. Cells are cut until they resolve the inputs, and the rates
of the balances' integrals, to round-off or nearly so. The tolerance is not used.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.solve.numerics.exponential_weights import cell_points, weights
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start
from viscodesign.solve.time_only_integrals import RULE, graded_parts


@dataclass(frozen=True)
class CellRules:
    """How time is cut into cells."""

    points: tuple[int, ...] = (6, 12)
    """Gauss-Legendre points of a cell: so many that few cells are to be cut."""
    max_loose: float = 0.1
    """How few."""
    least_swing: float = 1e-7
    """Shortest swing beside a corner that is looked for, in durations of the run."""
    decays_per_cell: float = 8.0
    """Of the fastest mode, in the first cell after a corner: only there it moves."""
    input_rel_tol: float = 3e-13
    """Error of interpolating an input in a cell, over its largest value."""
    least_input: float = 1e-3
    """Departure of an input to which errors are relative at least, over its terms."""
    input_noise: float = 1e-9
    """The same, up to which it may be round-off."""
    noise_ratio: float = 0.1
    """Ratio of it to that before halving, from which it is."""
    integral_rel_tol: float = 1e-9
    """Estimated error of a cell's integral of a rate, over that of all cells at once."""
    least_integral: float = 1e-5
    """Integral, over the size of an energy, to which errors are relative at least."""
    noise: float = 1e-13
    """Part of the largest term of a rate that is round-off."""
    max_halved: int = 300_000
    """Cells that are halved at once, at most: a second's work."""
    max_cuts: int = 40
    """Times that a cell is halved to resolve the inputs."""
    max_rate_cuts: int = 10
    """The same to resolve the rates."""
    numbers_at_once: int = 300_000
    """Modes times points held in memory, about."""
    max_states: int = 400
    """Up to which it is chosen by itself."""
    same_length_rel: float = 1e-11
    """Difference of cells that have the same length but for round-off."""
    same_signal_rel: float = 1e-14
    """Difference of inputs that are the same but for round-off."""
    few_lengths: int = 8
    """Different lengths of cells up to which each is handled by itself."""


RULES = CellRules()
TINY = np.finfo(float).tiny


class LinearModes(Solver):
    """The modes of linear equations with constant coefficients, each by itself."""

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
        return max(RULES.numbers_at_once // (RULES.points[0] * self.problem.unknowns), 8)


@dataclass(frozen=True)
class _Cells:
    """Cells of time, with what depends on time alone at their points."""

    begins: np.ndarray
    """(c,)"""
    lengths: np.ndarray
    """(c,)"""
    owner: np.ndarray
    """(c,): interval of each, counted from the first."""
    values: np.ndarray
    """(D + nq + k, c, P): inputs, quadratic rates at zero unknowns, their derivatives there."""

    def __getitem__(self, some: np.ndarray) -> _Cells:
        return _Cells(self.begins[some], self.lengths[some], self.owner[some], self.values[:, some])


def _in_order(parts: Sequence[_Cells]) -> _Cells:
    """All cells together, ascending in time."""
    if len(parts) == 1 and np.all(np.diff(parts[0].begins) > 0.0):
        return parts[0]
    joined = _Cells(
        np.concatenate([part.begins for part in parts]),
        np.concatenate([part.lengths for part in parts]),
        np.concatenate([part.owner for part in parts]),
        np.concatenate([part.values for part in parts], axis=1),
    )
    return joined[np.argsort(joined.begins)]


class _Stretch:
    """Consecutive intervals, solved all at once."""

    def __init__(self, problem: Problem, here: Start, first: int, stop: int) -> None:
        assert problem.modal_system is not None
        self.problem, self.system = problem, problem.modal_system
        self.points = cell_points(RULES.points[0])
        self.edges = problem.schedule.edges[first : stop + 1]
        self.pieces = problem.schedule.pieces[first:stop]
        changes = problem.schedule.pieces.changes - first
        self.corners = np.zeros(stop - first, dtype=bool)
        self.corners[changes[(changes >= 0) & (changes < stop - first)]] = True
        self.corners[0] |= first == 0
        self.input_count = len(self.system.input_rows)
        self.origin = np.concatenate([here.states, here.algebraics])
        """States and algebraic unknowns (nx + nz,) at the first edge."""
        begin = float(self.edges[0])
        tail = problem.tail(begin, self.pieces[0])
        rows = evaluate(problem.equations.function, here.states, here.algebraics, *tail)
        self.first_rows = np.concatenate([np.array(row).ravel() for row in rows])[self.system.order]
        """Values of the rows there and then."""
        first_inputs = self._inputs_at(np.array([begin]), np.array([0]))
        self.first_inputs = first_inputs[: self.input_count]

    def solve(self, work: Work) -> Columns:
        """States, algebraic unknowns and integrals at the edges but the first."""
        cells = self._cells()
        for cut in range(RULES.max_rate_cuts + 1):
            signals, rows = self._signals(cells)
            begins, inside = self._modes(cells, signals, rows)
            integrals, loose = self._integrals(cells, signals, rows, inside)
            if cut == RULES.max_rate_cuts or not loose.any():
                break
            cells = _in_order([cells[~loose], self._halved(cells[loose])])
        work.steps += len(cells.begins)
        swept = (signals @ self.points.share) * cells.lengths
        last = np.cumsum(np.bincount(cells.owner, minlength=len(self.edges) - 1)) - 1
        states = self._states(begins[:, last + 1], rows, np.cumsum(swept, axis=1)[:, last])
        algebraics = self._algebraics(states)
        count, origin = len(states), self.origin[:, None]
        states, algebraics = origin[:count] + states, origin[count:] + algebraics
        return states, algebraics, np.cumsum(integrals, axis=1)[:, last]

    # -- cells ------------------------------------------------------------------------------

    def _cells(self) -> _Cells:
        """Cells that resolve the inputs."""
        begins, ends, owner = graded_parts(self.edges, self._spacing())
        for count in RULES.points:
            self.points = cell_points(count)
            cells = self._evaluated(begins, ends - begins, owner)
            size = np.max(np.abs(cells.values[: self.input_count]), axis=(1, 2), initial=0.0)
            size = np.maximum(size, RULES.least_input * self.system.input_terms(self.origin))
            error = self._input_errors(cells, size)
            if np.count_nonzero(error > RULES.input_rel_tol) <= RULES.max_loose * len(error):
                break
        fine: list[_Cells] = []
        before = np.full(len(error), np.inf)
        for _ in range(RULES.max_cuts):
            # What does not fall when cells are halved is round-off of times and inputs.
            noisy = (error < RULES.input_noise) & (error > RULES.noise_ratio * before)
            loose = (error > RULES.input_rel_tol) & ~noisy
            if not loose.any() or np.count_nonzero(loose) > RULES.max_halved:
                break
            fine.append(cells[~loose])
            before = np.tile(error[loose], 2)
            cells = self._halved(cells[loose])
            error = self._input_errors(cells, size)
        return _in_order([*fine, cells])

    def _spacing(self) -> np.ndarray:
        """Length of the first and the last cell of each interval."""
        duration, swing = float(self.problem.schedule.edges[-1]), self.problem.equations.swing_time
        fastest = np.max(np.abs(self.system.rates), initial=0.0)
        spacing = np.full(len(self.edges) - 1, (swing or duration) / RULE.parts_per_swing)
        if not swing:  # some input jumps, and nothing is known of how fast the others swing
            beside = self.corners.copy()
            beside[:-1] |= self.corners[1:]
            spacing[beside] = RULES.least_swing * duration
        if fastest:
            decays = RULES.decays_per_cell / fastest
            spacing[self.corners] = np.minimum(spacing[self.corners], decays)
        return spacing

    def _input_errors(self, cells: _Cells, size: np.ndarray) -> np.ndarray:
        """Estimated error of interpolation of the inputs, over their sizes, in each cell (c,)."""
        missed = self._next_coefficients(cells.values[: self.input_count])
        missed = np.max(missed / np.maximum(size, TINY)[:, None], axis=0, initial=0.0)
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

    def _next_coefficients(self, values: np.ndarray) -> np.ndarray:
        """Legendre coefficients (..., c) beyond the last, as the last four let expect them."""
        last = np.abs(values @ self.points.coefficients[-4:].T)
        before, after = last[..., :2].max(axis=-1), last[..., 2:].max(axis=-1)
        return np.asarray(after * np.minimum(after / np.maximum(before, TINY), 1.0))

    def _halved(self, cells: _Cells) -> _Cells:
        half = cells.lengths / 2
        begins = np.concatenate([cells.begins, cells.begins + half])
        return self._evaluated(begins, np.tile(half, 2), np.tile(cells.owner, 2))

    def _evaluated(self, begins: np.ndarray, lengths: np.ndarray, owner: np.ndarray) -> _Cells:
        times = begins[:, None] + lengths[:, None] * self.points.theta[:-1]
        values = self._inputs_at(times.ravel(), np.repeat(owner, len(self.points.share)))
        return _Cells(begins, lengths, owner, values.reshape(len(values), len(begins), -1))

    def _inputs_at(self, times: np.ndarray, owner: np.ndarray) -> np.ndarray:
        """What depends on time alone (D + nq + k, N) at N instants in their intervals."""
        return self.system.inputs_at(self.origin, times, self.pieces[owner])

    def _signals(self, cells: _Cells) -> tuple[np.ndarray, np.ndarray]:
        """Signals (S, c, P), the first of which is one, and the rows as their sums (rows, S)."""
        inputs = cells.values[: self.input_count]
        moved = inputs.reshape(self.input_count, -1) - self.first_inputs
        shares, signals = combined(moved)
        rows = np.zeros((len(self.first_rows), 1 + len(signals)))
        rows[:, 0] = self.first_rows
        rows[self.system.input_rows, 1:] = shares
        every = np.vstack([np.ones((1, signals.shape[1])), signals])
        return every.reshape(-1, *inputs.shape[1:]), rows

    # -- modes ------------------------------------------------------------------------------

    def _modes(
        self, cells: _Cells, signals: np.ndarray, rows: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Modes at the beginning of every cell and at the end (n, c + 1), and inside (n, c, P)."""
        system, count = self.system, len(cells.lengths)
        drive = system.drive(rows[: len(system.live) + system.algebraics])
        force = (drive @ signals.reshape(len(signals), -1)).reshape(len(drive), count, -1)
        force = force * cells.lengths[:, None]
        decay, gain = np.empty((2, len(drive), count), dtype=drive.dtype)
        parts = []
        for own, length in _lengths(cells.lengths):
            found = weights(length[:, None] * system.rates, self.points)
            decays = found.decay.transpose(1, 0, 2)
            if len(length) == 1:
                gains = force[:, own] @ found.response[0].transpose(0, 2, 1)
            else:
                each = found.response @ force[:, own].transpose(1, 0, 2)[..., None]
                gains = each[..., 0].transpose(1, 0, 2)
            decay[:, own], gain[:, own] = decays[:, :, -1], gains[:, :, -1]
            parts.append((own, decays[:, :, :-1], gains[:, :, :-1]))
        begins = _marched(decay, gain, np.zeros(len(drive), dtype=drive.dtype))
        inside = np.empty_like(force)
        for own, decays, gains in parts:
            inside[:, own] = decays * begins[:, own, None] + gains
        return begins, inside

    def _integrals(
        self, cells: _Cells, signals: np.ndarray, rows: np.ndarray, inside: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Integrals of the quadratic rates over every cell (nq, c), and which are inaccurate."""
        quadratics, shape = self.system.quadratics, cells.values.shape[1:]
        offsets = self.system.offsets(rows)
        known = cells.values[self.input_count :].reshape(-1, shape[0] * shape[1])
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
        tail = np.maximum(self._next_coefficients(values) - noise, 0.0)
        error = cells.lengths * tail
        if np.isrealobj(self.system.rates):
            # Gauss' rule is exact to twice the order of the last coefficient. Vibrations, however,
            # may be small and not resolved.
            error = error * tail / np.maximum(np.maximum(size, tail), TINY)
        scale = np.maximum(size @ cells.lengths, RULES.least_integral)
        loose = np.any(error > RULES.integral_rel_tol * scale[:, None], axis=0)
        return cells.lengths * (values @ self.points.share), loose

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
            inputs = self._inputs_at(self.edges[1:], np.arange(count))
            values[system.input_rows] += inputs[: self.input_count] - self.first_inputs
        return system.algebraics_of(states[system.live], values[first:last])


def combined(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows (D, N) as sums of few signals: (D, S) and (S, N).

    Many tubes that begin at one inlet see the same pressure.
    """
    size = np.max(np.abs(rows), axis=1, initial=0.0)[:, None]
    rest = rows / np.where(size > 0.0, size, 1.0)
    shares: list[np.ndarray] = []
    signals: list[np.ndarray] = []
    while len(rest) and len(signals) < len(rows):
        largest = np.abs(rest).max(axis=1)
        k = int(np.argmax(largest))
        if largest[k] <= RULES.same_signal_rel:
            break
        signal = rest[k].copy()
        share = rest @ signal / (signal @ signal)
        rest -= share[:, None] * signal
        shares.append(share)
        signals.append(signal)
    found = np.array(shares).T.reshape(len(rows), len(shares)) * size
    return found, np.array(signals).reshape(len(signals), rows.shape[1])


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


def _marched(decay: np.ndarray, gain: np.ndarray, start: np.ndarray) -> np.ndarray:
    """y_0 (n,), and y_k+1 = decay_k y_k + gain_k: (n, c + 1) from (n, c).

    In blocks side by side, so that the loops are short.
    """
    modes, count = gain.shape
    width = int(np.ceil(np.sqrt(count)))
    blocks = -(-count // width)
    passed = np.ones((width, modes, blocks), dtype=gain.dtype)
    gained = np.zeros((width, modes, blocks), dtype=gain.dtype)
    padded = np.ones((modes, blocks * width), dtype=gain.dtype)
    padded[:, :count] = decay
    by_step = padded.reshape(modes, blocks, width).transpose(2, 0, 1)
    padded = np.zeros_like(padded)
    padded[:, :count] = gain
    gain_by_step = padded.reshape(modes, blocks, width).transpose(2, 0, 1)
    before_p, before_g = np.ones((modes, blocks)), np.zeros((modes, blocks))
    for k in range(width):
        before_p = passed[k] = by_step[k] * before_p
        before_g = gained[k] = by_step[k] * before_g + gain_by_step[k]
    carried = np.empty((modes, blocks), dtype=gain.dtype)
    here = start
    for block in range(blocks):
        carried[:, block] = here
        here = passed[-1, :, block] * here + gained[-1, :, block]
    every = (passed * carried + gained).transpose(1, 2, 0).reshape(modes, -1)
    return np.concatenate([start[:, None], every[:, :count]], axis=1)
