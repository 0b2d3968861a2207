"""What both ways to take the steps of Rodas5P share: one stretch of smooth input, its control."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.events import Crossing, EventWatch
from viscodesign.solve.problem import Problem, Schedule
from viscodesign.solve.progress_watch import ProgressWatch
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.statics import Start


@dataclass(frozen=True)
class StepControl:
    """Numbers that steer the step size."""

    first_step: float = 1e-3
    """In time scales of the rod."""
    min_step: float = 1e-14
    """In durations of the run; below it, the run ends."""
    safety: float = 0.9
    max_factor: float = 5.0
    min_factor: float = 0.2
    """Largest and smallest ratio of a step to the one before."""
    min_steps_per_stretch: int = 50
    """Steps that a stretch of smooth input takes at least, if its swings are short."""
    min_steps_per_line: int = 10
    """The same where inputs are straight lines within a stretch: no step misses a swing then. With
    so few, everything on, errors were those of a sine's steps at the same tolerance."""
    memory: float = 0.08
    """Exponent of the last error in the next step (a PI controller)."""
    steps_at_once: int = 256
    """Steps between two looks for events and for a request to stop."""
    numbers_at_once: int = 100_000
    """Unknowns times steps of that many, at most."""
    max_unknowns: int = 1_000
    """Up to which a whole step is written out as formulas."""


CONTROL = StepControl()


def first_step(motion_time: float, stretch: float) -> float:
    """The first step of a run [s], by the rod's time scale and the length of the stretch [s]."""
    return CONTROL.first_step * min(motion_time, stretch)


def largest_step(swing_time: float, stretch: float, *, is_line: bool) -> float:
    """The largest step within a stretch [s]; see `StretchSteps.largest_size`."""
    fewest = CONTROL.min_steps_per_line if is_line else CONTROL.min_steps_per_stretch
    return max(swing_time, stretch / fewest)


@dataclass
class Reached:
    """What steps over a stretch found."""

    columns: np.ndarray
    """(m, n): states, algebraic unknowns and integrals at the m edges that were reached."""
    size: float | None
    """First step that suits what follows [s]; None where the stretch was not finished."""
    failure: str | None = None
    """Why it was not; empty where the steps allowed were taken."""
    time: float = 0.0
    """How far the steps came [s]."""
    crossing: Crossing | None = None
    """The event that ended them."""
    cause: SolveError | None = None
    """What the steps came to a stop at, where that is known."""


class StretchSteps(ABC):
    """Steps over stretches of smooth input."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        self.tolerance = tolerance
        self.watch: EventWatch | None = EventWatch(problem)
        """None where a search for events has been narrowed to where they are known to be."""

    @abstractmethod
    def __call__(
        self,
        schedule: Schedule,
        y: np.ndarray,
        begin: int,
        end: int,
        size: float | None,
        work: Work,
    ) -> Reached:
        """From unknowns and integrals ``y`` (n,) at edge ``begin`` over all edges to ``end``.

        ``size``: of the first step [s]; None at the start of a run.
        """

    def corrected(self, here: Start, time: float, piece: np.ndarray) -> Start | None:
        """The algebraic unknowns that belong to given states, where full steps of Newton's lead
        there at once.
        """
        del here, time, piece
        return None

    def first_size(self, size: float | None, stretch: float) -> float:
        """The first step of a stretch [s]."""
        if size is not None:
            return min(size, stretch)
        return first_step(self.problem.equations.motion_time, stretch)

    def largest_size(self, stretch: float) -> float:
        """The largest step within a stretch [s].

        No step is longer than a swing of the input, however smooth all was before; a swing far
        shorter than the stretch has corners of its own.
        """
        swing_time, is_line = self.problem.equations.swing_time, self.problem.has_straight_inputs
        return largest_step(swing_time, stretch, is_line=is_line)

    @property
    def steps_at_once(self) -> int:
        """Steps between two looks for events."""
        few = CONTROL.numbers_at_once // max(self.problem.unknowns, 1)
        return max(1, min(CONTROL.steps_at_once, few))

    def progress_watch(self, begin: float) -> ProgressWatch:
        """For steps from a time [s] on."""
        problem = self.problem
        return ProgressWatch(begin, float(problem.schedule.edges[-1]), problem.max_steps)

    def powers(self) -> np.ndarray:
        """Powers of the step by which errors of unknowns count (n,); infinite: not at all."""
        equations = self.problem.equations
        found = np.zeros(self.problem.unknowns)
        for group, first in ((equations.states, 0), (equations.algebraics, equations.states.count)):
            for block in group.blocks.values():
                own = slice(first + block.span.start, first + block.span.stop)
                found[own] = block.traits.integrations
        return found
