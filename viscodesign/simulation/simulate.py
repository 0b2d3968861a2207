"""From a scene to a trajectory with its error stated."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import EffectAblation, RetryAttempt
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.assemble import cost_of, trajectory_of, uncertain_flows
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.error_control import ErrorParts, Verifier, with_less_tolerance
from viscodesign.simulation.judged_effects import JUDGING, EffectJudge
from viscodesign.simulation.measured_effects import measure_effects
from viscodesign.simulation.missed_effects import EffectEscalation, escalation
from viscodesign.simulation.outcome import accuracy_of, outcome_of
from viscodesign.simulation.solve_once import ProblemStore, Progress, Run, Workspace
from viscodesign.simulation.stopwatch import Stopwatch
from viscodesign.storage.disk_arrays import ArrayStore

_PROBLEMS = ProblemStore(16)
"""Those of the latest scenes, for the next run of an equal one."""


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
    initial equilibrium exists.
    """
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
        quantities, workspace = SceneQuantities(scene), Workspace(ArrayStore(scratch), _PROBLEMS)
        refuse_beyond_numbers(quantities)
        selection = select_effects(quantities)
        refuse_unsolvable(quantities, selection.active)
    judge = EffectJudge(quantities, progress, workspace)
    request = _Request(tolerance, verify, progress, workspace, watch, judge)
    found = _solve_escalating(quantities, selection, request)
    selection, verifier, run = found.selection, found.verifier, found.run
    proof: tuple[EffectAblation, ...] = ()
    if prove and run.is_complete and not (verifier.interrupted or run.solution.asked_to_stop):
        proof = measure_effects(quantities, selection, run.settings, progress, workspace)
    accuracy = accuracy_of(verifier, found.parts, verify)
    status, failure = outcome_of(verifier, run, accuracy, verify)
    with watch("read"):
        trajectory = trajectory_of(quantities, selection, run)
        doubts = tuple(uncertain_flows(trajectory, verifier))
    is_only_solution = verifier.solutions == 1 and not (found.attempts or proof or judge.has_solved)
    return replace(
        trajectory,
        warnings=(*trajectory.warnings, *doubts),
        status=status,
        failure=failure,
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
    attempts: tuple[RetryAttempt, ...] = ()
    """Escalations on the way here."""


def _solve_escalating(
    quantities: SceneQuantities, selection: Selection, request: _Request
) -> _SolvedScene:
    """Solve, and again with more effects as long as the run calls for them."""
    solved, attempts = _solve(quantities, selection, request), []
    while (more := solved.escalation) is not None:
        try:
            again = _solve(quantities, more.selection, request)
        except SolveError as error:  # not even a start: keep the previous solution
            attempts.append(more.attempt(solved=False))
            solved.verifier.stalled = (
                f"more effects are needed ({more.added}), but no initial equilibrium exists "
                f"with them: {error.short}"
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
    verifier = Verifier(
        quantities, selection.effects, selection.neglected_m, request.progress, request.workspace
    )
    with request.watch("choose"):
        whole = request.judge.everything(selection, settings) if request.verify else None
    if whole is not None and whole.solution.asked_to_stop:
        selection = selection.grown(selection.everything, "the run was stopped") or selection
        verifier.neglected_m = selection.neglected_m
        return _SolvedScene(selection, verifier, whole, None, None)
    run = verifier.solve(settings if whole is None else with_less_tolerance(settings))
    parts: ErrorParts | None = None
    with request.watch("choose"):
        more = escalation(quantities, selection, run)
    coarser = whole
    if whole is not None and more is None:
        if run.is_complete:
            coarser, more = _judged(selection, run, whole, verifier, request.judge)
        elif not run.solution.interrupted:
            more = request.judge.completion(selection, run)
    if request.verify and run.is_complete and more is None and not verifier.interrupted:
        run, parts = verifier.verify(run, coarser)
        with request.watch("choose"):
            more = None if verifier.interrupted else escalation(quantities, selection, run)
    return _SolvedScene(selection, verifier, run, parts, more)


def _judged(
    selection: Selection, run: Run, whole: Run, verifier: Verifier, judge: EffectJudge
) -> tuple[Run, EffectEscalation | None]:
    """A coarser solution to compare with a run, and more effects where too much is left out."""
    coarser, found = whole, judge.omission(run, whole)
    if judge.is_too_much(found) and not run.solution.asked_to_stop:
        try:
            alike = verifier.solve(whole.settings)
        except KeyboardInterrupt:  # before its first step
            verifier.interrupted = True
            return coarser, None
        verifier.interrupted = alike.solution.asked_to_stop
        if alike.is_complete:
            coarser, found = alike, judge.omission(alike, whole)
    verifier.neglected_m = selection.stated(JUDGING.stated_per_measured * found.tip_m)
    verifier.measured_neglected = True
    more = judge.escalation(selection, found) if judge.is_too_much(found) else None
    return coarser, None if verifier.interrupted else more
