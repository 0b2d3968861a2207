"""The solver of problems without states: a sequence of equilibria."""

from __future__ import annotations

from typing import ClassVar

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.formulas import Formulas
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.row_blocks import BLOCK_ROWS, whole_blocks
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.branch_following import PreviousSolution
from viscodesign.solve.equilibria_in_turn import EquilibriaInTurn
from viscodesign.solve.numerics.newton import CONTROL
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.solvers.quiet_stderr import quiet_stderr
from viscodesign.solve.statics import Start, consistent
from viscodesign.storage.cached_property import cached_property


class QuasiStatic(Solver):
    """Solves the algebraic equations at every output, starting from the solution before."""

    # Without a name, hence not in the catalogue: without states there is no choice.
    is_exact: ClassVar[bool] = True

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the constraints at edges first+1..stop."""
        # Pressures have one solution. A loaded rod may have several, and plain Newton would
        # jump from one to another where a fold ends its branch.
        if self.problem.equations.rod_form is RodForm.ARCS:
            found = self._at_once(here, first, stop)
            if found is not None:
                work.steps += stop - first
                return self._columns(found), None
        return self._along_branch(here, first, stop, work)

    def _at_once(self, here: Start, first: int, stop: int) -> np.ndarray | None:
        """All of them by plain Newton in one call (nz, m); None if it fails for any."""
        problem, count = self.problem, stop - first
        if not problem.equations.algebraics.count:
            return np.zeros((0, count))
        solve_block = problem.equations.compiled(_sequence)
        # The last edge is solved again and again up to the end of its block.
        intervals = np.minimum(np.arange(first, first + whole_blocks(count)), stop - 1)
        times, pieces = problem.schedule.edges[None, intervals + 1], problem.schedule.pieces
        numbers = np.tile(problem.numbers()[:, None], BLOCK_ROWS)
        start, parts = here.algebraics, []
        try:
            with quiet_stderr():
                for begin in range(0, count, BLOCK_ROWS):
                    block = slice(begin, begin + BLOCK_ROWS)
                    given = times[:, block], pieces[intervals[block]].T, numbers
                    parts.append(np.array(solve_block(start, *given)))
                    start = parts[-1][:, -1]
        except RuntimeError:
            return None
        found = np.concatenate(parts, axis=1)[:, :count]
        return found if np.isfinite(found).all() else None

    def _along_branch(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """The same with damped steps and loads raised gradually, as far as possible."""
        found: list[np.ndarray] = []
        failure: SolveError | None = None
        pieces = self.problem.schedule.pieces
        for begin, end in smooth_stretches(pieces, first, stop):
            failure = self._along_stretch(here, begin, end, found)
            if failure is not None:
                break
            here = Start(here.states, found[-1])
        work.steps += len(found)
        count = self.problem.equations.algebraics.count
        return self._columns(np.array(found).T.reshape(count, len(found))), failure

    def _along_stretch(
        self, here: Start, begin: int, end: int, found: list[np.ndarray]
    ) -> SolveError | None:
        """Add the solutions at edges begin+1..end of one smooth input, as far as possible."""
        schedule, previous = self.problem.schedule, None
        piece, edges, k = schedule.pieces[begin], schedule.edges, begin
        try:
            if begin and np.any(piece != schedule.pieces[begin - 1]):
                here = consistent(self.problem, here, float(edges[k]), piece, self.before(begin))
            while k < end:
                some = self._next(here, previous, piece, edges[k : end + 1])
                k += len(some)
                earlier = here.algebraics if len(some) == 1 else some[-2]
                previous, here = (earlier, float(edges[k - 1])), Start(here.states, some[-1])
                found += some
        except SolveError as error:
            return error
        return None

    def _next(
        self,
        here: Start,
        previous: PreviousSolution | None,
        piece: np.ndarray,
        times: np.ndarray,
    ) -> list[np.ndarray]:
        """Solutions behind the first of these times: as many as are found with ease, or one."""
        begin = float(times[0])
        if self._in_turn is not None:
            some = self._in_turn.after(here.algebraics, begin, previous, piece, times[1:])
            if len(some):
                return list(some)
        before = begin, piece
        there = consistent(self.problem, here, float(times[1]), piece, before, previous)
        return [there.algebraics]

    @cached_property
    def _in_turn(self) -> EquilibriaInTurn | None:
        """None without native code."""
        try:
            return EquilibriaInTurn(self.problem)
        except NativeUnavailable:
            return None

    def _columns(self, found: np.ndarray) -> Columns:
        count = found.shape[1]
        return np.zeros((0, count)), found, np.zeros((0, count))


def _sequence(equations: Formulas) -> ca.Function:
    """(start, times (1, m), pieces (p, m), numbers (n, m)) -> unknowns (nz, m) of a block."""
    given = ca.vertcat(equations.time, equations.pieces, equations.parameters)
    system = {"x": equations.algebraics.vector, "p": given, "g": equations.alg}
    options = {
        "abstol": CONTROL.correction_tol,
        "abstolStep": CONTROL.correction_tol,
        "max_iter": CONTROL.max_iterations,
    }
    finder = ca.rootfinder("constraints", "newton", system, options | {"error_on_fail": True})
    z, t = ca.MX.sym("z", equations.algebraics.count), ca.MX.sym("t")
    pieces = ca.MX.sym("pieces", equations.pieces.numel())
    numbers = ca.MX.sym("numbers", equations.parameters.numel())
    after = finder(z, ca.vertcat(t, pieces, numbers))
    step = ca.Function("step", [z, t, pieces, numbers], [after])
    return step.mapaccum("sequence", BLOCK_ROWS)
