"""The one trip: a scene in, a trajectory out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.checks.classify import classification
from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.checks.scene_warnings import verdict_notices
from viscodesign.effects.select import OMISSIONS_SURE, Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.graph import Graph
from viscodesign.postprocess.motion import Motion
from viscodesign.postprocess.stability import growth_notices
from viscodesign.postprocess.terminations import broken_balance, doubted_balance
from viscodesign.postprocess.validity_in_motion import Course, course_notices
from viscodesign.results.findings import EffectAblation, Notice, RetryAttempt
from viscodesign.results.trajectory import Accuracy, Cost, Status, Trajectory
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.error_control import LEFT_BY_SPACE, LEFT_BY_TIME, ErrorParts, Verifier
from viscodesign.simulation.measured_effects import measure_effects
from viscodesign.simulation.missed_effects import Reselection, reselected
from viscodesign.simulation.solve_once import Progress, Run, Workspace
from viscodesign.storage.disk_arrays import ArrayStore, blocks


def simulate(
    scene: Scene,
    *,
    verify: bool = True,
    prove: bool = False,
    tolerance: float | None = None,
    progress: Progress | None = None,
    scratch: Path | None = None,
) -> Trajectory:
    """Follow a scene's motion.

    With ``verify`` the scene is solved again with a smaller tolerance and on a finer mesh
    until the error estimated from it is below the accuracy asked for; the finest
    solution is returned. With ``prove`` every
    effect is switched, solved again, and its change at the tip measured.
    ``tolerance`` is the integrator's, where it shall not follow from the accuracy.
    ``progress`` is told the fraction done. ``scratch`` is a folder for what a long run has
    no memory for, the system's own if not given; nothing is left there. A failure or an
    interrupt on the way is no exception: the trajectory ends there, labelled. Raises
    `SpecError` for a scene without a bounded solution, `SolveError` where not even a first
    equilibrium exists.
    """
    quantities, workspace = SceneQuantities(scene), Workspace(ArrayStore(scratch))
    refuse_beyond_numbers(quantities)
    selection = select_effects(quantities)
    refuse_unsolvable(quantities, selection.taken)
    ladder: list[RetryAttempt] = []
    asked = _Asked(tolerance, verify, progress, workspace)
    solved = _solve(quantities, selection, asked)
    while (more := solved.called_for) is not None:
        try:
            again = _solve(quantities, more.selection, asked)
        except SolveError as error:  # not even a start: what there was is kept
            ladder.append(more.rung(False))
            solved.verifier.stalled = (
                f"it calls for more ({more.tried}), but then it has no start: {error.short}"
            )
            break
        ladder.append(more.rung(again.run.is_complete))
        selection, solved = more.selection, again
    verifier, run = solved.verifier, solved.run
    proof: tuple[EffectAblation, ...] = ()
    if prove and run.is_complete and not verifier.interrupted:
        proof = measure_effects(quantities, selection, run.settings, progress, workspace)
    accuracy = _accuracy(verifier, solved.parts, verify)
    status, failure = _outcome(verifier, run, accuracy, verify)
    found = _trajectory(quantities, selection, run)
    return replace(
        found,
        warnings=(*found.warnings, *_uncertain_flows(found, verifier)),
        status=status,
        failure=failure,
        accuracy=accuracy,
        cost=_cost(run, verifier.spent_s - run.spent_s),
        proof=proof,
        ladder=(*ladder, *run.solution.attempts),
    )


@dataclass(frozen=True)
class _Solved:
    """A scene solved with one set of effects."""

    verifier: Verifier
    run: Run
    parts: ErrorParts | None
    called_for: Reselection | None
    """More effects, with which it is all to be done again."""


@dataclass(frozen=True)
class _Asked:
    """How a scene is to be solved."""

    tolerance: float | None
    verify: bool
    progress: Progress | None
    workspace: Workspace


def _solve(quantities: SceneQuantities, selection: Selection, asked: _Asked) -> _Solved:
    settings = suggest_settings(quantities, selection.effects)
    if asked.tolerance is not None:
        settings = replace(settings, tolerance=asked.tolerance)
    verifier = Verifier(
        quantities, selection.effects, selection.omitted_m, asked.progress, asked.workspace
    )
    run = verifier.solve(settings)
    parts: ErrorParts | None = None
    more = reselected(quantities, selection, run)
    if asked.verify and run.is_complete and more is None:
        run, parts = verifier.verify(run)
        more = None if verifier.interrupted else reselected(quantities, selection, run)
    return _Solved(verifier, run, parts, more)


def _trajectory(quantities: SceneQuantities, selection: Selection, run: Run) -> Trajectory:
    """The motion with what it met; how it ended and how exact it is come later."""
    scene, motion, graph = quantities.scene, run.motion, quantities.graph
    text = resolved_yaml(scene)
    verdicts, active = selection.verdicts, selection.taken
    found = classification(quantities, active)
    forced = tuple(verdict_notices(verdicts))
    return Trajectory(
        name=scene.name,
        status="complete",
        arrays=motion.arrays,
        arc=motion.arc,
        shape_every=motion.shape_every,
        inlets=tuple(scene.inputs),
        bellows=graph.bellows,
        tubes=tuple(t.name for t in graph.tubes),
        junctions=graph.junctions,
        length=scene.actuator.length,
        width=scene.actuator.height,
        classification=found,
        effects=verdicts,
        accuracy=Accuracy(quantities.accuracy * quantities.body.length, None, NOT_VERIFIED),
        cost=_cost(run, 0.0),
        invariants=motion.invariants,
        warnings=_merged(
            (*forced, *found.warnings, *_growth(quantities, active, run)),
            (
                *course_notices(quantities, active, _courses(quantities, motion)),
                *doubted_balance(motion.invariants),
                *_thinned(motion),
            ),
        ),
        spec_text=text,
        spec_sha256=scene.source.sha256,
        version=__version__,
        ambient_pressure=scene.ambient_pressure,
        settings=_settings(run),
    )


FLOWS_UNSURE = 0.02
"""Estimated error of a flow, of the largest in the network, that is warned of."""


def _uncertain_flows(found: Trajectory, verifier: Verifier) -> Iterator[Notice]:
    """A warning where smaller steps move the flows, however still the tip stays."""
    apart = verifier.flows_apart
    if apart is None or LEFT_BY_TIME * apart.share <= FLOWS_UNSURE:
        return
    if apart.row >= len(found.time):
        return  # a finer solution ended before, and is told of by itself
    tube = found.tubes[apart.tube]
    yield Notice(
        "uncertain_flows",
        f"the flow through {tube} is uncertain by {LEFT_BY_TIME * apart.share:.2g} of the largest "
        "flow there is: ask for more accuracy where flows matter",
        tube,
        float(found.time[apart.row]),
    )


def _growth(quantities: SceneQuantities, active: frozenset[str], run: Run) -> list[Notice]:
    """Whether the start is left by itself, where a coupling could make it so."""
    free = quantities.tip_force + quantities.weight == 0.0
    if "feedback" not in active or ("damping" in active and free):
        return []
    return growth_notices(run.problem, run.solution.beginning)


def _courses(quantities: SceneQuantities, motion: Motion) -> Iterator[Course]:
    """The motion, block by block, for the checks."""
    graph, names = quantities.graph, tuple(quantities.scene.inputs)
    for rows in blocks(len(motion.time), *motion.arrays.values()):
        yield Course(
            motion.time[rows],
            graph.bellows,
            motion.pressure[rows],
            motion.volume[rows],
            tuple(t.name for t in graph.tubes),
            motion.flow[rows],
            _lower_ends(graph, motion, names, rows),
            motion["section_stretch"][rows],
            motion["section_turn"][rows],
        )


def _lower_ends(graph: Graph, motion: Motion, inlets: tuple[str, ...], rows: slice) -> np.ndarray:
    """Lower gauge pressure of each tube's ends (T, Q) [Pa]."""
    columns = {
        **dict(zip(graph.bellows, motion.pressure[rows].T, strict=True)),
        **dict(zip(inlets, motion["inlet_pressure"][rows].T, strict=True)),
        **dict(zip(graph.junctions, motion["junction_pressure"][rows].T, strict=True)),
    }
    lower = [np.minimum(columns[t.start], columns[t.end]) for t in graph.tubes]
    return np.array(lower).T.reshape(len(motion.time[rows]), len(graph.tubes))


def _thinned(motion: Motion) -> Iterator[Notice]:
    """Whether shapes were left out to keep the run's files small."""
    if motion.shape_every > 1:
        yield Notice(
            "thinned_shapes",
            f"whole shapes are kept at {len(motion.shape)} of {len(motion.time)} output times, "
            f"every {motion.shape_every} of them and the last (run.shape_every); the tip at all",
            "shape.csv",
        )


def _outcome(
    verifier: Verifier, run: Run, accuracy: Accuracy, verify: bool
) -> tuple[Status, str | None]:
    """How the run ended, and the message where it ended badly."""
    if run.solution.interrupted:
        return "interrupted", f"interrupted at t = {run.motion.time[-1]:.6g} s"
    if verifier.interrupted:
        return "interrupted", (
            "interrupted while verifying: the motion is there to its end, its error is not known"
        )
    if run.motion.failure is not None:
        return "failed", str(run.motion.failure)
    reached = float(run.motion.time[-1]) if run.motion.time.size else 0.0
    if broken := broken_balance(run.motion.invariants, reached):
        return "failed", str(broken)
    error = accuracy.estimated_tip_error_m
    if verify and error is None:
        return (
            "failed",
            f"the motion is there to its end, its error is not known: {verifier.stalled}",
        )
    if error is not None and error > accuracy.requested_m:
        return "failed", _missed(verifier, accuracy, error)
    return "complete", None


def _missed(verifier: Verifier, accuracy: Accuracy, error: float) -> str:
    """The message of a run whose error stayed above the one asked for."""
    parts = (
        ("time", accuracy.time_m, "look at the last shapes for an instability"),
        ("space", accuracy.space_m, "look at the last shapes for a kink"),
        ("omitted effects", accuracy.omitted_m, "--set effects.others=on takes them all in"),
    )
    _, _, remedy = max(parts, key=lambda part: part[1] or 0.0)
    told = ", ".join(f"{name} {1e3 * (size or 0.0):.3g} mm" for name, size, _ in parts)
    if verifier.stalled:
        told += f"; {verifier.stalled}"
    return (
        f"the accuracy asked for, {1e3 * accuracy.requested_m:.3g} mm at the tip, was not "
        f"reached: after {verifier.solutions} solutions the error is estimated at "
        f"{1e3 * error:.3g} mm ({told}). Ask for less accuracy, or {remedy}."
    )


NOT_VERIFIED = "not verified"
METHOD = (
    f"time: {LEFT_BY_TIME:g} of the tip's last move when the tolerance was cut to a tenth; "
    f"space: {LEFT_BY_SPACE:g} of its last move when the edges were halved; omitted effects: "
    f"{OMISSIONS_SURE:g} times the distance of two sketches, with and without them"
)


def _accuracy(verifier: Verifier, parts: ErrorParts | None, verify: bool) -> Accuracy:
    if parts is None:
        ended = "" if not verify else ": the solution or its check did not reach the end"
        return Accuracy(
            verifier.requested_m, None, NOT_VERIFIED + ended, omitted_m=verifier.omitted_m
        )
    return Accuracy(
        verifier.requested_m,
        parts.total_m,
        METHOD,
        time_m=parts.time_m,
        space_m=parts.space_m,
        omitted_m=parts.omitted_m,
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
        "solver": run.solution.solver,
        "states": equations.states.count,
        "algebraic_unknowns": equations.algebraics.count,
    }


def _merged(before: Iterable[Notice], after: Iterable[Notice]) -> tuple[Notice, ...]:
    """What the run met replaces what the scene only announced, code by code."""
    met = list(after)
    codes = {notice.code for notice in met}
    return (*(n for n in before if n.code not in codes), *met)
