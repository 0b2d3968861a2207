"""The solver of problems without states: a sequence of equilibria."""

from __future__ import annotations

from typing import ClassVar

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.formulas import Formulas
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.row_blocks import BLOCK_ROWS, whole_blocks
from viscodesign.solve.branch_following import OperatingPoint, PreviousSolution
from viscodesign.solve.equilibria_between import equilibria_between
from viscodesign.solve.numerics.newton import CONTROL
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.solvers.quiet_stderr import quiet_stderr
from viscodesign.solve.statics import Start, consistent

LONGEST_STRIDE = 16
"""Edges of a smooth input that are solved at once, between two that follow each other."""


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
        schedule, previous, stride = self.problem.schedule, None, LONGEST_STRIDE
        piece, k = schedule.pieces[begin], begin
        try:
            if begin and np.any(piece != schedule.pieces[begin - 1]):
                at = float(schedule.edges[begin])
                here = consistent(self.problem, here, at, piece, self.before(begin))
            while k < end:
                stride = min(stride, end - k)
                some = self._stride(here, previous, k, stride)
                if some is None:
                    stride //= 2
                    continue
                earlier = here.algebraics if stride == 1 else some[-2]
                before = schedule.edges[k] if stride == 1 else schedule.edges[k + stride - 1]
                previous, here = (earlier, float(before)), Start(here.states, some[-1])
                found += some
                k, stride = k + stride, min(2 * stride, LONGEST_STRIDE)
        except SolveError as error:
            return error
        return None

    def _stride(
        self, here: Start, previous: PreviousSolution | None, k: int, stride: int
    ) -> list[np.ndarray] | None:
        """Solutions at the next edges: the last, then all before it; None where that fails."""
        schedule = self.problem.schedule
        piece, edges = schedule.pieces[k], schedule.edges[k : k + stride + 1]
        instant = float(edges[0]), piece
        try:
            there = consistent(self.problem, here, float(edges[-1]), piece, instant, previous)
        except SolveError:
            if stride == 1:
                raise
            return None
        if stride == 1:
            return [there.algebraics]
        before, after = (OperatingPoint(here.states, float(t), piece) for t in edges[[0, -1]])
        ends = here.algebraics, there.algebraics
        between = equilibria_between(self.problem, ends, before, after, edges[1:-1])
        return None if between is None else [*between, there.algebraics]

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
