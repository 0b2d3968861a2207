"""A scene's motion as a function of its numbers, with derivatives of the solution itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from viscodesign.compiled.cycle_start import CycleStart
from viscodesign.compiled.output_times import OutputTimes
from viscodesign.compiled.problem_at import problem_at, stretch_of
from viscodesign.compiled.reading import Members, ReadColumns, Reading
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.side_by_side import SideBySide
from viscodesign.compiled.start import StartFunction
from viscodesign.compiled.stretch_slopes import StretchDots, StretchSlopes
from viscodesign.compiled.stretches import SolvedStretches, Stretches, TakenStretch
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.statics import Instant, Start
from viscodesign.storage.cached_property import cached_property


class FoundStart(Protocol):
    """Where a run starts, and what its derivatives need."""

    @property
    def start(self) -> Start:
        """The unknowns."""


class RunStart(Protocol):
    """Where a run starts, as a function of the numbers of a problem."""

    def __call__(self, problem: Problem, numbers: ProblemNumbers) -> Any: ...

    def pull_back(
        self, problem: Problem, found: Any, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers: ...

    def push_forward(
        self, problem: Problem, found: Any, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray: ...


@dataclass(frozen=True)
class SolvedMotion:
    """A solved run, and what its derivatives need."""

    problem: Problem
    start: FoundStart
    run: SolvedStretches
    read: ReadColumns

    @property
    def columns(self) -> np.ndarray:
        """(T, columns): what was asked for."""
        return self.read.columns

    @property
    def steps(self) -> int:
        """Steps taken, without those of finding the start."""
        return self.run.steps


class MotionFunction:
    """Columns (T, columns) at the output times as a function of the numbers of a problem.

    Made for one problem, whose structure, output times and scalings stay; ``start``: as in the
    spec. Stateless: any number of threads may use it. Raises `NativeUnavailable` where the
    equations cannot be stepped in native code.
    """

    def __init__(
        self,
        problem: Problem,
        tolerance: float,
        members: Members,
        columns: Sequence[str],
        *,
        start: str,
        follow: bool = False,
    ) -> None:
        self._problem, self._tolerance = problem, tolerance
        self.columns = tuple(columns)
        self._times = OutputTimes.of(problem, follow=follow)
        self.times = self._times.own
        """(T,) output times of the problem itself [s]."""
        self._stretches, self._slopes = Stretches(problem, tolerance), StretchSlopes.of(problem)
        self._steady = StartFunction(problem, steady=start != "rest")
        self._start: RunStart = self._steady
        self._is_straight = start == "equilibrium" and not follow
        if start == "periodic":
            self._start = CycleStart(self._steady, self._stretches, self._slopes, tolerance)
        self.reading = Reading.of(problem, members, columns)

    # -- values -------------------------------------------------------------------

    def solve(self, numbers: ProblemNumbers, *, recorded: bool = True) -> SolvedMotion:
        """Solve the run, its steps ``recorded`` for derivatives.

        Raises `SolveError` where that fails on the way.
        """
        times = self._times.at(numbers)
        problem = problem_at(self._problem, times, numbers)
        steps = NativeSteps(problem, self._tolerance)
        found = self._start(problem, numbers)
        own = found.start, numbers.stops, numbers.pieces, times
        run = self._stretches.over(steps, *own, recorded=recorded)
        read = self.reading(problem, times, numbers, run.columns)
        return SolvedMotion(problem, found, run, read)

    @cached_property
    def side_by_side(self) -> SideBySide | None:
        """Solves many rows of numbers at once; None where each needs a way of its own."""
        if not self._is_straight or self._problem.equations.rod_form is RodForm.STATIC:
            return None
        given = self._problem, self._tolerance, self.times
        return SideBySide(*given, self._steady, self.reading)

    def begin(self, steps: NativeSteps, numbers: ProblemNumbers) -> np.ndarray:
        """Consistent unknowns (n,) at the start of a run."""
        here = self._start(steps.problem, numbers).start
        begins = (float(numbers.stops[0]), numbers.pieces[0])
        return self._stretches.begin(steps, here, begins).Y[: steps.assembly.unknowns]

    def advance(
        self,
        steps: NativeSteps,
        here: Start,
        begins: Instant,
        edges: np.ndarray,
        size: float | None,
    ) -> TakenStretch:
        """Go over one smooth stretch from a state; see `Stretches.advance`."""
        return self._stretches.advance(steps, here, begins, edges, size, recorded=False)

    # -- derivatives --------------------------------------------------------------

    def pull_back(
        self, solved: SolvedMotion, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers:
        """Slopes of weights (T, columns) times the columns by all numbers."""
        x_bar, z_bar, _, piece_bar, parameters = self.reading.pull_back(solved.read.rows, weights)
        found = numbers.zeros()
        found.parameters[:] = parameters
        np.add.at(found.pieces, stretch_of(self._times.at(numbers), numbers), piece_bar)
        every, end = np.concatenate([x_bar, z_bar], axis=1), np.zeros(solved.problem.unknowns)
        bars = self._slopes.pull_back(solved.run, numbers.parameters, every, end)
        found.parameters[:] += bars.parameters
        found.pieces[:] += bars.pieces
        found.stops[:] += bars.stops
        return found.plus(self._start.pull_back(solved.problem, solved.start, numbers, bars.begin))

    def push_forward(
        self, solved: SolvedMotion, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray:
        """Rates (d, T, columns) along d directions, the first axis of all ``dots``."""
        begin = self._start.push_forward(solved.problem, solved.start, numbers, dots)
        own = StretchDots(begin, dots.pieces, dots.stops, dots.parameters)
        every, _ = self._slopes.push_forward(solved.run, numbers.parameters, own)
        states, stretches = (
            solved.problem.equations.states.count,
            stretch_of(self._times.at(numbers), numbers),
        )
        return np.array([
            self.reading.push_forward(
                solved.read.rows,
                [
                    moved[:, :states],
                    moved[:, states:],
                    np.zeros((len(self.times), 1)),
                    pieces[stretches],
                    parameters,
                ],
            )
            for moved, pieces, parameters in zip(every, dots.pieces, dots.parameters, strict=True)
        ])  # fmt: skip
