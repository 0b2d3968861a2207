"""A scene's motion as a function of its numbers, with derivatives of the solution itself."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import casadi as ca
import numpy as np

from viscodesign.compiled.problem_at import problem_at, stretch_of
from viscodesign.compiled.reading import Members, ReadColumns, Reading
from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.start import FoundStart, StartFunction
from viscodesign.compiled.symbols import Symbols
from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.local_equations import LocalEquations
from viscodesign.model.rod_equations import RodForm
from viscodesign.native.derivatives import (
    Consistency,
    Differentiable,
    Dots,
    Stretch,
    pull_back,
    push_forward,
)
from viscodesign.native.march import MarchState, MarchStatus, StepRecord
from viscodesign.native.tables import Assembly
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.problem import SAME_TIME, Problem
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.statics import Instant, Start, consistent

CONSISTENT = 1e-12
"""Correction of algebraic unknowns, in their sizes, at which they count as solved."""
ROUND_OFF_CORRECTION = 1e-8
"""Correction that is round-off of stiff equations if it no longer gets smaller."""
MAX_CORRECTIONS = 12


@dataclass(frozen=True)
class SolvedStretch:
    """One smooth stretch of a solved run."""

    begin: Consistency
    march: Stretch
    outputs: slice
    """Which of the output times lie behind its beginning and up to its end."""


@dataclass(frozen=True)
class TakenStretch:
    """What going over one smooth stretch gives."""

    begin: Consistency
    march: Stretch
    columns: np.ndarray
    """(edges, n)"""
    end: Start
    size: float
    """First step that suits what follows [s]."""
    steps: int


@dataclass(frozen=True)
class SolvedMotion:
    """A solved run, and what its derivatives need."""

    problem: Problem
    assembly: Assembly
    start: FoundStart
    stretches: list[SolvedStretch]
    read: ReadColumns
    steps: int

    @property
    def columns(self) -> np.ndarray:
        """(T, columns): what was asked for."""
        return self.read.columns


class MotionFunction:
    """Columns (T, columns) at the output times as a function of the numbers of a problem.

    Made for one problem, whose structure, output times and scalings stay. Stateless: any number
    of threads may use it. Raises `NativeUnavailable` where the equations cannot be stepped in
    native code.
    """

    def __init__(
        self,
        problem: Problem,
        tolerance: float,
        members: Members,
        columns: Sequence[str],
        *,
        steady: bool,
    ) -> None:
        self._problem, self._tolerance = problem, tolerance
        self.columns = tuple(columns)
        self.times = problem.schedule.edges[problem.schedule.outputs]
        """(T,) output times [s]."""
        NativeSteps(problem, tolerance)
        self._start = StartFunction(problem, steady=steady)
        self.reading = Reading(problem, members, columns)
        own = Symbols.of(problem)
        (numbers,) = self._local.form.numbers.call([ca.vertcat(1, own.sealed, own.parameters)])
        self._numbers = RowFunction([own.parameters], numbers, at_once=1)

    @property
    def _local(self) -> LocalEquations:
        local = self._problem.equations.local
        assert local is not None, "native steps have it"
        return local

    @property
    def _structure(self) -> Differentiable:
        return self._local.compiled.differentiable

    # -- values -------------------------------------------------------------------

    def solve(self, numbers: ProblemNumbers, *, recorded: bool = True) -> SolvedMotion:
        """Solve the run, its steps ``recorded`` for derivatives.

        Raises `SolveError` where that fails on the way.
        """
        problem = problem_at(self._problem, self.times, numbers)
        steps = NativeSteps(problem, self._tolerance)
        found = self._start(problem)
        here, size, taken = found.start, None, 0
        stretches, columns = [], []
        for k, outputs in enumerate(self._outputs_between(numbers.stops)):
            edges = self._edges(numbers.stops, k, outputs)
            before = (float(numbers.stops[k]), numbers.pieces[k - 1]) if k else None
            own = (float(numbers.stops[k]), numbers.pieces[k])
            part = self.advance(
                steps, here, own, edges, size, before=before, taken=taken, recorded=recorded
            )
            if k == 0 and len(self.times) and self.times[0] <= 0.0:
                columns.append(part.begin.Y[None, : problem.unknowns])
            columns.append(part.columns[: outputs.stop - outputs.start, : problem.unknowns])
            stretches.append(SolvedStretch(part.begin, part.march, outputs))
            here, size, taken = part.end, part.size, taken + part.steps
        read = self.reading(problem, self.times, numbers, np.concatenate(columns))
        return SolvedMotion(problem, steps.assembly, found, stretches, read, taken)

    def begin(self, steps: NativeSteps, numbers: ProblemNumbers) -> np.ndarray:
        """Consistent unknowns (n,) at the start of a run."""
        here = self._start(steps.problem).start
        begins = (float(numbers.stops[0]), numbers.pieces[0])
        return self._begin(steps, here, begins, None).Y[: steps.assembly.unknowns]

    def advance(
        self,
        steps: NativeSteps,
        here: Start,
        begins: Instant,
        edges: np.ndarray,
        size: float | None,
        *,
        before: Instant | None = None,
        taken: int = 0,
        recorded: bool = True,
    ) -> TakenStretch:
        """Go over one smooth stretch from a state, to the last of its edges.

        ``begins``: when, and its coefficients; ``size``: of the first step [s]; ``before``: the
        same instant with the coefficients of the stretch before; ``taken``: steps so far.
        """
        (time, piece), problem = begins, steps.problem
        begin = self._begin(steps, here, begins, before)
        state = MarchState(
            y=begin.Y[: steps.assembly.unknowns].copy(),
            time=time,
            size=steps.first_size(size, edges[-1] - time),
        )
        record, rest = StepRecord() if recorded else None, np.append(piece, 1.0)
        columns = self._march(problem, steps, state, rest, edges, record, taken)
        states, unknowns = problem.equations.states.count, problem.unknowns
        end = Start(state.y[:states], state.y[states:unknowns])
        march = Stretch(rest, edges, np.zeros((0, 0)) if record is None else record.rows)
        return TakenStretch(begin, march, columns, end, state.size, state.steps)

    def _outputs_between(self, stops: np.ndarray) -> list[slice]:
        """Which output times each stretch has; that at t = 0 belongs to none."""
        ends = np.searchsorted(self.times, stops + SAME_TIME * stops[-1], side="right").tolist()
        return [slice(i, j) for i, j in itertools.pairwise(ends)]

    def _edges(self, stops: np.ndarray, k: int, outputs: slice) -> np.ndarray:
        """Output times of a stretch, and its end where that is none."""
        times, end = self.times[outputs], stops[k + 1]
        if len(times) and end - times[-1] <= SAME_TIME * stops[-1]:
            times = times[:-1]
        return np.append(times, end)

    def _begin(
        self,
        steps: NativeSteps,
        here: Start,
        begins: Instant,
        before: Instant | None,
    ) -> Consistency:
        """Consistent unknowns at the beginning of a stretch."""
        (time, piece), problem = begins, steps.problem
        if problem.equations.rod_form is RodForm.STATIC and before is not None:
            here = consistent(problem, here, time, piece, before)
        y, before_size = steps.unknowns_at(here, time, piece), np.inf
        for _ in range(MAX_CORRECTIONS):
            try:
                begin = Consistency(self._structure, steps.assembly, y, time, np.append(piece, 1.0))
                correction = begin.correction()
            except ZeroDivisionError as error:
                raise NativeUnavailable(f"at t = {time:.6g} s, {error}") from error
            size = float(np.max(np.abs(correction), initial=0.0))
            is_round_off = size <= ROUND_OFF_CORRECTION and size > before_size / 2
            if size <= CONSISTENT or is_round_off:
                return begin
            if not np.isfinite(size):
                break
            y, before_size = y + correction, size
        raise SolveError(
            f"no pressures and forces belong to the state at t = {time:.6g} s",
            quantity="equilibrium",
            where="rod",
            time_s=time,
            remedy="Simulate these values by `simulate`, which raises the loads step by step.",
        )

    def _march(
        self,
        problem: Problem,
        steps: NativeSteps,
        state: MarchState,
        rest: np.ndarray,
        edges: np.ndarray,
        record: StepRecord | None,
        taken: int,
    ) -> np.ndarray:
        begin, found = state.time, []
        while True:
            left = problem.max_steps - taken - state.steps
            status, columns = steps.march(state, rest, begin, edges, max(left, 1), record)
            found.append(columns)
            if status is MarchStatus.FINISHED:
                return np.concatenate(found)
            if status is not MarchStatus.STEP_LIMIT or left <= 0:
                raise _stopped(state.time, status is MarchStatus.STEP_LIMIT)

    # -- derivatives --------------------------------------------------------------

    def pull_back(
        self, solved: SolvedMotion, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers:
        """Slopes of weights (T, columns) times the columns by all numbers."""
        own, n = self._structure, solved.assembly.unknowns
        x_bar, z_bar, _, piece_bar, parameters = self.reading.pull_back(solved.read.rows, weights)
        pieces, stops = np.zeros_like(numbers.pieces), np.zeros_like(numbers.stops)
        np.add.at(pieces, stretch_of(self.times, numbers), piece_bar)
        every = np.zeros((len(self.times), n))
        every[:, : solved.problem.unknowns] = np.concatenate([x_bar, z_bar], axis=1)
        y_bar, numbers_bar = np.zeros(n), np.zeros(len(solved.assembly.all_numbers))
        for k in range(len(solved.stretches) - 1, -1, -1):
            stretch = solved.stretches[k]
            at_edges = np.zeros((len(stretch.march.edges), n))
            at_edges[: _length(stretch.outputs)] = every[stretch.outputs]
            bars = pull_back(own, solved.assembly, stretch.march, at_edges, y_bar)
            if k == 0 and stretch.outputs.start > 0:
                bars.begin += every[0]
            first = stretch.begin.pull_back(bars.begin)
            for found in (bars, first):
                pieces[k] += found.rest[:-1]
                stops[k : k + 2] += found.ends
                numbers_bar += found.numbers
            y_bar = first.begin
        begin = y_bar[: solved.problem.unknowns]
        initial, more = self._start.pull_back(solved.problem, solved.start, begin)
        return ProblemNumbers(
            parameters + more + self._by_parameters(numbers, numbers_bar), pieces, initial, stops
        )

    def _by_parameters(self, numbers: ProblemNumbers, bars: np.ndarray) -> np.ndarray:
        """Slopes by the parameters for those by the numbers of the assembly."""
        places = self._local.compiled.places_of_numbers
        summed = np.bincount(places, bars, self._numbers.size)
        (found,) = self._numbers.pull_back([numbers.parameters[None]], summed[None])
        return np.asarray(found[0])

    def push_forward(
        self, solved: SolvedMotion, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray:
        """Rates (d, T, columns) along d directions, the first axis of all ``dots``."""
        own, n = self._structure, solved.assembly.unknowns
        count, unknowns = len(dots.parameters), solved.problem.unknowns
        rows = [np.repeat(numbers.parameters[None], count, axis=0)]
        places = self._local.compiled.places_of_numbers
        moved = self._numbers.push_forward(rows, [dots.parameters])[:, places]
        y_dot = np.zeros((count, n))
        y_dot[:, :unknowns] = self._start.push_forward(
            solved.problem, solved.start, dots.initial_piece, dots.parameters
        )
        every = np.zeros((count, len(self.times), unknowns))
        for k, stretch in enumerate(solved.stretches):
            rest = np.concatenate([dots.pieces[:, k], np.zeros((count, 1))], axis=1)
            own_dots = Dots(y_dot, rest, dots.stops[:, k : k + 2], moved)
            begin = stretch.begin.push_forward(own_dots)
            if k == 0 and stretch.outputs.start > 0:
                every[:, 0] = begin[:, :unknowns]
            found, y_dot = push_forward(
                own, solved.assembly, stretch.march, replace(own_dots, begin=begin)
            )
            length = _length(stretch.outputs)
            every[:, stretch.outputs] = found[:, :length, :unknowns]
        states, stretches = solved.problem.equations.states.count, stretch_of(self.times, numbers)
        return np.array([
            self.reading.push_forward(
                solved.read.rows,
                [
                    every[d, :, :states],
                    every[d, :, states:],
                    np.zeros((len(self.times), 1)),
                    dots.pieces[d][stretches],
                    dots.parameters[d],
                ],
            )
            for d in range(count)
        ])  # fmt: skip


def _length(rows: slice) -> int:
    return int(rows.stop - rows.start)


def _stopped(time: float, at_limit: bool) -> SolveError:
    """A failure on the way."""
    reason = "the limit of steps was reached" if at_limit else "steps became too small"
    return SolveError(
        f"{reason} at t = {time:.6g} s",
        quantity="work" if at_limit else "step",
        where="run",
        time_s=time,
        remedy="Raise run.max_steps." if at_limit else "Look at the motion by `simulate`.",
    )
