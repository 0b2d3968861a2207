"""Which effects a scene calls for, and why.

An estimate of the motion with everything that the spec allows is compared with estimates
that lack one effect each. The effect that moves the tip least is neglected first, as long as
all neglected effects together may move it by no more than a part of the requested accuracy.
Only where that leaves out one that others follow, these are weighed again.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from viscodesign.effects.allowed_sets import AllowedSets, Names
from viscodesign.effects.base import Effect
from viscodesign.effects.tip_displacements import TipDisplacements
from viscodesign.effects.verdicts import verdict
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Verdict
from viscodesign.storage.lru_cache import LruCache


@dataclass(frozen=True)
class SelectionNumbers:
    """How much may be neglected, and how neglecting is judged."""

    accuracy_share: float = 0.35
    """Part of the accuracy that all neglected effects together may spend, by the estimates."""
    stated_per_estimated: float = 2.5
    """Stated error of neglected effects over the estimates' distance: over a hundred scenes the
    measured one was below it in 95 % (`benchmarks/results/error_study.md`)."""
    least_stated: float = 0.005
    """Part of the accuracy that is stated at least where anything was neglected: estimates do not
    see how one small effect changes another. Chosen to cover what they were seen to miss."""
    passes: int = 3
    always_kept: float = 10.0
    """Displacement, relative to what may be spent, from which an effect is never neglected."""


NUMBERS = SelectionNumbers()


def select_effects(quantities: SceneQuantities) -> Selection:
    """The effects to join, and a verdict for every one of the catalogue."""
    sets = AllowedSets(quantities)
    displacements = TipDisplacements(sets)

    def choice() -> tuple[Names, tuple[Verdict, ...]]:
        active, weighed = _fewest(sets, displacements)
        acting = [n for n in sets.effects if n in sets.present and sets.acts_in(n, active)]
        flipped = {n: sets.flipped(active, n) for n in acting if n not in weighed}
        displacements.prepare(active, flipped.values())
        moved = {n: displacements.between(active, other) for n, other in flipped.items()}
        moved |= {n: weighed[n] for n in acting if n in weighed}
        by_weight = displacements.are_weights
        return active, tuple(
            verdict(sets, n, active, moved.get(n, 0.0), by_weight=by_weight) for n in sets.effects
        )

    return Selection(sets, displacements, *_choices.get(sets.key, choice))


_choices: LruCache[tuple[Names, tuple[Verdict, ...]]] = LruCache(64)
"""What was chosen for the latest scenes, and why."""


@dataclass(frozen=True)
class Selection:
    """The effects that were chosen for a scene, and why."""

    sets: AllowedSets
    displacements: TipDisplacements
    active: Names
    """Names of those to join."""
    verdicts: tuple[Verdict, ...]

    @property
    def effects(self) -> list[Effect]:
        """Those to join, in order."""
        return self.members(self.active)

    @property
    def everything(self) -> Names:
        """Names of all effects that the spec does not forbid and that act on something."""
        return self.sets.everything

    @property
    def neglected(self) -> list[Effect]:
        """Those that the spec allows and that were not chosen."""
        return self.members(self.everything - self.active)

    @property
    def estimated_m(self) -> float:
        """How far the tip moves with all neglected effects included, by the estimates [m]."""
        return self.displacements.between(self.everything, self.active)

    @property
    def neglected_m(self) -> float:
        """What is stated of that where it is not measured [m]."""
        return self.stated(NUMBERS.stated_per_estimated * self.estimated_m)

    def stated(self, omitted_m: float) -> float:
        """What is stated where neglected effects do so much [m]."""
        if self.active == self.everything:
            return 0.0
        return max(omitted_m, NUMBERS.least_stated * self.sets.quantities.requested_m)

    @property
    def measurable(self) -> list[str]:
        """Names of the effects that change something when they are switched alone."""
        acting = (v.name for v in self.verdicts if v.present)
        return [name for name in acting if self.sets.acts_in(name, self.active)]

    def switched_m(self, name: str) -> float:
        """How far the tip moves with one effect switched, by the estimates [m].

        In the chosen set, unlike the verdict's, which is from where the effect was weighed last.
        """
        return self.displacements.between(self.active, self.sets.flipped(self.active, name))

    def with_flipped(self, name: str) -> list[Effect]:
        """The effects with one switched, and with what it needs or what needs it."""
        return self.members(self.sets.flipped(self.active, name))

    def grown(self, names: Iterable[str], why: str) -> Selection | None:
        """The selection with more effects, their companions and what then costs nothing.

        None where that is forbidden, or nothing new.
        """
        active = self.switched(dict.fromkeys(names, True))
        if active is None or active == self.active:
            return None
        active = self.sets.with_free(active)
        found = replace(self, active=active)
        verdicts = tuple(
            found._included(v, why) if v.name in active - self.active else v for v in self.verdicts
        )
        return replace(found, verdicts=verdicts)

    def _included(self, before: Verdict, why: str) -> Verdict:
        """The verdict on an effect that a run called for, as it is in this set."""
        moved_m = self.switched_m(before.name)
        share, reason = moved_m / self.sets.quantities.requested_m, f"included: {why}"
        return replace(
            before, taken=True, reason=reason, contribution_m=moved_m, budget_share=share
        )

    def switched(self, wanted: Mapping[str, bool]) -> Names | None:
        """What is active with effects switched on or off; None where that is not allowed."""
        return self.sets.switched(self.active, wanted)

    def members(self, names: Names) -> list[Effect]:
        """Effects by their names, in order."""
        return self.sets.members(names)


def _fewest(sets: AllowedSets, displacements: TipDisplacements) -> tuple[Names, dict[str, float]]:
    """The fewest effects whose omissions fit into their part of the accuracy.

    And how far each of those that may be neglected moves the tip, as last weighed [m].
    """
    share = NUMBERS.accuracy_share * sets.quantities.requested_m
    names, spent = sets.everything, 0.0
    required, weighed = sets.kept(names), dict[str, float]()
    dominant: set[str] = set()
    for _ in range(NUMBERS.passes):
        before = names
        # In the catalogue's order, so that equal costs are always met in the same one.
        loose = [n for n in sets.effects if n in names - required - dominant]
        flipped = {n: sets.without(names, n) for n in loose}
        displacements.prepare(names, flipped.values())
        cost = {n: displacements.between(names, flipped[n]) for n in loose}
        weighed |= cost
        most = NUMBERS.always_kept * share
        dominant |= {n for n in loose if cost[n] > most and sets.leads(n)}
        names, spent = _thinned(sets, displacements, names, spent, cost, share)
        # Without inertia, damping may do nothing: those that follow are weighed again.
        if not any(sets.is_followed(n, names) for n in before - names):
            break
    return names, weighed


def _thinned(
    sets: AllowedSets,
    displacements: TipDisplacements,
    names: Names,
    spent: float,
    cost: dict[str, float],
    share: float,
) -> tuple[Names, float]:
    """Neglect what still fits, least first; returns the rest, and what all omissions may do [m]."""
    neglected: list[str] = []
    for name in sorted(cost, key=lambda n: cost[n]):
        if spent + cost[name] <= share and not sets.costs_nothing(name, names):
            neglected.append(name)
            spent += cost[name]
    # Omissions may add up to more than each does alone: then the last is taken back.
    while neglected:
        if displacements.between(sets.everything, sets.without(names, *neglected)) <= share:
            break
        spent -= cost[neglected.pop()]
    return sets.without(names, *neglected), spent
