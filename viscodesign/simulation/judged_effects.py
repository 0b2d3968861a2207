"""Neglected effects judged by the motion itself: the scene is solved once with all of them.

Estimates are made before there is a solution: linear, with one damping. Where a scene rings they
were too small by up to fifty times.

The solution with everything that the spec allows comes first, with ten times the tolerance and
half the edges. It is coarser than the one with the chosen effects, and has more of them: the
distance of the two is at once what is neglected, and the error of steps and mesh. These may hide
each other: then the estimates count. Where the distance is too much or far below the estimates,
or a run has corrected these, a third solution, as coarse and with the chosen effects, tells the
two apart.
"""

from __future__ import annotations

import contextlib
from dataclasses import replace

from viscodesign.checks.refusals import refuse_unsolvable
from viscodesign.effects.allowed_sets import Names
from viscodesign.effects.select import NUMBERS, Selection
from viscodesign.errors import SolveError, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.error_control import ERROR_CONTROL
from viscodesign.simulation.missed_effects import EffectEscalation
from viscodesign.simulation.solve_once import Progress, Run, Workspace, farthest_tip, solve
from viscodesign.solve.event_failures import EventError


@dataclass(frozen=True)
class JudgingNumbers:
    """When and how neglected effects are judged."""

    least_share: float = 1e-3
    """Part of the accuracy below which what they do by the estimates is not judged, where the
    rod does not swing."""
    stated_per_measured: float = 1.25
    """Part of the stated error over the measured distance: the rest of both solutions' own errors.
    Of a mesh with less than twice the edges of the coarser one, times `mesh_share`. What neglected
    effects do by the estimates is added: the coarser one's own error may hide as much of it."""
    stated_per_estimated: float = 2.0
    """The least of both, over what neglected effects do by the estimates: their displacement and
    the error of the coarser mesh may point the same way, and their difference then hides both."""
    stated_per_told_apart: float = 1.5
    """Stated error of neglected effects over the distance of two solutions that are equally coarse,
    in which only they differ."""
    most_apart: float = 5.0
    """Error by the estimates alone (`stated_per_estimated`), over that by the measured distance
    alone (`stated_per_told_apart`), above which a third solution decides: either both parts hide
    each other, or the estimates are far too large."""
    coarser_tolerance: float = 10.0
    """Tolerance of the solution with everything, over that of the run."""
    energy_margin: float = 3.0
    """Energy residual that is foreseen of a run, over what the solution with everything has in
    proportion to both tolerances: at a tenth of the tolerance it was 7 to 30 times smaller."""
    most_reduced: float = 100.0
    """By which the tolerance of a run is divided at most, for its energy balance to close."""
    single_additions: int = 2
    """Effects that are added one at a time before all of them are."""


JUDGING = JudgingNumbers()


def coarser(settings: Settings) -> Settings:
    """Settings of the solution with everything, and of what is compared with it alone.

    Of these only the tip is looked at, and the flows, at the outputs.
    """
    edges = max(1, (settings.edges_per_section + 1) // 2)
    tolerance = JUDGING.coarser_tolerance * settings.tolerance
    return replace(settings, edges_per_section=edges, tolerance=tolerance, for_balances=False)


def mesh_share(fine: Settings, coarse: Settings) -> float:
    """Error of the finer of two meshes, relative to their distance, as order one has it.

    3 edges are not twice 2: their error may be twice the distance. Of equal meshes: 0.
    """
    more = fine.edges_per_section - coarse.edges_per_section
    return ERROR_CONTROL.space_share * coarse.edges_per_section / more if more else 0.0


def judgeable(settings: Settings, everything: Run | None = None) -> Settings:
    """Settings of a run that has twice the edges of a coarser one.

    ``everything``: that one, whose energy residual tells the tolerance at which that of the run
    should be small enough.
    """
    fine = replace(settings, edges_per_section=max(2, settings.edges_per_section))
    residual = everything.motion.invariants.energy_imbalance_rel if everything else None
    if everything is None or not residual:
        return fine
    foreseen = JUDGING.energy_margin * residual / everything.settings.tolerance
    closing = ERROR_CONTROL.energy_imbalance / foreseen
    least = fine.tolerance / JUDGING.most_reduced
    return replace(fine, tolerance=min(fine.tolerance, max(closing, least)))


@dataclass(frozen=True)
class Omission:
    """What all neglected effects together do to the tip."""

    tip_m: float
    time_s: float
    """When they do most [s]."""


class EffectJudge:
    """Measures omissions of one scene; the solution with everything is made once.

    ``weighed``: the effects that were chosen by the estimates alone.
    """

    def __init__(
        self,
        quantities: SceneQuantities,
        weighed: Names,
        progress: Progress | None,
        workspace: Workspace,
    ) -> None:
        self._quantities = quantities
        self._weighed = weighed
        self._progress = progress
        self._workspace = workspace
        self._found: Run | None = None
        self._tried = False
        self.told: tuple[Run, Omission] | None = None
        """What told neglected effects from steps: a solution without them, as coarse as the one
        with everything, and how far they are apart."""
        self._additions = 0

    def everything(self, selection: Selection, settings: Settings) -> Run | None:
        """The coarser solution with all effects: complete, or stopped by the user.

        None where nothing is left out, or next to nothing by estimates that no run has corrected,
        of a rod that does not swing, where the scene is refused with all of them, or where no such
        solution reaches the end. Raises `KeyboardInterrupt` before its first step.
        """
        if not selection.neglected or self._is_spared(selection, settings):
            return None
        if not self._tried:
            self._tried = True
            with contextlib.suppress(SpecError, SolveError):
                self._found = self.solve_everything(selection, coarser(settings))
        found = self._found
        is_useful = found is not None and (found.is_complete or found.solution.asked_to_stop)
        return found if is_useful else None

    def solve_everything(self, selection: Selection, settings: Settings) -> Run:
        """A solution with all effects.

        Raises `SpecError` where the scene is refused with them, `SolveError` where it cannot start.
        """
        refuse_unsolvable(self._quantities, selection.everything)
        effects = selection.members(selection.everything)
        return solve(self._quantities, effects, settings, self._progress, self._workspace)

    def _is_spared(self, selection: Selection, settings: Settings) -> bool:
        """Whether estimates are enough: one solution of a rod with inertia costs as much."""
        if self.are_corrected(selection):
            return False
        if self._quantities.bare_estimate.setting.is_cut:
            return False  # they have not seen all of the input
        if selection.estimated_m > JUDGING.least_share * self._quantities.requested_m:
            return False
        own = (self._quantities, selection.effects, judgeable(settings))
        problem = self._workspace.problems.problem(*own).problem
        return problem.equations.rod_form is not RodForm.DYNAMIC

    def are_corrected(self, selection: Selection) -> bool:
        """Whether a run has shown that the estimates do not see all that matters."""
        return selection.active != self._weighed

    def omission(self, run: Run, everything: Run) -> Omission:
        """How far the tip of a run is from where all effects take it."""
        tip_m, row = farthest_tip(run.motion, everything.motion)
        return Omission(tip_m, float(run.motion.time[row]))

    def is_too_much(self, found: Omission) -> bool:
        """Whether it is more than the part of the accuracy that omissions may spend."""
        return not found.tip_m <= NUMBERS.accuracy_share * self._quantities.requested_m

    def is_far_apart(self, estimated_m: float, found: Omission) -> bool:
        """Whether estimates say far more than was measured, and than is stated at least."""
        least_m = NUMBERS.least_stated * self._quantities.requested_m
        measured_m = max(JUDGING.stated_per_told_apart * found.tip_m, least_m)
        return JUDGING.stated_per_estimated * estimated_m > JUDGING.most_apart * measured_m

    def escalation(self, selection: Selection, found: Omission) -> EffectEscalation | None:
        """More effects, where those left out do too much; None where the spec forbids them.

        The one that does most by the estimates comes first; all of them where that is not enough.
        """
        does = {own.name: selection.switched_m(own.name) for own in selection.neglected}
        single = self._additions < JUDGING.single_additions
        self._additions += 1
        chosen = [max(does, key=lambda name: does[name])] if single else sorted(does)
        off = f"{1e3 * found.tip_m:.3g} mm"
        reason = f"the effects left out together move the tip by {off}, as computed with them"
        return EffectEscalation.of(selection, chosen, reason, found.time_s)

    def completion(self, selection: Selection, run: Run) -> EffectEscalation | None:
        """All effects, where a run without some ends early and one with all of them does not."""
        reason = "the run ends early without effects with which it does not"
        ended_s = float(run.motion.time[-1])
        return EffectEscalation.of(selection, selection.everything, reason, ended_s)

    @staticmethod
    def at_event(selection: Selection, run: Run) -> EffectEscalation | None:
        """All effects, where an event ends a run.

        Effects are weighed by what they do to the tip at the outputs. When a run ends must not
        depend on what these are.
        """
        failure = run.motion.failure
        if not isinstance(failure, EventError):
            return None
        reason = "when a run ends is computed with all effects"
        ended_s = float(run.motion.time[-1]) if failure.time_s is None else failure.time_s
        return EffectEscalation.of(selection, selection.everything, reason, ended_s)

    @property
    def has_solved(self) -> bool:
        """Whether there was a solution beside those of the chosen effects."""
        return self._tried
