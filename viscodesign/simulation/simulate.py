"""From a scene to a trajectory with its error stated."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError, SpecError, UsageError
from viscodesign.estimate.joined_quantities import quantities_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import EffectAblation, RetryAttempt
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.assemble import cost_of, trajectory_of
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.confirmed_event import EventDoubt, confirm_event
from viscodesign.simulation.doubts import doubts
from viscodesign.simulation.error_control import ErrorParts, Verifier
from viscodesign.simulation.judged_effects import (
    JUDGING,
    EffectJudge,
    coarser,
    judgeable,
    mesh_share,
)
from viscodesign.simulation.measured_effects import measure_effects
from viscodesign.simulation.missed_effects import EffectEscalation, escalation
from viscodesign.simulation.outcome import accuracy_of, outcome_of
from viscodesign.simulation.path_to_event import with_path_to_event
from viscodesign.simulation.solve_once import (
    KEPT_PROBLEMS,
    Progress,
    Run,
    Workspace,
    tip_difference,
)
from viscodesign.simulation.stopwatch import Stopwatch
from viscodesign.storage.disk_arrays import ArrayStore


def simulate(
    scene: Scene,
    *,
    verify: bool = True,
    prove: bool = False,
    tolerance: float | None = None,
    progress: Progress | None = None,
    scratch: Path | None = None,
) -> Trajectory:
    """Compute the motion of a scene.

    With ``verify`` the scene is solved again with a smaller tolerance and on a finer mesh
    until the estimated error is below the requested accuracy; the finest solution is
    returned. With ``prove`` every effect is switched, solved again, and the displacement of the
    tip measured. ``tolerance`` is that of the integrator, where it is not to follow from the
    accuracy. ``progress`` is called with the fraction done. ``scratch`` is a folder for the
    arrays of a long run, by default that of the system; nothing remains there.

    A failure on the way raises nothing: the trajectory ends there, and says so. Ctrl-C raises
    `RunInterruptedError`, a `KeyboardInterrupt` that holds the trajectory as far as it came; a
    second one while it is being read raises at once.

    Raises `SpecError` for a scene without a bounded solution, `SolveError` where not even an
    initial equilibrium exists, `UsageError` for a tolerance that is none.
    """
    if tolerance is not None and not 0.0 < tolerance < 1.0:
        raise UsageError(f"tolerance: must be above 0 and below 1, such as 1e-5; got {tolerance:g}")
    with gentle_interrupt(second_raises=True) as interrupt:
        try:
            trajectory = _simulated(scene, verify, prove, tolerance, progress, scratch)
        except KeyboardInterrupt:  # before the first step
            raise RunInterruptedError(None) from None
    if interrupt.asked or trajectory.status == "interrupted":
        raise RunInterruptedError(trajectory)
    return trajectory


def _simulated(
    scene: Scene,
    verify: bool,
    prove: bool,
    tolerance: float | None,
    progress: Progress | None,
    scratch: Path | None,
) -> Trajectory:
    """The trajectory, as far as it came before an interrupt."""
    watch = Stopwatch()
    with watch("choose"):
        quantities, workspace = quantities_of(scene), Workspace(ArrayStore(scratch), KEPT_PROBLEMS)
        refuse_beyond_numbers(quantities)
        selection = select_effects(quantities)
        refuse_unsolvable(quantities, selection.active)
    judge = EffectJudge(quantities, selection.active, progress, workspace)
    request = _Request(tolerance, verify, progress, workspace, watch, judge)
    found = _solve_escalating(quantities, selection, request)
    selection, verifier = found.selection, found.verifier
    run = with_path_to_event(found.run, workspace.store)
    proof: tuple[EffectAblation, ...] = ()
    if prove and run.is_complete and not (verifier.interrupted or run.solution.asked_to_stop):
        proof = measure_effects(quantities, selection, run.settings, progress, workspace)
    accuracy = accuracy_of(verifier, found.parts, verify)
    status, failure = outcome_of(verifier, run, accuracy, verify)
    with watch("read"):
        trajectory = trajectory_of(quantities, selection, run)
        inputs, duration = quantities.scene.inputs.values(), quantities.scene.run.duration
        is_driven = any(source.moves_within(duration) for source in inputs)
        doubted = doubts(trajectory, accuracy, verifier, is_driven=is_driven)
        if found.event_doubt is not None:
            doubted += tuple(found.event_doubt.notices(duration))
    is_only_solution = verifier.solutions == 1 and not (found.attempts or proof or judge.has_solved)
    return replace(
        trajectory,
        warnings=(*trajectory.warnings, *doubted),
        status=status,
        failure=failure,
        failure_time_s=None if run.motion.failure is None else run.motion.failure.time_s,
        accuracy=accuracy,
        cost=watch.share_out(cost_of(run), is_only_solution=is_only_solution),
        proof=proof,
        ladder=(*found.attempts, *run.solution.attempts),
    )


@dataclass(frozen=True)
class _Request:
    """How a scene is to be solved."""

    tolerance: float | None
    verify: bool
    progress: Progress | None
    workspace: Workspace
    watch: Stopwatch
    judge: EffectJudge


@dataclass(frozen=True)
class _SolvedScene:
    """A scene solved with one set of effects."""

    selection: Selection
    verifier: Verifier
    run: Run
    parts: ErrorParts | None
    escalation: EffectEscalation | None
    """More effects, with which it is to be solved again."""
    event_doubt: EventDoubt | None = None
    """How well an event is known that ends the run, or nearly does."""
    attempts: tuple[RetryAttempt, ...] = ()
    """Escalations on the way here."""


def _solve_escalating(
    quantities: SceneQuantities, selection: Selection, request: _Request
) -> _SolvedScene:
    """Solve, and again with more effects as long as the run calls for them."""
    solved, attempts = _solve(quantities, selection, request), []
    while (more := solved.escalation) is not None:
        try:
            refuse_unsolvable(quantities, more.selection.active)
            again = _solve(quantities, more.selection, request)
        except (SpecError, SolveError) as error:  # not even a start: keep the previous solution
            attempts.append(more.attempt(solved=False))
            solved.verifier.stalled = f"more effects are needed ({more.added}), but " + (
                f"no initial equilibrium exists with them: {error.short}"
                if isinstance(error, SolveError)
                else f"the scene is refused with them: {error.faults[0]}"
            )
            break
        except KeyboardInterrupt:  # before its first step: keep the previous solution
            solved.verifier.interrupted = True
            break
        attempts.append(more.attempt(again.run.is_complete))
        solved = again
    return replace(solved, attempts=tuple(attempts))


def _solve(quantities: SceneQuantities, selection: Selection, request: _Request) -> _SolvedScene:
    settings = suggest_settings(quantities, selection.effects)
    if request.tolerance is not None:
        settings = replace(settings, tolerance=request.tolerance)
    with request.watch("choose"):
        whole = request.judge.everything(selection, settings) if request.verify else None
        missed = None if whole is None else escalation(quantities, selection, whole)
    if missed is not None:  # from the start, rather than of a run without it
        selection = missed.selection
        whole = whole if selection.neglected else None
    verifier = Verifier(
        quantities, selection.effects, selection.neglected_m, request.progress, request.workspace
    )
    if whole is not None and whole.solution.asked_to_stop:
        selection = selection.grown(selection.everything, "the run was stopped") or selection
        verifier.neglected_m = selection.neglected_m
        verifier.interrupted = True  # also where it was done when it was asked to stop
        return _SolvedScene(selection, verifier, whole, None, None)
    run = verifier.solve(settings if whole is None else judgeable(settings, whole))
    with request.watch("choose"):
        more = escalation(quantities, selection, run)
    whole_error: WholeError | None = None
    if whole is not None and more is None:
        if run.is_complete:
            whole_error, more = _judged(selection, run, whole, verifier, request.judge)
        elif not run.solution.interrupted:
            more = request.judge.completion(selection, run)
    more = more or request.judge.at_event(selection, run)
    if more is not None or not request.verify or verifier.interrupted:
        return _SolvedScene(selection, verifier, run, None, more)
    run, parts, doubt = _verified(run, verifier, whole_error)
    if parts is not None and not verifier.interrupted:
        parts, more = _judged_again(selection, run, parts, verifier, request.judge)
    with request.watch("choose"):
        called = None if verifier.interrupted else escalation(quantities, selection, run)
        more = called or more
    more = more or request.judge.at_event(selection, run)
    return _SolvedScene(selection, verifier, run, parts, more, doubt)


def _verified(
    run: Run, verifier: Verifier, whole_error: WholeError | None
) -> tuple[Run, ErrorParts | None, EventDoubt | None]:
    """The finest solution, its error where it reached the end, and doubts of an event.

    An event is confirmed before and after: each solution may meet one that another does not.
    """
    run, doubt = confirm_event(verifier, run)
    if not run.is_complete or verifier.interrupted:
        return run, None, doubt
    run, parts = verifier.verify(run, whole_error)
    if run.is_complete or verifier.interrupted:
        return run, parts, doubt
    run, latest = confirm_event(verifier, run)
    return run, None, latest or doubt


WholeError = Callable[[Run], float]
"""All parts of a solution's error together [m]."""


def _judged(
    selection: Selection, run: Run, whole: Run, verifier: Verifier, judge: EffectJudge
) -> tuple[WholeError | None, EffectEscalation | None]:
    """The whole error of a run where one distance tells it, and more effects where it lacks some.

    ``whole``: a coarser solution with all effects.
    """

    estimated_m = selection.estimated_m

    def apart(finer: Run) -> float:
        share = JUDGING.stated_per_measured * max(1.0, mesh_share(finer.settings, whole.settings))
        measured_m = share * judge.omission(finer, whole).tip_m + estimated_m
        return selection.stated(max(measured_m, JUDGING.stated_per_estimated * estimated_m))

    verifier.compare_flows(whole, run)
    found = judge.omission(run, whole)
    verifier.neglected_m = apart(run)
    is_enough = verifier.neglected_m <= verifier.requested_m
    is_doubtful = judge.are_corrected(selection) or judge.is_far_apart(estimated_m, found)
    if (is_enough and not is_doubtful) or run.solution.asked_to_stop:
        return apart, None
    try:
        alike = verifier.solve(whole.settings)
    except KeyboardInterrupt:  # before its first step
        verifier.interrupted = True
        return None, None
    verifier.interrupted = alike.solution.asked_to_stop
    neglected_m = verifier.neglected_m
    if alike.is_complete:
        found = judge.omission(alike, whole)
        judge.told = alike, found
        neglected_m = selection.stated(JUDGING.stated_per_told_apart * found.tip_m)
    verifier.neglected_m, verifier.measured_neglected = neglected_m, True
    if verifier.interrupted:
        return None, None

    def of_steps_and_effects(finer: Run) -> float:
        share = mesh_share(finer.settings, alike.settings)
        return neglected_m + share * tip_difference(alike.motion, finer.motion)

    if alike.is_complete and of_steps_and_effects(run) <= verifier.requested_m:
        return of_steps_and_effects, None
    return None, judge.escalation(selection, found) if judge.is_too_much(found) else None


def _judged_again(
    selection: Selection, run: Run, parts: ErrorParts, verifier: Verifier, judge: EffectJudge
) -> tuple[ErrorParts, EffectEscalation | None]:
    """The error of a refined run, its neglected effects measured anew where that is needed.

    That is where refinement has moved the tip as far as they did: the coarse solutions that told it
    may not ring at all where the fine ones ring for long, and then show next to nothing of what
    shifts a frequency. What is left of that counts as if it hid as much.
    """
    told, judge.told = judge.told, None
    if told is None or parts.time_m is None or run.solution.asked_to_stop:
        return parts, None
    (alike, found), coarse = told, coarser(run.settings)
    for settings in (coarse, replace(coarse, tolerance=run.settings.tolerance), None):
        unresolved_m = tip_difference(alike.motion, run.motion)
        least_m = JUDGING.stated_per_told_apart * found.tip_m
        neglected_m = selection.stated(max(least_m, found.tip_m + unresolved_m))
        parts = replace(parts, neglected_m=neglected_m)
        is_enough = parts.total_m <= verifier.requested_m
        if is_enough or least_m >= found.tip_m + unresolved_m or settings is None:
            break
        try:
            whole, alike = judge.solve_everything(selection, settings), verifier.solve(settings)
        except (SpecError, SolveError):  # with everything it was solved before, if more coarsely
            break
        except KeyboardInterrupt:  # before its first step
            verifier.interrupted = True
            break
        verifier.interrupted = whole.solution.asked_to_stop or alike.solution.asked_to_stop
        if not (whole.is_complete and alike.is_complete):
            break
        found = judge.omission(alike, whole)
    verifier.neglected_m = parts.neglected_m
    is_over = is_enough or verifier.interrupted
    return parts, None if is_over else judge.escalation(selection, found)
