"""One solution of a scene at one setting."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.motion import Motion, read_motion
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start, equilibrium, rest
from viscodesign.solve.transient import Solution, integrate, solver_catalogue, suitable_solver
from viscodesign.storage.disk_arrays import ArrayStore, blocks
from viscodesign.storage.lru_cache import LruCache

Progress = Callable[[float], None]


@dataclass(frozen=True, eq=False)
class PreparedProblem:
    """A problem, and where its run starts."""

    problem: Problem
    starts_steady: bool
    """Whether that is the equilibrium; else everything is at rest."""

    @cached_property
    def start(self) -> Start:
        """Unknowns at the start. Raises `SolveError` where there is no equilibrium."""
        piece = self.problem.schedule.initial_piece
        if self.starts_steady:
            found = equilibrium(self.problem, 0.0, piece)
        else:
            found = rest(self.problem, piece)
        for values in (found.states, found.algebraics):
            values.flags.writeable = False  # shared by all solutions
        return found


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
        scene = quantities.scene
        key = (scene.digest, tuple(map(type, effects)), settings.edges_per_section)
        steady = scene.run.start == "equilibrium"
        return self._kept.get(
            key, lambda: PreparedProblem(build(quantities, effects, settings), steady)
        )


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
        kind = solver_catalogue()[self.solution.solver]
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
        problem, prepared.start, settings.tolerance, progress, solver, workspace.store
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
    """Of the largest flow of all."""
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
    both = min(len(coarse.tip), len(fine.tip))
    apart = (
        coarse.tip[rows, :2] - fine.tip[rows, :2] for rows in blocks(both, coarse.tip, fine.tip)
    )
    return max(float(np.max(np.hypot(part[:, 0], part[:, 1]))) for part in apart)
