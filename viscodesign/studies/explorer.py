"""Settings tried one after the other, those first that should cost least.

A branch is one model on one mesh with one solver; its tolerance is cut until its error
is small enough, or no longer falls. Then that error is the mesh's or the model's: a
finer mesh is tried, and where that does not help either, the model is left.
"""

from __future__ import annotations

import heapq
import itertools
import math
from dataclasses import dataclass, field, replace

from viscodesign.errors import SolveError, ViscodesignError
from viscodesign.results.accuracy_study import Model, Point, tolerance_words
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, tip_difference
from viscodesign.solve.transient import DEFAULT_SOLVER, solver_catalogue
from viscodesign.studies.bench import Bench, Names, OutOfTimeError, Timed
from viscodesign.studies.reference import Gauge

TOLERANCES = tuple(float(f"{m}e-{k}") for k in range(2, 9) for m in (3, 1) if (m, k) != (3, 2))
"""From 1e-2 to 1e-8, two a decade."""
MESHES = 4
"""How many meshes a model may have, each twice as fine as the one before."""
ENOUGH = 0.3
"""A branch ends at this part of the smallest error to be told."""
STANDS_STILL = 0.7
"""A finer mesh that leaves more than this part of the coarser one's error does not help."""
UNMOVED = 0.2
"""A tolerance that moves the tip by less than this part of its error is not what makes it."""
NEAR_THE_MESH = 1.3
"""Times the error that a mesh is known to leave, a tighter tolerance gains nothing."""
SEEN_BY_THE_MESH = 4.0
"""Times that error, a tolerance begins to show it: with it a finer mesh begins."""
TRIED, FAR_SLOWER = 2, 10.0
"""After so many points a branch ends where others were so many times faster throughout."""
FAILURES = 2
STEEPER, DENSER, OTHER = 1.6, 3.0, 3.0
"""What the next tolerance, the next mesh, or another solver may cost, in times of the last;
of a solver that was tried before it is known better."""
SHARE_OF_REST = 0.5
"""Part of the time left that one trial may take."""
PATIENCE = 10.0
"""Times what was predicted, a trial is cut off."""


@dataclass
class Branch:
    """One model on one mesh with one solver."""

    model: Model
    edges: int
    solver: str
    points: list[Point] = field(default_factory=list)
    failures: int = 0
    last: Run | None = None
    move_m: float = math.inf
    """How far the tip is from where the tolerance before had it [m]."""

    def add(self, point: Point, run: Run) -> None:
        """Take in the next tolerance's solution."""
        if self.last is not None:
            self.move_m = tip_difference(self.last.motion, run.motion)
        self.points.append(point)
        self.last = run
        self.failures = 0

    @property
    def stands_still(self) -> bool:
        """Whether the error is that of the mesh or the model."""
        return self.move_m <= UNMOVED * self.points[-1].tip_error_m

    @property
    def names(self) -> Names:
        """Its effects."""
        return frozenset(self.model.effects)

    @property
    def words(self) -> str:
        """What it is."""
        edges = f"{self.edges} edge{'s' * (self.edges != 1)} a section"
        return f"{self.model.title}; {self.solver}, {edges}"


@dataclass(order=True)
class Trial:
    """A setting to be tried; the cheapest one sorts first."""

    predicted_s: float
    order: int
    branch: Branch = field(compare=False)
    tolerance: float = field(compare=False)


class Explorer:
    """Points of error and time, gathered until every branch has ended or the time has."""

    def __init__(self, bench: Bench, gauge: Gauge, least_edges: int, smallest_rel: float) -> None:
        self.bench = bench
        self.gauge = gauge
        self.least_edges = least_edges
        self.smallest_rel = smallest_rel
        self.points: list[Point] = []
        self.notes: list[str] = []
        self._queue: list[Trial] = []
        self._order = itertools.count()
        self._floors: dict[tuple[str, int], float] = {}
        self._skipped: list[Trial] = []
        self._first_s: dict[str, float] = {}
        """Time that a model's first trial took."""
        self._dearer: dict[str, float] = {}
        """How many times that, other solvers have taken at most."""
        self._given_up: set[str] = set()
        """Solvers that were cut off once."""

    def explore(self, models: tuple[Model, ...]) -> None:
        """Try every model; raises `StudyInterruptedError` where the user asks to stop."""
        for model in models:
            first = Branch(model, self.least_edges, DEFAULT_SOLVER)
            self._push(first, TOLERANCES[0], self._guess_s(model))
        while self._queue:
            trial = heapq.heappop(self._queue)
            if (predicted_s := self._predicted(trial)) > trial.predicted_s:
                heapq.heappush(self._queue, replace(trial, predicted_s=predicted_s))
            elif trial.branch.solver in self._given_up:
                self._skipped.append(replace(trial, predicted_s=0.0))
            elif trial.predicted_s > SHARE_OF_REST * self.bench.remaining_s:
                self._skipped.append(trial)
            else:
                self._try(trial)

    def try_one(self, model: Model, settings: Settings) -> Point | None:
        """A single setting, which no branch follows."""
        branch = Branch(model, settings.edges_per_section, settings.solver)
        return self._measured(Trial(0.0, 0, branch, settings.tolerance))[0]

    def skipped_notes(self) -> list[str]:
        """What was not tried for want of time, one line for each branch."""
        return [
            f"not measured for want of time: {trial.branch.words}, tolerance "
            f"{tolerance_words(trial.tolerance)} and below{_about(trial.predicted_s)}"
            for trial in self._skipped
        ]

    def _guess_s(self, model: Model) -> float:
        """What the first trial of a model may take [s]."""
        # A moving rod without what the scene calls for may be shaken to nothing, slowly.
        known = {"auto", "everything"} & {model.name, *model.also}
        return 0.0 if known or not model.is_inertial else self.gauge.run.solve_s

    def _patience_s(self, trial: Trial) -> float:
        """When a trial is given up [s]."""
        rest_s = SHARE_OF_REST * self.bench.remaining_s
        if trial.branch.solver != DEFAULT_SOLVER:
            return rest_s / 2
        return min(rest_s, max(1.0, self.gauge.run.solve_s, PATIENCE * trial.predicted_s))

    def _predicted(self, trial: Trial) -> float:
        """What a trial should take [s], by what its solver took elsewhere."""
        branch = trial.branch
        if branch.points or branch.solver not in self._dearer:
            return trial.predicted_s
        known = self._dearer[branch.solver] * self._first_s[branch.model.name]
        return max(trial.predicted_s, known)

    # -- one trial ------------------------------------------------------------

    def _push(self, branch: Branch, tolerance: float, predicted_s: float) -> None:
        heapq.heappush(self._queue, Trial(predicted_s, next(self._order), branch, tolerance))

    def _try(self, trial: Trial) -> None:
        branch = trial.branch
        point, wall_s = self._measured(trial)
        if math.isinf(wall_s):
            return
        if point is None:
            branch.failures += 1
        if branch.edges == self.least_edges and trial.tolerance == TOLERANCES[0]:
            self._learn(branch, wall_s)
            self._try_other_solvers(branch, wall_s)
        tolerance = self._next_tolerance(trial)
        if tolerance is not None:
            self._push(branch, tolerance, STEEPER * wall_s)
        else:
            self._end(branch, wall_s)

    def _measured(self, trial: Trial) -> tuple[Point | None, float]:
        """The point, if there is one, and the time that it took to measure."""
        branch = trial.branch
        settings = Settings(branch.edges, trial.tolerance, branch.solver)
        began = self.bench.spent_s
        try:
            within_s = self._patience_s(trial)
            timed = self.bench.measure(branch.names, settings, within_s)
        except OutOfTimeError:
            words, tolerance = branch.words, tolerance_words(trial.tolerance)
            self.notes.append(f"given up after {within_s:.2g} s: {words}, tolerance {tolerance}")
            if branch.solver != DEFAULT_SOLVER:
                self._given_up.add(branch.solver)
            return None, math.inf
        except ViscodesignError as error:
            self._note(trial, error)
            return None, self.bench.spent_s - began
        if timed.run.motion.failure is not None:
            self._note(trial, timed.run.motion.failure)
            return None, timed.wall_s
        point = self._point(branch, timed)
        branch.add(point, timed.run)
        if not (point.is_stepless and any(_is_same(point, other) for other in self.points)):
            self.points.append(point)
        return point, timed.wall_s

    def _note(self, trial: Trial, error: ViscodesignError) -> None:
        reason = str(error).splitlines()[0]
        if isinstance(error, SolveError):
            reason = reason.removesuffix(error.remedy).rstrip(". ")
        tolerance = tolerance_words(trial.tolerance)
        self.notes.append(f"no solution: {trial.branch.words}, tolerance {tolerance}: {reason}")

    def _point(self, branch: Branch, timed: Timed) -> Point:
        error, is_bound = self.gauge.error(timed.run)
        return Point(
            model=branch.model.name,
            edges=self.least_edges if timed.run.is_exact_in_space else branch.edges,
            tolerance=timed.run.settings.tolerance,
            solver=branch.solver,
            solve_s=timed.solve_s,
            build_s=timed.build_s,
            tip_error_m=error,
            tip_error_rel=error / self.bench.quantities.body.length,
            is_bound=is_bound,
            is_exact_in_space=timed.run.is_exact_in_space,
            is_stepless=timed.run.problem.equations.states.count == 0,
            steps=timed.run.solution.work.steps,
        )

    # -- what comes next ------------------------------------------------------

    def _learn(self, branch: Branch, wall_s: float) -> None:
        """Remember what a solver takes in times of the first one."""
        name, solver = branch.model.name, branch.solver
        first = self._first_s.setdefault(name, wall_s)
        if solver != DEFAULT_SOLVER:
            self._dearer[solver] = max(wall_s / first, self._dearer.get(solver, 0.0))

    def _try_other_solvers(self, branch: Branch, wall_s: float) -> None:
        """After the first solver's first trial, that of every other one."""
        if branch.solver != DEFAULT_SOLVER or any(p.is_stepless for p in branch.points):
            return
        for solver in solver_catalogue():
            if solver != DEFAULT_SOLVER:
                other = Branch(branch.model, branch.edges, solver)
                self._push(other, TOLERANCES[0], OTHER * wall_s)

    def _next_tolerance(self, trial: Trial) -> float | None:
        """The next one of a branch that goes on."""
        branch = trial.branch
        finer = [tolerance for tolerance in TOLERANCES if tolerance < trial.tolerance]
        if not finer or branch.failures >= FAILURES:
            return None
        if branch.points and self._has_ended(branch):
            return None
        return finer[0]

    def _has_ended(self, branch: Branch) -> bool:
        last = branch.points[-1]
        floor = self._floors.get((branch.model.name, branch.edges), 0.0)
        return (
            last.is_stepless
            or self._is_fine(last)
            or last.tip_error_rel <= NEAR_THE_MESH * floor
            or branch.stands_still
            or self._is_slow(branch)
        )

    def _is_fine(self, point: Point) -> bool:
        return point.is_bound or point.tip_error_rel <= ENOUGH * self.smallest_rel

    def _is_slow(self, branch: Branch) -> bool:
        return len(branch.points) >= TRIED and all(map(self._is_far_behind, branch.points))

    def _is_far_behind(self, point: Point) -> bool:
        return any(
            other.tip_error_m <= point.tip_error_m and FAR_SLOWER * other.solve_s < point.solve_s
            for other in self.points
        )

    def _end(self, branch: Branch, wall_s: float) -> None:
        """Learn what the mesh leaves; go to a finer one where that can help."""
        key = (branch.model.name, branch.edges)
        if not branch.points:
            # What another solver can do on this mesh is no matter of the mesh.
            if not any(point.model == branch.model.name for point in self.points):
                self._refine(branch, TOLERANCES[0], wall_s)
            return
        if self._is_slow(branch):
            return
        last = branch.points[-1]
        floor = min(point.tip_error_rel for point in branch.points)
        self._floors[key] = min(floor, self._floors.get(key, math.inf))
        coarser = self._floors.get((branch.model.name, branch.edges // 2), math.inf)
        if last.is_exact_in_space or self._is_fine(last) or floor > STANDS_STILL * coarser:
            return
        shown = [p for p in branch.points if p.tip_error_rel <= SEEN_BY_THE_MESH * floor]
        self._refine(branch, shown[0].tolerance, wall_s)

    def _refine(self, branch: Branch, tolerance: float, wall_s: float) -> None:
        edges = 2 * branch.edges
        if edges > self.least_edges * 2 ** (MESHES - 1) or math.isinf(wall_s):
            return
        finer = Branch(branch.model, edges, branch.solver)
        self._push(finer, tolerance, DENSER * wall_s)


def _is_same(point: Point, other: Point) -> bool:
    """Whether two points without steps through time are one."""
    return other.is_stepless and (point.model, point.edges) == (other.model, other.edges)


def _about(predicted_s: float) -> str:
    return f" (the next would take about {predicted_s:.2g} s)" if predicted_s > 0.0 else ""
