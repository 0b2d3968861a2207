"""One solution of a scene at one setting."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Sequence
from dataclasses import field, replace

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.effects.effects_key import effects_key
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.motion import Motion, read_motion
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import Settings, build, cycle_schedule
from viscodesign.solve.limit_cycle import limit_cycle
from viscodesign.solve.problem import Problem, Schedule
from viscodesign.solve.statics import Start, equilibrium, rest
from viscodesign.solve.transient import Solution, every_solver, integrate, suitable_solver
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.disk_arrays import ArrayStore, blocks
from viscodesign.storage.lru_cache import LruCache

Progress = Callable[[float], None]


@dataclass(frozen=True, eq=False)
class PreparedProblem:
    """A problem, and where its run starts."""

    problem: Problem
    starts_at_rest: bool
    """Whether everything is at rest; else it is in equilibrium, or on a limit cycle."""
    cycle: Schedule | None = None
    """One period of the inputs, where the run starts on its limit cycle."""
    _cycles: LruCache[Start] = field(default_factory=lambda: LruCache(MAX_CYCLES))

    def start(self, tolerance: float, solver: str) -> Start:
        """Unknowns at the start of a run with this tolerance and solver.

        Raises `SolveError` where there is no equilibrium, or no limit cycle.
        """
        if self.cycle is None:
            return self._steady
        one = replace(self.problem, schedule=self.cycle)
        key, found = (tolerance, solver), self._cycles.found((tolerance, solver))
        if found is None:
            found = _shared(limit_cycle(one, self._steady, tolerance, solver).start)
        return self._cycles.keep(key, found)

    @cached_property
    def _steady(self) -> Start:
        """Unknowns in equilibrium, or at rest."""
        piece = self.problem.schedule.initial_piece
        if self.starts_at_rest:
            return _shared(rest(self.problem, piece))
        return _shared(equilibrium(self.problem, 0.0, piece))


MAX_CYCLES = 8
"""Starts on limit cycles that a problem keeps, one for each tolerance and solver."""


def _shared(start: Start) -> Start:
    """A start that all solutions share, hence cannot be written to."""
    for values in (start.states, start.algebraics):
        values.flags.writeable = False
    return start


def prepared_problem(scene: Scene, problem: Problem) -> PreparedProblem:
    """A scene's problem with the start that its spec asks for."""
    period = scene.period if scene.run.start == "periodic" else None
    cycle = None if period is None else cycle_schedule(scene, period)
    return PreparedProblem(problem, scene.run.start == "rest", cycle)


class ProblemStore:
    """The latest problems of scenes: what does not change is prepared once for equal scenes.

    Shared by threads.
    """

    def __init__(self, most: int) -> None:
        self._kept: LruCache[PreparedProblem] = LruCache(most)

    def problem(
        self, quantities: SceneQuantities, effects: Sequence[Effect], settings: Settings
    ) -> PreparedProblem:
        """A scene's equations, formulated once for every set of effects and mesh."""
        mesh = settings.edges_per_section, settings.for_balances
        key = effects_key(quantities, effects), *mesh
        return self._kept.get(
            key, lambda: prepared_problem(quantities.scene, build(quantities, effects, settings))
        )


KEPT_PROBLEMS = ProblemStore(16)
"""Those of the latest scenes, for the next run or function of an equal one."""
MAX_PROBLEMS = 128
"""Problems of one scene: every mesh and set of effects that a study has."""


@dataclass
class Workspace:
    """What the solutions of one scene share; never used by two threads at once."""

    store: ArrayStore = field(default_factory=ArrayStore)
    """Storage for large solutions."""
    problems: ProblemStore = field(default_factory=lambda: ProblemStore(MAX_PROBLEMS))


@dataclass(frozen=True)
class Run:
    """One solution of a scene at one setting."""

    settings: Settings
    problem: Problem
    motion: Motion
    solution: Solution
    build_s: float
    solve_s: float
    read_s: float = 0.0
    """From the unknowns to the motion [s]."""

    @property
    def is_complete(self) -> bool:
        """Whether it reached the end."""
        return self.motion.failure is None and not self.solution.interrupted

    @property
    def is_exact_in_space(self) -> bool:
        """Whether the rod is a row of arcs, which have no mesh."""
        return self.problem.equations.rod_form is RodForm.ARCS

    @property
    def is_exact_in_time(self) -> bool:
        """Whether a smaller tolerance would change nothing."""
        kind = every_solver()[self.solution.solver]
        return kind.is_exact and not self.solution.attempts

    @property
    def spent_s(self) -> float:
        """Wall time, building and solving [s]."""
        return self.build_s + self.solve_s


def solve(
    quantities: SceneQuantities,
    effects: Sequence[Effect],
    settings: Settings,
    progress: Progress | None = None,
    workspace: Workspace | None = None,
) -> Run:
    """Build and solve once. Raises `SolveError` where no initial equilibrium exists.

    ``workspace``: that of earlier solutions of this scene, whose problems are reused.
    """
    workspace = workspace or Workspace()
    began = clock.perf_counter()
    prepared = workspace.problems.problem(quantities, effects, settings)
    problem = prepared.problem
    built = clock.perf_counter()
    solver = suitable_solver(problem, settings.solver, settings.is_free)
    solution = integrate(
        problem,
        prepared.start(settings.tolerance, solver),
        settings.tolerance,
        progress,
        solver,
        workspace.store,
    )
    solved = clock.perf_counter()
    with gentle_interrupt() as interrupt:
        motion = read_motion(problem, solution, workspace.store, quantities.scene.run.shape_stride)
    solution.asked_to_stop |= interrupt.asked
    compile_s = solution.work.compile_s
    build_s, solve_s = built - began + compile_s, solved - built - compile_s
    read_s = clock.perf_counter() - solved
    # The columns of the solution were read into the motion.
    return Run(settings, problem, motion, solution.without_columns(), build_s, solve_s, read_s)


@dataclass(frozen=True)
class FlowDifference:
    """Where the flows of two solutions are farthest apart."""

    share: float
    """Difference of the flows, as a part of the largest of all."""
    tube: int
    row: int


def flow_difference(coarse: Motion, fine: Motion) -> FlowDifference | None:
    """Largest difference of any tube's flow over the output times that both reached."""
    both = min(len(coarse.flow), len(fine.flow))
    largest, worst = 0.0, FlowDifference(0.0, 0, 0)
    for rows in blocks(both, coarse.flow, fine.flow):
        flow = fine.flow[rows]
        apart = np.abs(coarse.flow[rows] - flow)
        largest = max(largest, float(np.max(np.abs(flow), initial=0.0)))
        if np.max(apart, initial=0.0) > worst.share:
            row, tube = np.unravel_index(int(np.argmax(apart)), apart.shape)
            worst = FlowDifference(float(apart[row, tube]), int(tube), rows.start + int(row))
    return replace(worst, share=worst.share / largest) if largest else None


def tip_difference(coarse: Motion, fine: Motion) -> float:
    """Largest distance between two tips over the output times that both reached [m]."""
    return farthest_tip(coarse, fine)[0]


def farthest_tip(coarse: Motion, fine: Motion) -> tuple[float, int]:
    """The same, and the output at which they are that far apart."""
    both = min(len(coarse.tip), len(fine.tip))
    farthest: list[tuple[float, int]] = []
    for rows in blocks(both, coarse.tip, fine.tip):
        apart = coarse.tips(rows) - fine.tips(rows)
        distance = np.hypot(apart[..., 0], apart[..., 1]).max(axis=1)
        row = int(np.argmax(distance))
        farthest.append((float(distance[row]), rows.start + row))
    return farthest[int(np.argmax([distance for distance, _ in farthest]))]
