"""Steps through time for a rod that touches a rigid surface.

They are as long as their error allows, and short where a contact changes.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.references import LiteratureReference
from viscodesign.solve.contact_euler import ContactEuler, ContactPose, StepError
from viscodesign.solve.contact_extrapolation import EXTRAPOLATION, StepAttempt, StepNorm, Way
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Instant, Start


@dataclass(frozen=True)
class ContactControl:
    """Numbers that steer the steps."""

    first_share: float = 1 / 16
    """First step of a way, relative to its length."""
    safety: float = 0.8
    max_growth: float = 3.0
    careful_growth: float = 1.5
    """Where a contact is about to change, or seems to be."""
    min_growth: float = 0.1
    min_share: float = 1e-11
    """Shortest step, relative to the whole run."""


CONTROL = ContactControl()


@dataclass
class _Pace:
    """What steps so far tell of the next."""

    step: float
    is_settled: bool = False
    """Whether contacts went on as they were in the last step, so that the next may be smooth."""
    is_blocked: bool = False
    """Whether a contact is about to change, so that steps should hardly grow."""


class ContactSteps(Solver):
    """Extrapolated implicit Euler steps with complementarity in positions."""

    name: ClassVar[str] = "contact_steps"
    title: ClassVar[str] = "Implicit steps with contact: Moreau, extrapolated where smooth"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "acary2008",
            "book",
            {
                "author": "Acary, Vincent and Brogliato, Bernard",
                "title": "Numerical Methods for Nonsmooth Dynamical Systems",
                "series": "Lecture Notes in Applied and Computational Mechanics",
                "volume": "35",
                "publisher": "Springer",
                "year": "2008",
                "doi": "10.1007/978-3-540-75392-6",
            },
        ),
    )
    tip_error_per_tolerance: ClassVar[float] = 30.0

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        self.euler = ContactEuler(problem)
        self._norm = StepNorm(problem, tolerance)
        self._last: tuple[np.ndarray, ContactPose, _Pace] | None = None
        self._work = Work()

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Only rods that may touch something need it."""
        return bool(problem.equations.contacts)

    def consistent(
        self, here: Start, time: float, piece: np.ndarray, before: Instant | None = None
    ) -> Start:
        """The algebraic unknowns that belong to given states, with the forces of contact held.

        A massless rod is led there, since it may meet something on the way. Raises `SolveError`
        where a run would start inside what it may touch.
        """
        is_massless = self.problem.equations.rod_form is RodForm.STATIC
        if not is_massless:
            here = super().consistent(here, time, piece, before)
        if before is None:
            self._refuse_inside(here, (time, piece))
        if not is_massless:
            return here
        origin = self.problem.schedule.initial_piece if before is None else before[1]
        if before is not None and np.array_equal(origin, piece):
            return here
        pose = self.euler.pose(here, (time, origin))
        way = Way(lambda s: (time, origin + s * (piece - origin)), 0.0, 1.0, 0.0)
        return self.euler.start(self._follow(pose, way, _Pace(1.0)))

    def _refuse_inside(self, here: Start, at: Instant) -> None:
        gaps = self.euler.pose(here, at).gaps
        if gaps.min() < -EXTRAPOLATION.penetration_m:
            point = self.problem.equations.contacts[int(np.argmin(gaps))]
            raise SolveError(
                f"at its start the actuator's {point.replace('_', ' ')} would be "
                f"{-1e3 * gaps.min():.3g} mm inside the ground",
                quantity="equilibrium",
                where=point,
                time_s=at[0],
                remedy="Let the run start at rest (run.start: rest), or move the ground away from "
                "where the loads and the gauge pressure take the actuator.",
            )

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as possible."""
        self._work = work
        schedule, found = self.problem.schedule, []
        failure: SolveError | None = None
        pose, pace = self._resumed(here, first)
        for k in range(first, stop):
            begin, end = float(schedule.edges[k]), float(schedule.edges[k + 1])
            piece = schedule.pieces[k]
            try:
                if k and np.any(piece != schedule.pieces[k - 1]):
                    pose = self._turned(pose, k)
                    pace = _Pace(CONTROL.first_share * (end - begin))
                way = Way(partial(_at, piece), begin, end, 1.0)
                pose = self._follow(pose, way, pace)
            except SolveError as error:
                failure = error
                break
            found.append(pose)
            self._last = self.euler.start(pose).states, pose, pace
            if work.is_stopped():
                break
        return self._columns(found), failure

    def _resumed(self, here: Start, first: int) -> tuple[ContactPose, _Pace]:
        """The pose and pace at a start: those of before, where it goes on from there."""
        schedule = self.problem.schedule
        none = np.zeros(self.problem.equations.integrals)
        if self._last is not None and np.array_equal(self._last[0], here.states):
            _, pose, pace = self._last
            return replace(pose, integrals=none), pace
        at = float(schedule.edges[first]), schedule.pieces[first]
        step = CONTROL.first_share * float(schedule.edges[first + 1] - schedule.edges[first])
        return self.euler.pose(here, at), _Pace(step)

    def _turned(self, pose: ContactPose, edge: int) -> ContactPose:
        """The pose at a corner of an input, with the pressures behind it."""
        schedule = self.problem.schedule
        time, piece = float(schedule.edges[edge]), schedule.pieces[edge]
        here = self.consistent(self.euler.start(pose), time, piece, self.before(edge))
        return replace(self.euler.pose(here, (time, piece)), integrals=pose.integrals)

    def _columns(self, found: list[ContactPose]) -> Columns:
        if not found:
            return self.nothing()
        starts = [self.euler.start(pose) for pose in found]
        return (
            np.array([start.states for start in starts]).T,
            np.array([start.algebraics for start in starts]).T,
            np.array([pose.integrals for pose in found]).T.reshape(-1, len(found)),
        )

    # -- steps ----------------------------------------------------------------

    def _follow(self, pose: ContactPose, way: Way, pace: _Pace) -> ContactPose:
        """The pose at the end of a way; raises `SolveError` where steps become too short."""
        least = CONTROL.min_share * max(way.end, float(self.problem.schedule.edges[-1]))
        here = way.begin
        while way.end - here > least:
            if self._work.steps > self.problem.max_steps:
                raise self.step_limit_reached(way.at(here)[0])
            parts = np.ceil((way.end - here) / pace.step * (1 - 1e-9))
            step = (way.end - here) / max(parts, 1.0)
            attempt = StepAttempt(self.euler, self._norm, pose, way, here, step)
            found, error, order = _best(attempt, pace)
            self._work.steps += 1
            self._work.residual_calls, self.euler.calls = (
                self._work.residual_calls + self.euler.calls,
                0,
            )
            growth = CONTROL.safety * (self.tolerance / max(error, 1e-30)) ** (1 / order)
            if found is not None and error <= self.tolerance:
                pace.is_settled = bool(np.array_equal(found.touching, pose.touching))
                pace.is_blocked &= pace.is_settled
                most = CONTROL.careful_growth if pace.is_blocked else CONTROL.max_growth
                pace.step = step * min(max(growth, CONTROL.min_growth), most)
                pose, here = found, here + step
                continue
            pace.step = step * min(max(growth, CONTROL.min_growth), 0.5)
            if pace.step < least:
                raise self.failure(
                    "steps in which the forces of contact are found became too short",
                    way.at(here)[0],
                )
        return pose


def _best(attempt: StepAttempt, pace: _Pace) -> tuple[ContactPose | None, float, int]:
    """The pose, its error and the order by which that falls; none where no step succeeds."""
    try:
        if pace.is_settled:
            found = attempt.extrapolated()
            if found is not None:
                return found
            pace.is_blocked = True
        return attempt.halved()
    except StepError:
        return None, np.inf, 1


def _at(piece: np.ndarray, time: float) -> Instant:
    return time, piece
