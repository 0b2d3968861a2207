"""Effects that a run calls for although an estimate neglected them.

An estimate is linear, with means over the motion. The solved run knows better; every
neglected effect looks at it and says whether it matters (`Effect.missed_in`).
"""

from __future__ import annotations

from collections.abc import Iterable

from viscodesign.effects.base import Missed
from viscodesign.effects.select import NUMBERS, Selection
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import RetryAttempt
from viscodesign.simulation.solve_once import Run


@dataclass(frozen=True)
class EffectEscalation:
    """A larger set of effects, with which the whole run is to be solved again."""

    selection: Selection
    added: str
    """What is tried, in words."""
    reason: str
    time_s: float
    """Where the run called for it [s]."""

    @classmethod
    def of(
        cls, selection: Selection, more: Iterable[str], reason: str, time_s: float
    ) -> EffectEscalation | None:
        """From a selection to one with more effects; None where that is forbidden or not new."""
        grown = selection.grown(more, reason)
        if grown is None:
            return None
        names = [e.name for e in grown.effects if e.name not in selection.active]
        return cls(grown, f"{' and '.join(names)} included, from the start", reason, time_s)

    def attempt(self, solved: bool) -> RetryAttempt:
        """How it is reported once the run was solved again."""
        return RetryAttempt(self.time_s, self.added, solved, self.reason)


def escalation(
    quantities: SceneQuantities, selection: Selection, run: Run
) -> EffectEscalation | None:
    """The effects that a run calls for beyond those it has; None where it needs no more.

    The whole run is to be solved again: a rod that has snapped remembers how it moved.
    Nothing that the spec forbids is added, and every answer is larger than ``selection``.
    """
    if run.solution.asked_to_stop:
        return None
    allowed_m = NUMBERS.accuracy_share * quantities.requested_m
    missed: list[tuple[str, Missed]] = []
    # Not at its outputs alone: what it does must not hang on when it is looked at.
    motion = run.motion.at_solved_times() if selection.neglected else run.motion
    for effect in selection.neglected:
        found = effect.missed_in(quantities, run.problem, motion)
        if found is not None and (found.tip_m > allowed_m or found.leaves_validity):
            missed.append((effect.name, found))
    # The most important one alone: with it, the others may no longer matter.
    for name, found in sorted(missed, key=lambda pair: -pair[1].tip_m):
        more = EffectEscalation.of(selection, [name], found.reason, found.time_s)
        if more is not None:
            return more
    return None
