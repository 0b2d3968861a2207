"""How far the tip moves from one set of effects to another, by quick estimates."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from viscodesign.effects.allowed_sets import AllowedSets, Names
from viscodesign.estimate.motion_estimate import MotionEstimate, tip_distance, tips
from viscodesign.estimate.setting import PIECES
from viscodesign.estimate.term import EstimateTerm
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache

MAX_BELLOWS_ESTIMATED = 96
"""Bellows beyond which an estimate would take too long: then weights alone decide."""

NUMBERS_AT_ONCE = 45_000
"""Numbers in an array of estimates side by side: a larger one leaves the fast caches."""


_distances: LruCache[dict[frozenset[Names], float]] = LruCache(64)
"""Those found so far for the latest scenes."""


class TipDisplacements:
    """Distances between the estimated motions of a scene with different effects."""

    def __init__(self, sets: AllowedSets) -> None:
        self._sets = sets
        self._quantities = sets.quantities
        self._tips: dict[Names, np.ndarray] = {}
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

    def prepare(self, names: Names, others: Iterable[Names]) -> None:
        """Estimate all motions whose distances from that of a set are not known yet."""
        unknown = [o for o in others if o != names and frozenset((names, o)) not in self._known]
        if unknown:
            self._estimate([names, *unknown])

    def _estimate(self, sets: Iterable[Names]) -> None:
        """Estimate the motions with these sets, those that are not known yet side by side."""
        new = [names for names in dict.fromkeys(sets) if names not in self._tips]
        if not new or self.are_weights:
            return
        setting = self._quantities.bare_estimate.setting
        count = max(1, NUMBERS_AT_ONCE // (len(setting.time) * max(setting.bellows, PIECES)))
        for begin in range(0, len(new), count):
            some = new[begin : begin + count]
            self._tips.update(zip(some, tips([self._of(names) for names in some]), strict=True))

    def _estimated(self, one: Names, other: Names) -> float:
        unseen = [n for n in one ^ other if self.are_weights or self._terms[n] is None]
        guess = sum(self._by_weight(n, one | other) for n in unseen)
        if self.are_weights:
            return guess
        self._estimate([one, other])
        setting = self._quantities.bare_estimate.setting
        return tip_distance(setting, self._tips[one], self._tips[other]) + guess

    @property
    def are_weights(self) -> bool:
        """Whether the weights of effects stand for displacements: no motion is estimated.

        So it is of a scene that is too large for that, or has several rods.
        """
        is_large = len(self._quantities.graph.bellows) > MAX_BELLOWS_ESTIMATED
        return is_large or bool(self._quantities.body.members)

    def _of(self, names: Names) -> MotionEstimate:
        """The estimate with these effects."""
        own = [term for n, term in self._terms.items() if n in names and term is not None]
        return self._quantities.bare_estimate.plus(*own)

    def _by_weight(self, name: str, names: Names) -> float:
        """What the weight alone says that an effect among others may do to the tip [m]."""
        leaders = [n for n, e in self._sets.effects.items() if e.companion == name]
        if leaders and not names & set(leaders):
            return 0.0  # a companion of nothing
        weight = self._sets.effects[name].weight(self._quantities)
        return min(weight, 1.0) * self._quantities.body.length
