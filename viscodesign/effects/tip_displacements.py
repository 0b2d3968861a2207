"""How far the tip moves from one set of effects to another, by quick estimates."""

from __future__ import annotations

from viscodesign.effects.allowed_sets import AllowedSets, Names
from viscodesign.estimate.motion_estimate import MotionEstimate
from viscodesign.estimate.term import EstimateTerm
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache

MOST_BELLOWS_ESTIMATED = 96
"""Bellows beyond which an estimate would take too long: then weights alone decide."""


_distances: LruCache[dict[frozenset[Names], float]] = LruCache(64)
"""Those found so far for the latest scenes."""


class TipDisplacements:
    """Distances between the estimated motions of a scene with different effects."""

    def __init__(self, sets: AllowedSets) -> None:
        self._sets = sets
        self._quantities = sets.quantities
        self._estimates: dict[Names, MotionEstimate] = {}
        self._known: dict[frozenset[Names], float] = _distances.get(sets.key, dict)

    @cached_property
    def _terms(self) -> dict[str, EstimateTerm | None]:
        return {name: effect.estimate_term() for name, effect in self._sets.effects.items()}

    def between(self, one: Names, other: Names) -> float:
        """Largest distance of the two tips [m].

        An effect without a term in the estimate counts by its weight.
        """
        if one == other:
            return 0.0
        pair = frozenset((one, other))
        if pair not in self._known:
            self._known[pair] = self._estimated(one, other)
        return self._known[pair]

    def _estimated(self, one: Names, other: Names) -> float:
        too_large = len(self._quantities.graph.bellows) > MOST_BELLOWS_ESTIMATED
        unseen = [n for n in one ^ other if too_large or self._terms[n] is None]
        guess = sum(self._by_weight(n, one | other) for n in unseen)
        return guess if too_large else self._of(one).distance(self._of(other)) + guess

    def _of(self, names: Names) -> MotionEstimate:
        """The estimate with these effects."""
        if names not in self._estimates:
            own = [term for n, term in self._terms.items() if n in names and term is not None]
            self._estimates[names] = self._quantities.bare_estimate.plus(*own)
        return self._estimates[names]

    def _by_weight(self, name: str, names: Names) -> float:
        """What the weight alone says that an effect among others may do to the tip [m]."""
        leaders = [n for n, e in self._sets.effects.items() if e.companion == name]
        if leaders and not names & set(leaders):
            return 0.0  # a companion of nothing
        weight = self._sets.effects[name].weight(self._quantities)
        return min(weight, 1.0) * self._quantities.body.length
