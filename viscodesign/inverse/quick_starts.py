"""Numbers that a quick search begins with: the scene's own, and others by chance."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.inverse.quick_fit import QUICK_EVALUATIONS, QuickCandidate, QuickFit
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class QuickStartRules:
    """How many starts are drawn, and how many of them are tried."""

    sizings: int = 3
    most_sizing: float = 10.0
    """Times that a start is sized by the path, and by how much at most each time."""
    quick_draws: int = 80
    quick_starts: int = 16
    same_optimum: float = 1.01
    enough_times: int = 4
    """Fits that come as near as the best, and how many of them end the quick search."""
    full_designs: int = 3
    """Fits that go on to the scene's own model."""


RULES = QuickStartRules()


class QuickStarts:
    """Starts of a task, and the best fits of its own graph from them."""

    def __init__(self, fit: QuickFit) -> None:
        self._fit = fit

    def fitted(self) -> list[QuickCandidate]:
        """Fits from several starts: one harmonic of many sizes and periods, and chance."""
        found: list[QuickCandidate] = []
        first, *drawn = self.drawn(RULES.quick_draws)
        drawn.sort(key=lambda start: self._fit.cost(self._fit.own, start))
        for start in [*drawn[:2], first, *drawn[2 : RULES.quick_starts]]:
            if found and (self._are_enough(found) or self._fit.is_over):
                break
            try:
                found.append(self._fit.fitted(self._fit.own, start, QUICK_EVALUATIONS))
            except KeyboardInterrupt:
                break
            self._fit.task.report()
        return _distinct(found)[: RULES.full_designs]

    def _are_enough(self, found: list[QuickCandidate]) -> bool:
        """Whether one is near, or several are as near as the best."""
        best = min(one.away_m for one in found)
        again = sum(one.away_m < RULES.same_optimum * best for one in found)
        return best < 0.3 * self._fit.task.tolerance_m or again >= RULES.enough_times

    def drawn(self, count: int) -> Iterator[np.ndarray]:
        """The scene's own numbers, then others by chance: high harmonics are small."""
        assert self._fit.ranges is not None
        ranges, numbers = self._fit.ranges, self._fit.keys.numbers
        drawn = ranges.starts(self._fit.keys.values, count, self._fit.task.seed)
        yield drawn[0]
        for own in drawn[1:]:
            found = own.copy()
            for k, number in enumerate(numbers):
                if number.path[0] == "input" and number.path[1] in ("cosine", "sine"):
                    found[k] *= 0.8 / (1 + int(number.path[2])) ** 2
                if number.path == ("input", "mean"):
                    found[k] = self._mean_pressure
            yield found if self._fit.limits is None else self._sized(found)

    def _sized(self, values: np.ndarray) -> np.ndarray:
        """Numbers whose input keeps its limits and moves the tip as far as the path is long."""
        assert self._fit.limits is not None
        motion, found = self._fit.motion(self._fit.own), self._fit.limits.within(values)
        amplitudes = [
            k for k, own in enumerate(self._fit.keys.numbers) if own.path[1] in ("cosine", "sine")
        ]
        for _ in range(RULES.sizings):
            tip = motion.tip(found)
            way = np.linalg.norm(np.diff(tip, axis=0, append=tip[:1]), axis=1).sum()
            found[amplitudes] *= min(
                self._fit.wanted.length / max(float(way), 1e-9), RULES.most_sizing
            )
            found = self._fit.limits.within(found)
        return found

    @property
    def _mean_pressure(self) -> float:
        """That of a straight rod as long as the path is high in the mean [Pa]."""
        assert self._fit.task.choice.harmonics is not None
        rod = ArcRod.of(SceneQuantities(self._fit.base))
        length = self._fit.base.actuator.length
        height = float(self._fit.wanted.points[:, 1].mean())
        level = (height / length - 1) / (2 * rod.stretch) - self._fit.base.gauge_pressure
        return float(np.clip(level, *self._fit.task.choice.harmonics.limits))


def _distinct(found: list[QuickCandidate]) -> list[QuickCandidate]:
    """Candidates by their distance, without those that are as far and as large as another."""
    kept: list[QuickCandidate] = []
    for one in sorted(found, key=lambda one: one.away_m):
        if all(not np.allclose(one.values, other.values, rtol=0.02) for other in kept):
            kept.append(one)
    return kept
