"""Timed solutions of one scene, within the time limit of a study."""

from __future__ import annotations

import time as clock

from viscodesign.effects.select import Selection
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Progress, Run, Workspace, solve

REPEAT_TIME_S = 0.1
"""A solve is repeated while all its repeats together took less [s]."""
MAX_REPEATS = 5
EffectNames = frozenset[str]


class StudyInterruptedError(Exception):
    """The user asked to stop the study."""


class OutOfTimeError(Exception):
    """A solve exceeded the time that it was given."""


@dataclass(frozen=True)
class Timing:
    """A solution and what it costs."""

    run: Run
    solve_s: float
    """Shortest of the repeats [s]."""
    build_s: float
    """Building equations and integrator for the first time [s]."""
    wall_s: float
    """Everything, repeats included [s]."""


class TimedRuns:
    """Solves one scene with any effects and settings until the time limit is reached.

    A solve is abandoned between two chunks of time steps, in its progress callback; nothing
    interrupts a numerical routine.
    """

    def __init__(
        self,
        quantities: SceneQuantities,
        selection: Selection,
        limit_s: float,
        stop: StopRequest,
        progress: Progress | None = None,
    ) -> None:
        self.quantities = quantities
        self.selection = selection
        self.limit_s = limit_s
        self._stop = stop
        self._progress = progress
        self._workspace = Workspace()
        self._began = clock.perf_counter()
        self._until_s = limit_s
        self._equations_s: dict[tuple[EffectNames, int], float] = {}
        self._integrator_s: dict[tuple[EffectNames, int, str], float] = {}

    @property
    def spent_s(self) -> float:
        """Wall time since the study began [s]."""
        return clock.perf_counter() - self._began

    @property
    def remaining_s(self) -> float:
        """Wall time left for the study [s]."""
        return self.limit_s - self.spent_s

    def run(self, names: EffectNames, settings: Settings, within_s: float) -> Run:
        """Solve once.

        Raises `OutOfTimeError` if it takes longer than ``within_s``, `StudyInterruptedError` if
        the user asked to stop, and a `ViscodesignError` if there is no solution.
        """
        self._until_s = self.spent_s + within_s
        self._check()
        effects, edges = self.selection.members(names), settings.edges_per_section
        began = clock.perf_counter()
        self._workspace.problems.problem(self.quantities, effects, settings)
        self._equations_s.setdefault((names, edges), clock.perf_counter() - began)
        found = solve(self.quantities, effects, settings, self._check, self._workspace)
        if found.solution.interrupted or self._stop.asked:
            raise StudyInterruptedError
        key, made_s = (names, edges, settings.solver), found.solution.work.compile_s
        self._integrator_s[key] = max(made_s, self._integrator_s.get(key, 0.0))
        return found

    def measure(self, names: EffectNames, settings: Settings, within_s: float) -> Timing:
        """Solve as often as a fair measurement of the time needs."""
        began = self.spent_s
        best = run = self.run(names, settings, within_s)
        total, repeats = run.solve_s, 1
        while run.is_complete and total < REPEAT_TIME_S and repeats < MAX_REPEATS:
            run = self.run(names, settings, within_s)
            total, repeats = total + run.solve_s, repeats + 1
            best = min(best, run, key=lambda one: one.solve_s)
        edges, solver = settings.edges_per_section, settings.solver
        build_s = self._equations_s[names, edges] + self._integrator_s[names, edges, solver]
        return Timing(best, best.solve_s, build_s, self.spent_s - began)

    def _check(self, fraction: float = 0.0) -> None:
        """Called before a solve, and between its chunks or slow steps with the fraction done."""
        del fraction
        if self._progress is not None:
            self._progress(min(self.spent_s / self.limit_s, 1.0))
        if self._stop.asked:
            raise StudyInterruptedError
        if self.spent_s >= self._until_s:
            raise OutOfTimeError
