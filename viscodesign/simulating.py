"""The one trip: a scene in, a trajectory out."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.build import Settings, build, suggest_settings
from viscodesign.classifying import classification
from viscodesign.effects.base import Effect
from viscodesign.effects.conditions import Conditions
from viscodesign.effects.select import select_effects
from viscodesign.motion import Motion, read_motion
from viscodesign.scene.dump import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import equilibrium, rest
from viscodesign.solve.transient import Solution, integrate
from viscodesign.trajectory import Accuracy, Cost, Notice, Status, Trajectory, Verdict
from viscodesign.validity import Course, course_notices, refuse_unsolvable

Progress = Callable[[float], None]

MAX_REFINEMENTS = 4
"""Refinements after which a run is given up as not reaching the accuracy asked for."""


@dataclass
class _Run:
    """One solution of a scene at one setting."""

    settings: Settings
    problem: Problem
    motion: Motion
    solution: Solution
    build_s: float
    solve_s: float


def simulate(scene: Scene, *, verify: bool = True, progress: Progress | None = None) -> Trajectory:
    """Follow a scene's motion.

    With ``verify`` the scene is solved again on a finer mesh with a smaller
    tolerance until the tip moves by less than the accuracy asked for; the finer
    solution is returned, the difference stated as the error. ``progress`` is told
    the fraction done. A failure or an interrupt on the way is no exception: the
    trajectory ends there, labelled. Raises `SpecError` for a scene without a
    bounded solution, `SolveError` where not even a first equilibrium exists.
    """
    conditions = Conditions(scene)
    effects, verdicts = select_effects(conditions)
    refuse_unsolvable(conditions)
    refiner = _Refiner(conditions, effects, progress)
    run = refiner.solve(suggest_settings(conditions))
    error: float | None = None
    if verify and _complete(run):
        run, error = refiner.refine(run)
    verify_s = refiner.spent_s - run.build_s - run.solve_s
    stopped = refiner.interrupted
    return _trajectory(conditions, tuple(verdicts), run, error, verify, verify_s, stopped)


def _complete(run: _Run) -> bool:
    return run.motion.failure is None and not run.solution.interrupted


class _Refiner:
    """Solves one scene at several settings."""

    def __init__(
        self, conditions: Conditions, effects: list[Effect], progress: Progress | None
    ) -> None:
        self.conditions = conditions
        self.effects = effects
        self.progress = progress
        self.spent_s = 0.0
        self.interrupted = False
        """Whether verification was stopped; the solution before it is kept."""

    def solve(self, settings: Settings) -> _Run:
        """Build and solve once."""
        began = clock.perf_counter()
        problem = build(self.conditions, self.effects, settings)
        built = clock.perf_counter()
        schedule = problem.schedule
        start = (
            equilibrium(problem, 0.0, schedule.initial_piece)
            if self.conditions.scene.run.start == "equilibrium"
            else rest(problem, schedule.initial_piece)
        )
        solution = integrate(problem, start, settings.tolerance, self.progress)
        solved = clock.perf_counter()
        motion = read_motion(problem, solution)
        compile_s = solution.work.compile_s
        build_s, solve_s = built - began + compile_s, solved - built - compile_s
        self.spent_s += build_s + solve_s
        return _Run(settings, problem, motion, solution, build_s, solve_s)

    def refine(self, run: _Run) -> tuple[_Run, float | None]:
        """Refine until the tip no longer moves by more than the accuracy asked for."""
        requested = self.conditions.accuracy * self.conditions.body.length
        error: float | None = None
        for _ in range(MAX_REFINEMENTS):
            finer = self.solve(run.settings.finer())
            if finer.solution.interrupted:
                self.interrupted = True
                return run, error
            if not _complete(finer):
                return finer, None
            error = _tip_difference(run.motion, finer.motion)
            run = finer
            if error <= requested:
                return run, error
        return run, error


def _tip_difference(coarse: Motion, fine: Motion) -> float:
    """Largest distance between two tips over all output times [m]."""
    apart = coarse.tip[:, :2] - fine.tip[:, :2]
    return float(np.max(np.hypot(apart[:, 0], apart[:, 1])))


def _trajectory(
    conditions: Conditions,
    verdicts: tuple[Verdict, ...],
    run: _Run,
    error: float | None,
    verify: bool,
    verify_s: float,
    stopped: bool,
) -> Trajectory:
    scene, motion, graph = conditions.scene, run.motion, conditions.graph
    text = resolved_yaml(scene)
    status, failure = _outcome(conditions, run, error, stopped)
    found = classification(conditions)
    course = Course(
        motion.time,
        graph.bellows,
        motion.pressure,
        motion.volume,
        tuple(t.name for t in graph.tubes),
        motion.flow,
        motion.section_stretch,
        motion.section_turn,
    )
    return Trajectory(
        name=scene.name,
        status=status,
        time=motion.time,
        tip=motion.tip,
        inlet_pressure=dict(zip(scene.inputs, motion.inlet_pressure.T, strict=True)),
        bellows=graph.bellows,
        pressure=motion.pressure,
        volume=motion.volume,
        tubes=tuple(t.name for t in graph.tubes),
        flow=motion.flow,
        arc=motion.arc,
        shape=motion.shape,
        length=scene.actuator.length,
        width=scene.actuator.height,
        classification=found,
        effects=verdicts,
        accuracy=_accuracy(conditions, error, verify),
        cost=_cost(run, verify_s),
        invariants=motion.invariants,
        warnings=_merged(found.warnings, course_notices(conditions, course)),
        spec_text=text,
        spec_sha256=scene.source.sha256,
        version=__version__,
        settings=_settings(run),
        failure=failure,
    )


def _outcome(
    conditions: Conditions, run: _Run, error: float | None, stopped: bool
) -> tuple[Status, str | None]:
    """How the run ended, and the message where it ended badly."""
    requested = conditions.accuracy * conditions.body.length
    if run.solution.interrupted:
        return "interrupted", f"interrupted at t = {run.motion.time[-1]:.6g} s"
    if stopped:
        return "interrupted", (
            "interrupted while verifying: the motion is there to its end, its error is not known"
        )
    if run.motion.failure is not None:
        return "failed", str(run.motion.failure)
    if error is not None and error > requested:
        return "failed", (
            f"the accuracy asked for, {1e3 * requested:.3g} mm at the tip, was not reached: "
            f"after {MAX_REFINEMENTS} refinements the tip still moves by {1e3 * error:.3g} mm. "
            "Ask for less accuracy, or look at the last shapes for an instability."
        )
    return "complete", None


def _accuracy(conditions: Conditions, error: float | None, verify: bool) -> Accuracy:
    requested = conditions.accuracy * conditions.body.length
    if not verify:
        return Accuracy(requested, None, "not verified")
    if error is None:
        return Accuracy(
            requested, None, "not verified: the solution or its check did not reach the end"
        )
    return Accuracy(
        requested,
        error,
        "largest move of the tip when edges are halved and the tolerance is cut to a tenth",
    )


def _cost(run: _Run, verify_s: float) -> Cost:
    work = run.solution.work
    return Cost(
        build_s=run.build_s,
        solve_s=run.solve_s,
        verify_s=verify_s,
        steps=work.steps,
        residual_calls=work.residual_calls,
        jacobian_calls=work.jacobian_calls,
    )


def _settings(run: _Run) -> dict[str, Any]:
    equations = run.problem.equations
    return {
        "rod": equations.rod_form.value,
        "network": equations.network_form.value,
        "edges_per_section": run.settings.edges_per_section,
        "tolerance": run.settings.tolerance,
        "states": equations.states.count,
        "algebraic_unknowns": equations.algebraics.count,
    }


def _merged(before: Iterable[Notice], after: Iterable[Notice]) -> tuple[Notice, ...]:
    """What the run met replaces what the scene only announced, code by code."""
    met = list(after)
    codes = {notice.code for notice in met}
    return (*(n for n in before if n.code not in codes), *met)
