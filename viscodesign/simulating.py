"""The one trip: a scene in, a trajectory out."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.build import suggest_settings
from viscodesign.classifying import classification
from viscodesign.course import Course, course_notices
from viscodesign.effects.conditions import Conditions
from viscodesign.effects.select import select_effects
from viscodesign.model.graph import Graph
from viscodesign.motion import Motion
from viscodesign.proving import prove as prove_effects
from viscodesign.scene.dump import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.solving import MAX_REFINEMENTS, Progress, Refiner, Run
from viscodesign.trajectory import Accuracy, Cost, Notice, Proof, Status, Trajectory, Verdict
from viscodesign.validity import refuse_unsolvable, verdict_notices


def simulate(
    scene: Scene,
    *,
    verify: bool = True,
    prove: bool = False,
    tolerance: float | None = None,
    progress: Progress | None = None,
) -> Trajectory:
    """Follow a scene's motion.

    With ``verify`` the scene is solved again on a finer mesh with a smaller
    tolerance until the tip moves by less than the accuracy asked for; the finer
    solution is returned, the difference stated as the error. With ``prove`` every
    effect is switched, solved again, and its change at the tip measured.
    ``tolerance`` is the integrator's, where it shall not follow from the accuracy.
    ``progress`` is told the fraction done. A failure or an interrupt on the way is no
    exception: the trajectory ends there, labelled. Raises `SpecError` for a scene
    without a bounded solution, `SolveError` where not even a first equilibrium exists.
    """
    conditions = Conditions(scene)
    selection = select_effects(conditions)
    refuse_unsolvable(conditions)
    settings = suggest_settings(conditions)
    if tolerance is not None:
        settings = replace(settings, tolerance=tolerance)
    refiner = Refiner(conditions, selection.effects, progress)
    run = refiner.solve(settings)
    error: float | None = None
    if verify and run.is_complete:
        run, error = refiner.refine(run)
    proof: tuple[Proof, ...] = ()
    if prove and run.is_complete and not refiner.interrupted:
        proof = prove_effects(conditions, selection, settings, progress)
    verify_s = refiner.spent_s - run.spent_s
    stopped = refiner.interrupted
    found = _trajectory(conditions, selection.verdicts, run, error, verify, verify_s, stopped)
    return replace(found, proof=proof)


def _trajectory(
    conditions: Conditions,
    verdicts: tuple[Verdict, ...],
    run: Run,
    error: float | None,
    verify: bool,
    verify_s: float,
    stopped: bool,
) -> Trajectory:
    scene, motion, graph = conditions.scene, run.motion, conditions.graph
    text = resolved_yaml(scene)
    status, failure = _outcome(conditions, run, error, stopped)
    found = classification(conditions)
    forced = tuple(verdict_notices(verdicts))
    course = Course(
        motion.time,
        graph.bellows,
        motion.pressure,
        motion.volume,
        tuple(t.name for t in graph.tubes),
        motion.flow,
        _lower_ends(graph, motion, tuple(scene.inputs)),
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
        warnings=_merged((*forced, *found.warnings), course_notices(conditions, course)),
        spec_text=text,
        spec_sha256=scene.source.sha256,
        version=__version__,
        ambient_pressure=scene.ambient_pressure,
        settings=_settings(run),
        failure=failure,
    )


def _lower_ends(graph: Graph, motion: Motion, inlets: tuple[str, ...]) -> np.ndarray:
    """Lower gauge pressure of each tube's ends (T, Q) [Pa]."""
    columns = {
        **dict(zip(graph.bellows, motion.pressure.T, strict=True)),
        **dict(zip(inlets, motion.inlet_pressure.T, strict=True)),
        **dict(zip(graph.junctions, motion.junction_pressure.T, strict=True)),
    }
    lower = [np.minimum(columns[t.start], columns[t.end]) for t in graph.tubes]
    return np.array(lower).T.reshape(len(motion.time), len(graph.tubes))


def _outcome(
    conditions: Conditions, run: Run, error: float | None, stopped: bool
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


def _cost(run: Run, verify_s: float) -> Cost:
    work = run.solution.work
    return Cost(
        build_s=run.build_s,
        solve_s=run.solve_s,
        verify_s=verify_s,
        steps=work.steps,
        residual_calls=work.residual_calls,
        jacobian_calls=work.jacobian_calls,
    )


def _settings(run: Run) -> dict[str, Any]:
    equations = run.problem.equations
    return {
        "rod": equations.rod_form.value,
        "network": equations.network_form.value,
        "edges_per_section": run.settings.edges_per_section,
        "tolerance": run.settings.tolerance,
        "solver": run.settings.solver,
        "states": equations.states.count,
        "algebraic_unknowns": equations.algebraics.count,
    }


def _merged(before: Iterable[Notice], after: Iterable[Notice]) -> tuple[Notice, ...]:
    """What the run met replaces what the scene only announced, code by code."""
    met = list(after)
    codes = {notice.code for notice in met}
    return (*(n for n in before if n.code not in codes), *met)
