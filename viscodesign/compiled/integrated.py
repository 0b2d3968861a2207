"""The same function by the solvers of `simulate`: for equations that native steps do not take.

Derivatives are there where the equations are algebraic; their solutions at different times have
nothing to do with each other.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.output_times import OutputTimes
from viscodesign.compiled.problem_at import cycle_at, problem_at, stretch_of
from viscodesign.compiled.reading import Members, ReadColumns, Reading
from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.symbols import Symbols
from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.limit_cycle import limit_cycle
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start, equilibrium, rest
from viscodesign.solve.transient import integrate

SX = ca.SX


@dataclass(frozen=True)
class SolvedColumns:
    """A solved run, and what its derivatives need."""

    read: ReadColumns
    steps: int

    @property
    def columns(self) -> np.ndarray:
        """(T, columns): what was asked for."""
        return self.read.columns


class Constraints:
    """Algebraic equations of a motion without states, by rows of arguments. Stateless."""

    def __init__(self, problem: Problem) -> None:
        own = Symbols.of(problem)
        function = problem.equations.algebraic_function
        alg, slopes = function.call([own.states, own.algebraics, *own.tail])
        arguments = own.row[1:]
        self.residual = RowFunction(arguments, alg, shared=1)
        self._slopes = RowFunction(arguments, ca.vec(ca.densify(slopes)), shared=1)

    @classmethod
    def of(cls, problem: Problem) -> Constraints:
        """Those of all problems with these formulas."""
        return problem.equations.shared.derived(cls, None, lambda: cls(problem))

    def jacobians(self, rows: Sequence[np.ndarray]) -> np.ndarray:
        """(T, nz, nz) by the algebraic unknowns."""
        count = rows[0].shape[1]
        return self._slopes(*rows).reshape(len(rows[0]), count, count).transpose(0, 2, 1)


class IntegratedMotion:
    """Columns (T, columns) at the output times as a function of the numbers of a problem."""

    def __init__(
        self,
        problem: Problem,
        tolerance: float,
        solver: str,
        members: Members,
        columns: Sequence[str],
        *,
        start: str,
        reason: str = "",
        follow: bool = False,
    ) -> None:
        self._problem, self._tolerance, self._solver = problem, tolerance, solver
        self._begins, self._reason = start, reason
        self._times = OutputTimes.of(problem, follow=follow)
        self.times = self._times.own
        """(T,) output times of the problem itself [s]."""
        self._reading = Reading.of(problem, members, columns)
        self.side_by_side = None
        """Rows are solved one by one."""
        if not problem.equations.states.count:
            self._constraints = Constraints.of(problem)

    def solve(self, numbers: ProblemNumbers, *, recorded: bool = True) -> SolvedColumns:
        """Solve the run; there is nothing to record.

        Raises `SolveError` where that fails on the way.
        """
        del recorded
        times = self._times.at(numbers)
        problem = problem_at(self._problem, times, numbers)
        start = self._start(problem, numbers)
        found = integrate(problem, start, self._tolerance, solver=self._solver)
        if found.interrupted:
            raise KeyboardInterrupt
        if found.failure is not None:
            raise found.failure
        columns = np.concatenate([found.states, found.algebraics])[:, problem.schedule.outputs]
        read = self._reading(problem, times, numbers, columns.T)
        return SolvedColumns(read, found.work.steps)

    def _start(self, problem: Problem, numbers: ProblemNumbers) -> Start:
        if self._begins == "rest":
            return rest(problem, numbers.initial_piece)
        found = equilibrium(problem, 0.0, numbers.initial_piece)
        if self._begins == "periodic":
            one = cycle_at(problem, numbers)
            return limit_cycle(one, found, self._tolerance, self._solver).start
        return found

    def pull_back(
        self, solved: SolvedColumns, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers:
        """Slopes of weights (T, columns) times the columns by all numbers."""
        self._refuse_moving()
        _, z_bar, _, piece_bar, parameters = self._reading.pull_back(solved.read.rows, weights)
        rows = solved.read.rows[1:]
        passed = -_solved(self._constraints.jacobians(rows), z_bar, transposed=True)
        _, _, more_piece, more = self._constraints.residual.pull_back(rows, passed)
        slopes = numbers.zeros()
        slopes.parameters[:] = parameters + more
        np.add.at(
            slopes.pieces, stretch_of(self._times.at(numbers), numbers), piece_bar + more_piece
        )
        return slopes

    def push_forward(
        self, solved: SolvedColumns, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray:
        """Rates (d, T, columns) along d directions, the first axis of all ``dots``."""
        self._refuse_moving()
        rows, stretches = solved.read.rows[1:], stretch_of(self._times.at(numbers), numbers)
        jacobians = self._constraints.jacobians(rows)
        still = np.zeros((len(self.times), 0)), np.zeros((len(self.times), 1))
        found = []
        for pieces, parameters in zip(dots.pieces, dots.parameters, strict=True):
            given = [still[1], pieces[stretches], parameters]
            defect = self._constraints.residual.push_forward(rows, [np.zeros_like(rows[0]), *given])
            moved = -_solved(jacobians, defect, transposed=False)
            found.append(self._reading.push_forward(solved.read.rows, [still[0], moved, *given]))
        return np.array(found)

    def _refuse_moving(self) -> None:
        if self._problem.equations.states.count:
            raise NativeUnavailable(
                f"derivatives of a motion need steps in native code: {self._reason}"
            )


def _solved(jacobians: np.ndarray, right: np.ndarray, *, transposed: bool) -> np.ndarray:
    """Solutions (T, nz) for right sides (T, nz)."""
    if not right.size:
        return right
    given = jacobians.transpose(0, 2, 1) if transposed else jacobians
    try:
        return np.linalg.solve(given, right[:, :, None])[:, :, 0]
    except np.linalg.LinAlgError as error:
        raise SolveError(
            "the equilibria have no derivatives: their equations are singular at an output time",
            quantity="equilibrium",
            where="rod",
            time_s=0.0,
            remedy="Move the pressures or the loads a little.",
        ) from error
