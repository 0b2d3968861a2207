"""From a scene to a trajectory with its error stated."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import EffectAblation, RetryAttempt
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.assemble import cost_of, trajectory_of, uncertain_flows
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.error_control import ErrorParts, Verifier
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

    A failure or an interrupt on the way raises nothing: the trajectory ends there, and says so.
    Only an interrupt before the first step raises `KeyboardInterrupt`.

    Raises `SpecError` for a scene without a bounded solution, `SolveError` where not even an
    initial equilibrium exists.
    """
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
    is_only_solution = verifier.solutions == 1 and not (found.attempts or proof)
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
    run = verifier.solve(settings)
    parts: ErrorParts | None = None
    more = _called_for(selection, run, verifier, request)
    if request.verify and run.is_complete and more is None and not verifier.interrupted:
        run, parts = verifier.verify(run)
        with request.watch("choose"):
            more = None if verifier.interrupted else escalation(quantities, selection, run)
    return _SolvedScene(selection, verifier, run, parts, more)


def _called_for(
    selection: Selection, run: Run, verifier: Verifier, request: _Request
) -> EffectEscalation | None:
    """More effects that a run calls for; what those left out do goes into its error."""
    with request.watch("choose"):
        more = escalation(verifier.quantities, selection, run)
        if more is not None or not (request.verify and run.is_complete):
            return more
        judge = request.judge
        try:
            found = judge.omission(selection, run)
        except KeyboardInterrupt:  # before its first step: the run stays
            verifier.interrupted = True
            return None
        verifier.interrupted = judge.interrupted
        if found is None or judge.interrupted:
            return None
        verifier.neglected_m = selection.stated(JUDGING.stated_per_measured * found.tip_m)
        verifier.measured_neglected = True
        return judge.escalation(selection, found)
