"""What is tried when a step fails, in order, until the motion goes on or is refused.

Every solver first changes itself: it starts afresh with care, it takes a lower order
and a smaller tolerance (`Solver.remedies`). Then solvers of other authors and methods
try. Each attempt is for the one interval between two outputs that failed, from the
state that was reached; the solver of before goes on behind it, unless it failed there
already: then the one that helped stays.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from viscodesign.errors import SolveError
from viscodesign.results.findings import RetryAttempt
from viscodesign.solve.branch_jumps import end_of_branch, has_branches, watched
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start


class Ladder:
    """The attempts of one run."""

    def __init__(self, march: Solver, others: Sequence[type[Solver]]) -> None:
        self.march = march
        """The solver that goes on."""
        self.rungs: list[RetryAttempt] = []
        self._others = others
        self._helped = False

    def go(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, as far as a rod without inertia keeps to its branch."""
        return watched(self.march, here, first, stop, work)

    def climb(
        self, here: Start, edge: int, work: Work, failure: SolveError
    ) -> tuple[Columns, SolveError | None]:
        """Solve the interval from ``edge`` in some other way; the last failure where none is."""
        time = float(self.march.problem.schedule.edges[edge])
        reason = failure.short
        if self._others and has_branches(self.march.problem) and failure.quantity == "motion":
            failure = end_of_branch(self.march, here, edge, work) or failure
        if not self._others or failure.quantity == "equilibrium":
            return self.march.nothing(), failure  # no way of solving finds what is not there
        for tried, solver in self._attempts():
            columns, again = watched(solver, here, edge, edge + 1, work)
            self.rungs.append(RetryAttempt(time, tried, again is None, reason))
            if again is None:
                if self._helped:
                    self.march = solver
                self._helped = True
                return columns, None
            if again.quantity == "equilibrium":
                return self.march.nothing(), again
            reason = again.short
            failure = again if failure.quantity == "motion" else failure
        return self.march.nothing(), failure

    def _attempts(self) -> Iterator[tuple[str, Solver]]:
        march = self.march
        yield from march.remedies()
        for kind in self._others:
            suits = kind.takes(march.problem) and kind.fits(march.problem)
            if suits and kind is not type(march):
                tried = f"{kind.title.partition(':')[0]} instead"
                yield tried, kind(march.problem, march.tolerance)
