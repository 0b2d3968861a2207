"""What is tried when a step fails, in order, until the run continues or is ended.

The solver first changes itself: it restarts with care, it takes a lower order and a
smaller tolerance (`Solver.remedies`). Then solvers of other authors and methods try. Each
attempt is for the one interval between two outputs that failed, from the state that was
reached; the first solver continues after it, unless it had failed before: then the one
that succeeded takes over.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.results.findings import RetryAttempt
from viscodesign.solve.branch_jumps import end_of_branch, has_branches, solve_on_branch
from viscodesign.solve.event_failures import EventError
from viscodesign.solve.event_location import until_event
from viscodesign.solve.events import EventWatch
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start

MAX_STEPS_TO_RECOVER = 5_000
"""Steps of another solver over one interval between two outputs: what is stuck is not slow, and a
section that is pressed to nothing takes ever smaller steps."""


class Fallbacks:
    """The solver of one run, and the attempts to replace it where it fails."""

    def __init__(self, solver: Solver, others: Sequence[type[Solver]]) -> None:
        self.solver = solver
        """The solver that continues."""
        self.attempts: list[RetryAttempt] = []
        self._others = others
        self._has_failed = False

    def advance(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, as far as a rod without inertia stays on its branch."""
        return _solved(self.solver, here, first, stop, work)

    def recover(
        self, here: Start, edge: int, work: Work, failure: SolveError
    ) -> tuple[Columns, SolveError | None]:
        """Solve the interval from ``edge`` in another way; the last failure where none succeeds."""
        time = float(self.solver.problem.schedule.edges[edge])
        reason = failure.short
        if self._others and has_branches(self.solver.problem) and failure.quantity == "motion":
            failure = end_of_branch(self.solver, here, edge, work) or failure
        piece = self.solver.problem.schedule.pieces[max(edge - 1, 0)]
        unknowns = np.concatenate([here.states, here.algebraics])
        failure = EventWatch(self.solver.problem).vanishing(time, piece, unknowns) or failure
        gone = failure.quantity == "equilibrium" or isinstance(failure, EventError)
        if gone or not self._others:
            return self.solver.nothing(), failure  # no solver finds what does not exist
        for tried, solver in self._remedies(work):
            columns, again = _solved(solver, here, edge, edge + 1, work)
            self.attempts.append(RetryAttempt(time, tried, again is None, reason))
            if again is None:
                if self._has_failed:
                    self.solver = self._unlimited(solver)
                self._has_failed = True
                return columns, None
            if again.quantity == "equilibrium" or isinstance(again, EventError):
                return columns, again
            reason = again.short
            is_motion = failure.quantity == "motion" and again.quantity != "work"
            failure = again if is_motion else failure
        return self.solver.nothing(), failure

    def _remedies(self, work: Work) -> Iterator[tuple[str, Solver]]:
        solver = self.solver
        yield from solver.remedies()
        allowed = min(solver.problem.max_steps, work.steps + MAX_STEPS_TO_RECOVER)
        problem = replace(solver.problem, max_steps=allowed)
        for kind in self._others:
            suits = kind.takes(problem) and kind.fits(problem)
            if suits and kind is not type(solver):
                tried = f"{kind.title.partition(':')[0]} instead"
                yield tried, kind(problem, solver.tolerance)

    def _unlimited(self, solver: Solver) -> Solver:
        """A solver that recovered the run, allowed all the steps that remain."""
        whole = self.solver.problem
        if solver.problem.max_steps == whole.max_steps:
            return solver
        return type(solver)(whole, solver.tolerance)


def _solved(
    solver: Solver, here: Start, first: int, stop: int, work: Work
) -> tuple[Columns, SolveError | None]:
    """A solver's solution, as far as a rod stays on its branch and no event ends the run."""
    columns, failure = solve_on_branch(solver, here, first, stop, work)
    columns, event = until_event(solver, here, first, columns, work)
    return columns, event or failure
