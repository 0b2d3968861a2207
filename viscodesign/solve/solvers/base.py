"""What a solver is: it follows the scaled equations over intervals of a schedule."""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.solve.problem import Pieces, Problem
from viscodesign.solve.statics import Instant, Start

Columns = tuple[np.ndarray, np.ndarray, np.ndarray]
"""States (nx, m), algebraic unknowns (nz, m) and integrals since the start (nq, m) at m edges."""


@dataclass
class Work:
    """Counts of work done, which no clock disturbs."""

    steps: int = 0
    residual_calls: int = 0
    jacobian_calls: int = 0
    compile_s: float = 0.0
    """Wall time spent on making integrators, which is building, not solving [s]."""


class Solver(ABC):
    """One way through time. A new one is a new file in this folder.

    It restarts at every corner, where the coefficients of the inputs change: no step
    ever passes over one. It never raises for a failure on the way: it returns what it
    reached, with the failure.
    """

    name: ClassVar[str]
    """Its word in settings and tables."""
    title: ClassVar[str]
    """What it is, in one line."""
    tip_error_per_tolerance: ClassVar[float]
    """Tip error in actuator lengths that a tolerance commonly leaves, over the tolerance."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.tolerance = tolerance

    @abstractmethod
    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as can be; columns exclude the start.

        ``here``: unknowns at edge ``first``, whose algebraic part may be stale.
        """

    def remedies(self) -> Iterator[tuple[str, Solver]]:
        """The same solver, changed more and more, for an interval that it could not solve."""
        yield "a hundredth of the tolerance", type(self)(self.problem, self.tolerance / 100)

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Whether a problem is of a size that it solves in reasonable time."""
        del problem
        return True

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Whether its method is for equations of this structure at all."""
        del problem
        return True

    def before(self, edge: int) -> Instant:
        """When algebraic unknowns that were found at an edge held: just before it."""
        schedule = self.problem.schedule
        return float(schedule.edges[edge]), schedule.pieces[max(edge - 1, 0)]

    def overworked(self, time: float) -> SolveError:
        """The failure of a run that has taken as many steps as it may."""
        return SolveError(
            f"the limit of {self.problem.most_steps} steps was reached at t = {time:.6g} s",
            quantity="work",
            where="integrator",
            time_s=float(time),
            remedy="Raise run.max_steps, shorten run.duration, or ask for less accuracy.",
        )

    def nothing(self) -> Columns:
        """No column at all."""
        equations = self.problem.equations
        return (
            np.zeros((equations.states.count, 0)),
            np.zeros((equations.algebraics.count, 0)),
            np.zeros((equations.quadrature.numel(), 0)),
        )

    def failure(self, reason: str, edge: int) -> SolveError:
        """The failure of an interval that begins at an edge."""
        time = float(self.problem.schedule.edges[edge])
        return SolveError(
            f"the motion cannot be followed past t = {time:.6g} s: {reason}",
            quantity="motion",
            where="integrator",
            time_s=time,
            remedy="Look at the last shapes; lower the pressure or the loads, or take inertia in.",
        )


def smooth_stretches(pieces: Pieces, first: int, stop: int) -> list[tuple[int, int]]:
    """Runs of intervals in first..stop that share their inputs' coefficients."""
    new = np.any(pieces[first + 1 : stop] != pieces[first : stop - 1], axis=1)
    marks = [first, *(first + 1 + np.flatnonzero(new)).tolist(), stop]
    return list(itertools.pairwise(marks))
