"""A grid of settings, solved in order of expected cost until the time limit is reached.

A column of the grid is one model on one mesh with one solver; its rows are tolerances from
coarse to fine. A column ends where a finer tolerance no longer pays: the error is small enough
or that of the mesh. Meshes follow one another, so that a finer one has columns only for
models whose error the coarser mesh limits.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field

from viscodesign.errors import SolveError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.accuracy_points import Model, Point, tolerance_words
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, tip_difference
from viscodesign.solve.transient import solver_catalogue
from viscodesign.studies.reference import TRIAL_TOLERANCE, ReferenceMotion
from viscodesign.studies.timed_runs import EffectNames, OutOfTimeError, TimedRuns, Timing

TOLERANCES = tuple(float(f"{m}e-{k}") for k in range(2, 9) for m in (3, 1) if (m, k) != (3, 2))
"""From 1e-2 to 1e-8, two per decade."""


@dataclass(frozen=True)
class GridRules:
    """When a row of the grid is not worth its time."""

    meshes: int = 4
    """Meshes per model, each twice as fine as the one before."""
    small_error: float = 0.3
    """A column ends at this fraction of the smallest error of interest."""
    unmoved: float = 0.2
    """It also ends if a tolerance moves the tip by less than this fraction of its error."""
    mesh_gain: float = 0.7
    """A mesh that leaves more than this fraction of the coarser one's error is not refined."""
    mesh_limited: float = 4.0
    """A finer mesh begins at the tolerance with this multiple of the coarser one's error."""
    slow_points: int = 2
    """A column ends after so many points if all of them are far slower than others."""
    slow_factor: float = 10.0
    """How much slower, at no smaller error."""
    failures: int = 2
    """A column ends after so many failed solves in succession."""
    share_of_rest: float = 0.5
    """A row is skipped if it is expected to take more than this fraction of the time left."""
    patience: float = 10.0
    """A solve is given up after this multiple of its expected time, ..."""
    patience_s: float = 1.0
    """... but not before this time [s]."""
    edges_exponent: float = 1.6
    tolerance_exponent: float = 0.25
    """Expected cost grows as edges^1.6 and tolerance^-0.25 until a column is measured."""


RULES = GridRules()


@dataclass
class Column:
    """One model on one mesh with one solver, and its points so far."""

    model: Model
    edges: int
    solver: str
    first_tolerance: float
    points: list[Point] = field(default_factory=list)
    failures: int = 0
    closed: bool = False
    """Whether it was given up or skipped."""
    cost_ratio: float = 1.0
    """Measured over expected time of the last row."""
    last_run: Run | None = None
    tip_move_m: float = math.inf
    """Distance between the tips of the last two tolerances [m]."""

    def add(self, point: Point, run: Run) -> None:
        """Add the point of the next tolerance."""
        if self.last_run is not None:
            self.tip_move_m = tip_difference(self.last_run.motion, run.motion)
        self.points.append(point)
        self.last_run = run
        self.failures = 0

    def title(self, tolerance: float) -> str:
        """A row of it in words."""
        edges = f"{self.edges} edge{'s' * (self.edges != 1)} per section"
        return f"{self.model.title}; {self.solver}, {edges}, tolerance {tolerance_words(tolerance)}"


class AccuracyGrid:
    """Measures points of error and time."""

    def __init__(
        self, runs: TimedRuns, reference: ReferenceMotion, least_edges: int, smallest_rel: float
    ) -> None:
        self.runs = runs
        self.reference = reference
        self.least_edges = least_edges
        self.smallest_rel = smallest_rel
        """Smallest error of interest, in actuator lengths."""
        self.points: list[Point] = []
        self.notes: list[str] = []

    def measure(self, models: tuple[Model, ...]) -> None:
        """Measure the grid; raises `StudyInterruptedError` if the user asks to stop."""
        columns = [
            Column(model, self.least_edges, solver, TOLERANCES[0])
            for model in models
            for solver in solver_catalogue()
        ]
        for _ in range(RULES.meshes):
            rows = [(c, t) for c in columns for t in TOLERANCES if t <= c.first_tolerance]
            for column, tolerance in sorted(rows, key=lambda row: self._expected_s(*row)):
                if not self._has_ended(column):
                    self._measure_row(column, tolerance)
            columns = list(self._refined(columns))

    def measure_one(self, model: Model, settings: Settings) -> Point | None:
        """Measure a single setting."""
        column = Column(model, settings.edges_per_section, settings.solver, settings.tolerance)
        timing = self._timing(column, settings, self.runs.remaining_s)
        if timing is None:
            return None
        column.solver = timing.run.solution.solver
        return self._add(column, timing)

    # -- one row ------------------------------------------------------------------------------

    def _measure_row(self, column: Column, tolerance: float) -> None:
        formula_s = self._expected_s(column, tolerance)
        expected_s = column.cost_ratio * formula_s
        rest_s = RULES.share_of_rest * self.runs.remaining_s
        if expected_s > rest_s:
            column.closed = True
            row = column.title(tolerance)
            self.notes.append(
                f"skipped: time limit: {row} and below (expected to take {expected_s:.2g} s)"
            )
            return
        patience_s = max(RULES.patience_s, RULES.patience * expected_s)
        settings = Settings(column.edges, tolerance, column.solver)
        timing = self._timing(column, settings, min(rest_s, patience_s))
        if timing is not None and timing.run.solution.solver != column.solver:
            column.closed = True  # it does not take these equations
        elif timing is not None:
            column.cost_ratio = timing.wall_s / formula_s
            self._add(column, timing)

    def _timing(self, column: Column, settings: Settings, within_s: float) -> Timing | None:
        """The solution of a row, or None with a note on why there is none."""
        tolerance = settings.tolerance
        try:
            timing = self.runs.measure(_names(column.model), settings, within_s)
        except OutOfTimeError:
            column.closed = True
            self.notes.append(f"given up after {within_s:.2g} s: {column.title(tolerance)}")
            return None
        except ViscodesignError as error:
            failure = error
        else:
            if timing.run.motion.failure is None:
                return timing
            failure = timing.run.motion.failure
        column.failures += 1
        self.notes.append(f"no solution: {column.title(tolerance)}: {_reason(failure)}")
        return None

    def _add(self, column: Column, timing: Timing) -> Point:
        run = timing.run
        error, is_bound = self.reference.error(run)
        point = Point(
            model=column.model.name,
            edges=self.least_edges if run.is_exact_in_space else column.edges,
            tolerance=run.settings.tolerance,
            solver=column.solver,
            solve_s=timing.solve_s,
            build_s=timing.build_s,
            tip_error_m=error,
            tip_error_rel=error / self.runs.quantities.body.length,
            is_bound=is_bound,
            is_exact_in_space=run.is_exact_in_space,
            is_stepless=run.problem.equations.states.count == 0,
            steps=run.solution.work.steps,
        )
        column.add(point, run)
        if not self._is_known(point):
            self.points.append(point)
        return point

    def _is_known(self, point: Point) -> bool:
        """Whether a point without time steps is there already: solvers mean nothing to it."""
        return point.is_stepless and self._stepless_point(point.model, point.edges) is not None

    # -- which rows are worth their time ------------------------------------------------------

    def _expected_s(self, column: Column, tolerance: float) -> float:
        """Expected time of a row from the trial of its solver and the formula of costs [s]."""
        edges = (column.edges / self.least_edges) ** RULES.edges_exponent
        steps = (TRIAL_TOLERANCE / tolerance) ** RULES.tolerance_exponent
        return float(self.reference.trial_s(column.solver) * edges * steps)

    def _has_ended(self, column: Column) -> bool:
        if column.closed or column.failures >= RULES.failures:
            return True
        if self._stepless_point(column.model.name, column.edges) is not None:
            return True
        if not column.points:
            return False
        last = column.points[-1]
        is_saturated = column.tip_move_m <= RULES.unmoved * last.tip_error_m
        return is_saturated or self._is_small(last) or self._is_slow(column)

    def _stepless_point(self, model: str, edges: int) -> Point | None:
        known = (p for p in self.points if p.is_stepless and (p.model, p.edges) == (model, edges))
        return next(known, None)

    def _is_small(self, point: Point) -> bool:
        small = RULES.small_error * self.smallest_rel
        return point.is_bound or point.tip_error_rel <= small

    def _is_slow(self, column: Column) -> bool:
        is_judged = len(column.points) >= RULES.slow_points
        return is_judged and all(map(self._is_far_slower, column.points))

    def _is_far_slower(self, point: Point) -> bool:
        return any(
            other.tip_error_m <= point.tip_error_m
            and RULES.slow_factor * other.solve_s < point.solve_s
            for other in self.points
        )

    def _refined(self, columns: list[Column]) -> Iterator[Column]:
        """The columns of the next mesh: those whose error the present mesh limits."""
        for column in columns:
            tolerance = self._first_tolerance(column)
            if tolerance is not None:
                yield Column(column.model, 2 * column.edges, column.solver, tolerance)

    def _first_tolerance(self, column: Column) -> float | None:
        """Where a finer mesh of a column begins; None if it cannot help."""
        own = [p for p in self.points if p.model == column.model.name]
        if column.closed or (own and not column.points):
            return None
        if not own:
            return TOLERANCES[0]  # a finer mesh may have a solution
        here = self._mesh_error(own, column.edges)
        coarser = self._mesh_error(own, column.edges // 2)
        is_exact = any(p.is_exact_in_space or self._is_small(p) for p in column.points)
        if is_exact or here > RULES.mesh_gain * coarser or self._is_slow(column):
            return None
        limited = RULES.mesh_limited * here
        return next((p.tolerance for p in column.points if p.tip_error_rel <= limited), None)

    @staticmethod
    def _mesh_error(points: list[Point], edges: int) -> float:
        """Error that a mesh leaves, as far as it was measured, in actuator lengths."""
        return min((p.tip_error_rel for p in points if p.edges == edges), default=math.inf)


def _names(model: Model) -> EffectNames:
    return frozenset(model.effects)


def _reason(error: ViscodesignError) -> str:
    if isinstance(error, SolveError):
        return error.short.splitlines()[0]
    return str(error).splitlines()[0]
