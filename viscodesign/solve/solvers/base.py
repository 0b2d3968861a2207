"""The contract of a solver: it integrates the scaled equations over intervals of a schedule."""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.references import LiteratureReference
from viscodesign.solve.problem import Pieces, Problem
from viscodesign.solve.statics import Instant, Start, consistent

Columns = tuple[np.ndarray, np.ndarray, np.ndarray]
"""States (nx, m), algebraic unknowns (nz, m) and integrals from the first edge (nq, m)."""

FINEST = 1e-3
"""Tolerance by which events are located, over that of the run."""
MIN_TOLERANCE = 1e-11


def _never() -> bool:
    return False


@dataclass
class Work:
    """Counts of work done, independent of any clock."""

    steps: int = 0
    residual_calls: int = 0
    jacobian_calls: int = 0
    compile_s: float = 0.0
    """Wall time of building integrators [s]."""
    native: bool = False
    """Whether any steps were taken in native code."""
    progress: Callable[[float], None] | None = None
    """Called with the time [s] after a step, by solvers whose steps are slow; may raise."""
    is_stopped: Callable[[], bool] = _never
    """Asked now and then: whether the user wants no more steps."""


class Solver(ABC):
    """A method of time integration. A new one is a new file in this folder.

    It restarts at every corner, where the coefficients of the inputs change: no step
    crosses one. It never raises for a failure on the way: it returns what it reached,
    with the failure.
    """

    name: ClassVar[str]
    """Its name in settings and tables."""
    title: ClassVar[str]
    """Method and author, in one line."""
    references: ClassVar[tuple[LiteratureReference, ...]] = ()
    """What to cite for it."""
    tip_error_per_tolerance: ClassVar[float]
    """Typical tip error in actuator lengths, over the tolerance."""
    is_exact: ClassVar[bool] = False
    """Whether its error is round-off, whatever the tolerance. It then comes before all others
    for the equations that it takes."""

    is_finest: bool = False
    """Whether it already has the tolerance by which events are located."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.tolerance = tolerance

    def finest(self, problem: Problem) -> Solver | None:
        """The same with a far smaller tolerance for a problem with other times, to locate events;
        None where that would find the same.
        """
        if self.is_exact or self.is_finest:
            return None
        solver = type(self)(problem, max(self.tolerance * FINEST, MIN_TOLERANCE))
        solver.is_finest = True
        return solver

    def unwatched(self, problem: Problem) -> Solver:
        """The same for a problem with other times, looking for no events."""
        return type(self)(problem, self.tolerance)

    @abstractmethod
    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as possible; columns exclude the start.

        ``here``: unknowns at edge ``first``, whose algebraic part may be out of date.
        """

    def consistent(
        self, here: Start, time: float, piece: np.ndarray, before: Instant | None = None
    ) -> Start:
        """The algebraic unknowns that belong to given states; see `statics.consistent`."""
        return consistent(self.problem, here, time, piece, before)

    def remedies(self) -> Iterator[tuple[str, Solver]]:
        """The same solver with ever more cautious settings, for an interval that it failed at."""
        yield "a hundredth of the tolerance", type(self)(self.problem, self.tolerance / 100)

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Whether it solves a problem of this size in reasonable time."""
        del problem
        return True

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Whether its method applies to equations of this structure."""
        del problem
        return True

    def before(self, edge: int) -> Instant:
        """The instant to which algebraic unknowns found at an edge belong: just before it."""
        schedule = self.problem.schedule
        return float(schedule.edges[edge]), schedule.pieces[max(edge - 1, 0)]

    def step_limit_reached(self, time: float) -> SolveError:
        """The failure of a run that has taken the most steps allowed."""
        return SolveError(
            f"the limit of {self.problem.max_steps} steps was reached at t = {time:.6g} s",
            quantity="work",
            where="integrator",
            time_s=float(time),
            remedy="Raise run.max_steps, shorten run.duration, or ask for less accuracy.",
        )

    def nothing(self) -> Columns:
        """Columns of no edge at all."""
        equations = self.problem.equations
        return (
            np.zeros((equations.states.count, 0)),
            np.zeros((equations.algebraics.count, 0)),
            np.zeros((equations.integrals, 0)),
        )

    def failure(self, reason: str, time: float) -> SolveError:
        """The failure of steps that came as far as ``time`` [s]."""
        return SolveError(
            f"time integration failed at t = {time:.6g} s: {reason}",
            quantity="motion",
            where="integrator",
            time_s=time,
            remedy="Check the last shapes; lower the pressure or the loads, or include inertia.",
        )


def smooth_stretches(pieces: Pieces, first: int, stop: int) -> list[tuple[int, int]]:
    """Consecutive intervals in first..stop with the same coefficients of the inputs."""
    new = np.any(pieces[first + 1 : stop] != pieces[first : stop - 1], axis=1)
    marks = [first, *(first + 1 + np.flatnonzero(new)).tolist(), stop]
    return list(itertools.pairwise(marks))
