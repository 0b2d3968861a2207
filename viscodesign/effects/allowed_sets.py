"""Which sets of effects a scene and its spec allow."""

from __future__ import annotations

from collections.abc import Hashable, Mapping

from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import every_effect
from viscodesign.effects.effects_key import effects_key
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.storage.cached_property import cached_property

Names = frozenset[str]


class AllowedSets:
    """The effects of one scene, and the ties between them.

    An effect goes with what it needs, and brings its companion; what the spec or the scene
    requires stays.
    """

    def __init__(self, quantities: SceneQuantities) -> None:
        self.quantities = quantities
        self.effects = every_effect(quantities)
        own = {n for n, e in self.effects.items() if e.present(quantities)}
        self.present = {n for n in own if not self._is_replaced(n, own)}
        """Names of the effects that the scene has something for."""

    @cached_property
    def key(self) -> Hashable:
        """All that the choice among them depends on: every key of the scene, and the effects."""
        return effects_key(self.quantities, self.effects.values())

    def _is_replaced(self, name: str, present: set[str]) -> bool:
        other = self.effects[name].replaced_by
        return other in present and self.mode(other) != "off"

    def mode(self, name: str) -> str:
        """The effect's mode: that of the spec, or what follows from it."""
        effect, choice = self.effects[name], self.quantities.scene.effects
        needing = [n for n, e in self.effects.items() if name in e.needs]
        mode = effect.mode_in(choice)
        requested = any(choice.modes.get(n) == "on" for n in needing)
        # `others: off` does not apply to what an effect that is named `on` needs.
        return "on" if mode == "off" and requested and name not in choice.modes else mode

    @cached_property
    def everything(self) -> Names:
        """Names of all effects that the spec does not forbid and that act on something."""
        allowed = {n for n in self.present if self.mode(n) != "off"}
        gone = {n for n in allowed if not allowed.issuperset(self.effects[n].needs)}
        return frozenset(allowed - gone)

    # -- one effect more or less ------------------------------------------------

    def without(self, names: Names, *removed: str) -> Names:
        """A set less some effects, and less those that need them."""
        for name in removed:
            names = frozenset(n for n in names if n != name and name not in self.effects[n].needs)
        return names

    def with_(self, names: Names, name: str) -> Names:
        """A set with one effect more, with what it needs and with its companions."""
        more = {name, *self.effects[name].needs}
        companions = {self.effects[n].companion for n in more - names} - {None}
        allowed = {n for n in companions if n in self.present and self.mode(n) != "off"}
        return names | more | allowed

    def flipped(self, names: Names, name: str) -> Names:
        """A set with one effect switched."""
        return self.without(names, name) if name in names else self.with_(names, name)

    def switched(self, names: Names, wanted: Mapping[str, bool]) -> Names | None:
        """A set with effects switched on or off; None where spec or scene forbid it."""
        for name, on in wanted.items():
            if on and name not in names:
                if name not in self.everything:
                    return None
                names = self.with_(names, name)
            elif not on and name in names:
                if name in self.kept(names):
                    return None
                names = self._without_companion(names, name)
        return names

    def _without_companion(self, names: Names, name: str) -> Names:
        """A set without an effect, and without what was only included as its companion."""
        remaining, companion = self.without(names, name), self.effects[name].companion
        is_shared = any(self.effects[n].companion == companion for n in remaining)
        if companion is None or is_shared or companion in self.kept(remaining):
            return remaining
        return self.without(remaining, companion)

    # -- ties ---------------------------------------------------------------------

    def kept(self, names: Names) -> set[str]:
        """Effects of a set that stay whatever an estimate says, and what they need."""
        own = {
            n
            for n in names
            if self.mode(n) == "on" or self.effects[n].indispensable(self.quantities)
        }
        return own | {needed for n in own for needed in self.effects[n].needs}

    def leads(self, name: str) -> bool:
        """Whether it follows no other effect, whose omission might change what it does."""
        companions = {e.companion for e in self.effects.values()}
        return not self.effects[name].needs and name not in companions

    def is_followed(self, name: str, names: Names) -> bool:
        """Whether what effects of a set do, or cost, depends on one that it lacks."""
        companion = self.effects[name].companion
        return companion in names or any(self.effects[n].free_with == name for n in names)

    def acts_in(self, name: str, names: Names) -> bool:
        """Whether it has something to act on in a set of effects."""
        return names.issuperset(self.effects[name].needs)

    def costs_nothing(self, name: str, names: Names) -> bool:
        """Whether the equations of a set become no harder with it."""
        return self.effects[name].free_with in names

    def with_free(self, names: Names) -> Names:
        """A set with all that it can have at no cost."""
        free = {n: True for n in self.everything - names if self.costs_nothing(n, names)}
        return self.switched(names, free) or names

    def members(self, names: Names) -> list[Effect]:
        """Effects by their names, in order."""
        return [effect for name, effect in self.effects.items() if name in names]
