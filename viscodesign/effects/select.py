"""Which effects a scene calls for, and why.

A sketch with everything that the spec allows is compared with sketches that lack one
effect each. What moves the tip least is left out first, as long as all that is left
out together may move it by no more than a part of the accuracy asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache, cached_property

from viscodesign import effects
from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.plugins import members
from viscodesign.results.findings import Verdict

SHARE_OF_ACCURACY = 0.35
"""Part of the accuracy that all omitted effects together may spend, by the sketches."""
OMISSIONS_SURE = 2.5
"""By how much the stated error of omissions exceeds the sketches' distance: over a hundred
scenes the measured one was below that in 95 % (`benchmarks/results/error_study.md`)."""

UNSEEN = 0.005
"""Part of the accuracy that is stated at least where anything was left out: sketches do not
see how one small effect changes another. Chosen to cover what they were seen to miss."""
PASSES = 3
MOST_BELLOWS_SKETCHED = 96
"""Bellows beyond which a sketch would take too long: then weights alone decide."""
FAR_TOO_MUCH = 10.0

Names = frozenset[str]


@cache
def catalogue() -> dict[str, type[Effect]]:
    """Every effect of this version by name, in the order of telling and joining."""
    return members(effects.__name__, Effect)  # type: ignore[type-abstract]


def effect_names() -> tuple[str, ...]:
    """Names that a spec may switch."""
    return tuple(name for name, kind in catalogue().items() if kind.switchable)


def select_effects(quantities: SceneQuantities) -> Selection:
    """The effects to join, and a verdict for every one of the catalogue."""
    choice = _Choice(quantities)
    taken = choice.taken()
    verdicts = tuple(choice.verdict(name, taken) for name in choice.effects)
    return Selection(choice, taken, verdicts)


class Selection:
    """The effects that were chosen for a scene, and why."""

    def __init__(self, choice: _Choice, taken: Names, verdicts: tuple[Verdict, ...]) -> None:
        self._choice = choice
        self._taken = taken
        self.verdicts = verdicts

    @property
    def effects(self) -> list[Effect]:
        """Those to join, in order."""
        return self.members(self._taken)

    @property
    def taken(self) -> Names:
        """Their names."""
        return self._taken

    @property
    def everything(self) -> Names:
        """Names of all effects that the spec does not forbid and that act on something."""
        return self._choice.everything

    @property
    def omitted_m(self) -> float:
        """How far the tip may move when all that was left out by choice is taken in [m]."""
        if self._taken == self._choice.everything:
            return 0.0
        seen = self._choice.distance(self._choice.everything, self._taken)
        return max(OMISSIONS_SURE * seen, UNSEEN * self._choice.budget)

    @property
    def present(self) -> set[str]:
        """Names of the effects that the scene has something for."""
        return self._choice.present

    @property
    def provable(self) -> list[str]:
        """Names of the effects that change something when they are switched alone."""
        return [
            v.name
            for v in self.verdicts
            if v.present and self._choice.acts_alone(v.name, self._taken)
        ]

    def switched(self, name: str) -> list[Effect]:
        """The same with one effect switched, and with what it needs or what needs it."""
        return self.members(self._choice.flipped(self._taken, name))

    @property
    def spared(self) -> list[Effect]:
        """Those left out by choice, though the spec allows them."""
        return self.members(self._choice.everything - self._taken)

    def grown(self, name: str, why: str) -> Selection | None:
        """The same with one effect more, what comes along and what then costs nothing.

        None where that is forbidden, or nothing new.
        """
        taken = self.turned({name: True})
        if taken is None or taken == self._taken:
            return None
        free = {n: True for n in self._choice.free(taken)}
        taken = self._choice.turned(taken, free) or taken
        verdicts = tuple(
            replace(v, taken=True, reason=f"taken, since {why}")
            if v.name in taken - self._taken
            else v
            for v in self.verdicts
        )
        return Selection(self._choice, taken, verdicts)

    def turned(self, wanted: Mapping[str, bool]) -> Names | None:
        """What was taken, with effects turned on or off; None where they may not be."""
        return self._choice.turned(self._taken, wanted)

    def members(self, names: Names) -> list[Effect]:
        """Effects by their names, in order."""
        return [effect for name, effect in self._choice.effects.items() if name in names]


class _Choice:
    """Effects of one scene, and what a sketch says of leaving each of them out."""

    def __init__(self, quantities: SceneQuantities) -> None:
        self.quantities = quantities
        self.effects = {name: kind.of(quantities) for name, kind in catalogue().items()}
        self.present = {n for n, e in self.effects.items() if e.present(quantities)}
        self.budget = quantities.accuracy * quantities.body.length
        self._sketches: dict[Names, Sketch] = {}

    def mode(self, name: str) -> str:
        """What the spec says."""
        effect, choice = self.effects[name], self.quantities.scene.effects
        if not effect.switchable:
            return "on"
        needing = [n for n, e in self.effects.items() if e.needs == name]
        mode, asked = choice.mode(name), any(choice.modes.get(n) == "on" for n in needing)
        # `others: off` does not mean what one asked for by name needs.
        return "on" if mode == "off" and asked and name not in choice.modes else mode

    # -- sets of effects ------------------------------------------------------

    def without(self, names: Names, name: str) -> Names:
        """A set less one effect, and less those that need it."""
        return frozenset(n for n in names if n != name and self.effects[n].needs != name)

    def with_(self, names: Names, name: str) -> Names:
        """A set with one effect more, and with what it needs and what comes along."""
        needed = self.effects[name].needs
        more = {name} if needed is None else {name, needed}
        along = {self.effects[n].companion for n in more - names} - {None}
        return names | more | {n for n in along if n in self.present and self.mode(n) != "off"}

    def flipped(self, names: Names, name: str) -> Names:
        """A set with one effect switched."""
        return self.without(names, name) if name in names else self.with_(names, name)

    def turned(self, names: Names, wanted: Mapping[str, bool]) -> Names | None:
        """A set with effects turned on or off; None where spec or scene forbid it."""
        for name, on in wanted.items():
            if on and name not in names:
                if name not in self.everything:
                    return None
                names = self.with_(names, name)
            elif not on and name in names:
                if name in self._kept(names):
                    return None
                names = self._reduced(names, name)
        return names

    def _reduced(self, names: Names, name: str) -> Names:
        """A set without an effect, and without what only came along with it."""
        left, companion = self.without(names, name), self.effects[name].companion
        led = any(self.effects[n].companion == companion for n in left)
        if companion is None or led or companion in self._kept(left):
            return left
        return self.without(left, companion)

    @cached_property
    def everything(self) -> Names:
        """Everything that the spec does not forbid and that acts on something."""
        allowed = {n for n in self.present if self.mode(n) != "off"}
        gone = {n for n in allowed if (needed := self.effects[n].needs) and needed not in allowed}
        return frozenset(allowed - gone)

    def _leads(self, name: str) -> bool:
        """Whether it follows no other effect, whose omission might change what it does."""
        followed = {e.companion for e in self.effects.values()}
        return self.effects[name].needs is None and name not in followed

    def free(self, names: Names) -> Names:
        """What could be added to a set at no cost."""
        return frozenset(n for n in self.everything - names if self._is_free(n, names))

    def _is_free(self, name: str, names: Names) -> bool:
        return self.effects[name].free_with in names

    def _kept(self, names: Names) -> set[str]:
        """Effects that stay whatever the sketch says, and what they need."""
        own = {
            n
            for n in names
            if self.mode(n) == "on" or self.effects[n].indispensable(self.quantities)
        }
        return own | {needed for n in own if (needed := self.effects[n].needs) is not None}

    # -- what a sketch says ---------------------------------------------------

    def _sketch(self, names: Names) -> Sketch:
        if names not in self._sketches:
            sketch = self.quantities.bare_sketch
            for name in self.effects:
                if name in names:
                    sketch = self.effects[name].sketch(sketch) or sketch
            self._sketches[names] = sketch
        return self._sketches[names]

    def distance(self, one: Names, other: Names) -> float:
        """How far the tip moves from one set of effects to another [m].

        What a sketch cannot show counts by its weight.
        """
        if one == other:
            return 0.0
        blank, too_large = self.quantities.bare_sketch, self._is_too_large()
        unseen = [n for n in one ^ other if too_large or self.effects[n].sketch(blank) is None]
        guess = sum(self._guess(n, one | other) for n in unseen)
        return guess if too_large else self._sketch(one).distance(self._sketch(other)) + guess

    def _guess(self, name: str, names: Names) -> float:
        """What the weight alone says that an effect among others may do to the tip [m]."""
        leads = [n for n, e in self.effects.items() if e.companion == name]
        if leads and not names & set(leads):
            return 0.0  # alone it has nothing to accompany
        weight = self.effects[name].weight(self.quantities)
        return min(weight, 1.0) * self.quantities.body.length

    def _is_too_large(self) -> bool:
        return len(self.quantities.graph.bellows) > MOST_BELLOWS_SKETCHED

    def taken(self) -> Names:
        """The fewest effects whose omissions fit into the share of the accuracy."""
        everything = self.everything
        names, spent = everything, 0.0
        # What one effect does may depend on another that a first pass leaves out.
        kept = self._kept(everything)
        for _ in range(PASSES):
            before = names
            names, spent = self._thinned(everything, names, spent, kept)
            if names == before:
                break
        return names

    def _thinned(
        self, everything: Names, names: Names, spent: float, kept: set[str]
    ) -> tuple[Names, float]:
        """Leave out what still fits, least first; and what all omissions then may do [m].

        ``kept`` gains what does far too much ever to be left out.
        """
        share = SHARE_OF_ACCURACY * self.budget
        # In the catalogue's order, so that equal costs are always met in the same one.
        loose = [n for n in self.effects if n in names and n not in kept]
        cost = {n: self.distance(names, self.without(names, n)) for n in loose}
        kept |= {n for n, moved in cost.items() if moved > FAR_TOO_MUCH * share and self._leads(n)}
        left: list[str] = []
        for name in sorted(cost, key=lambda n: cost[n]):
            if spent + cost[name] <= share and not self._is_free(name, names):
                left.append(name)
                spent += cost[name]
        # Omissions may add up to more than each does alone: then the last is taken back.
        while left and self.distance(everything, self._without_all(names, left)) > share:
            spent -= cost[left.pop()]
        return self._without_all(names, left), spent

    def _without_all(self, names: Names, left: list[str]) -> Names:
        for name in left:
            names = self.without(names, name)
        return names

    # -- verdicts -------------------------------------------------------------

    def acts_alone(self, name: str, taken: Names) -> bool:
        """Whether it has something to act on in a set of effects."""
        needed = self.effects[name].needs
        return needed is None or needed in taken

    def verdict(self, name: str, taken: Names) -> Verdict:
        """What is told of one effect."""
        effect, present = self.effects[name], name in self.present
        alone = present and self.acts_alone(name, taken)
        contribution = self.distance(taken, self.flipped(taken, name)) if alone else 0.0
        return Verdict(
            name=name,
            mode=self.mode(name),  # type: ignore[arg-type]
            taken=name in taken,
            weight=effect.weight(self.quantities) if present else 0.0,
            formula=effect.formula,
            reason=self._sentence(name, taken, contribution),
            contribution_m=contribution,
            budget_share=contribution / self.budget,
            present=present,
        )

    def _sentence(self, name: str, taken: Names, contribution: float) -> str:
        effect, reason = self.effects[name], self.effects[name].reason(self.quantities)
        if name not in self.present:
            return f"absent: {reason}"
        if not self.acts_alone(name, taken):
            return f"left out with {effect.needs}, without which it acts on nothing; {reason}"
        mode = self.mode(name)
        if mode != "auto":
            return f"{'taken' if mode == 'on' else 'left out'} as the spec says; {reason}"
        moves = f"{1e3 * contribution:.3g} mm, {_share(contribution / self.budget)}"
        if name not in taken:
            return f"left out: it moves the tip by about {moves}; {reason}"
        if effect.indispensable(self.quantities):
            return f"taken, the scene has no sense without it: {reason}"
        if self._is_free(name, taken):
            return f"taken, since it costs nothing beside {effect.free_with}: {moves}; {reason}"
        return f"taken: it moves the tip by about {moves}; {reason}"


def _share(share: float) -> str:
    """A part of the accuracy asked for, or a multiple of it."""
    if share < 1.0:
        return f"{100 * share:.2g} % of the accuracy"
    return f"{share:.3g} times the accuracy"
