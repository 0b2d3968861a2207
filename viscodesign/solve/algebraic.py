"""The march of a problem without states."""

from __future__ import annotations

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start, consistent


class Algebraic(Solver):
    """Every output is a solution of its own."""

    # Not named, hence not among those to choose from: without states there is no choice.

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the constraints at edges first+1..stop, each from the one before."""
        schedule = self.problem.schedule
        found: list[np.ndarray] = []
        failure: SolveError | None = None
        for k in range(first, stop):
            try:
                here = consistent(self.problem, here, schedule.edges[k + 1], schedule.pieces[k])
            except SolveError as error:
                failure = error
                break
            found.append(here.algebraics)
            work.steps += 1
        columns = np.array(found).T.reshape(self.problem.equations.algebraics.count, len(found))
        return (np.zeros((0, len(found))), columns, np.zeros((0, len(found)))), failure
