"""Designs over graphs and starts: ranked by the quick motion, fitted on the scene's own model.

Few graphs are all tried; of many, the best are changed at random and fitted again, each from the
numbers of the one that it came from. The best of them go on to the scene's own model.
"""

from __future__ import annotations

import itertools
import random
import time as clock
from collections.abc import Iterator

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.exploration.least_squares import SearchLimits, least_squares
from viscodesign.inverse.number_search import NumberDesign, limits_of, search_numbers
from viscodesign.inverse.quick_motion import ArcRod, QuickMotion
from viscodesign.inverse.search_task import SearchTask
from viscodesign.inverse.tip_residuals import PathResiduals, distance
from viscodesign.inverse.tree_changes import changed_chain, changed_tree
from viscodesign.inverse.tree_graph import (
    INLET,
    TreeGraph,
    chain,
    mirrored,
    sizes_of,
    straight,
    tree,
    tree_of,
    with_tree,
)
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene

LENGTHS = ["network.tubes[*].length"]
FEW_GRAPHS = 800
"""Graphs that are all tried."""
QUICK_SHARE = 0.45
"""Of the budget, that ranking may take."""
RANKED = 40
"""Graphs whose numbers are fitted quickly after all were tried."""
QUICK_EVALUATIONS = 40
CHANGE_EVALUATIONS = 15
MORE_CHANGES, MOST_MORE_CHANGES = 0.25, 4
"""Chance of one more change at once, and how many more there may be."""
MOST_CHANGES, MOST_PLAIN_CHANGES = 1500, 20_000
"""Of graphs whose numbers are fitted, and of such as have none that are free."""
ELITE, PLAIN_ELITE = 8, 24
"""Graphs that are changed, the best the most: with numbers that are fitted, and without."""
SIZINGS, MOST_SIZING = 3, 10.0
"""Times that a start is sized by the path, and by how much at most each time."""
QUICK_MET = 0.25
"""Of the tolerance, at which the quick motion is near enough."""
QUICK_DRAWS, QUICK_STARTS = 80, 16
SAME_OPTIMUM, ENOUGH_TIMES = 1.01, 4
"""Fits that come as near as the best, and how many of them end the quick search."""
FULL_DESIGNS, FULL_GRAPHS = 3, 6
"""Candidates that go on to the scene's own model: of one graph, of several."""
DIFFERENT = 1.5
"""Times the tolerance, from which a quick distance is not worth a solution if others are near."""


@dataclass(frozen=True, eq=False)
class QuickCandidate:
    """A graph, its numbers, and how near its quick motion comes."""

    graph: TreeGraph
    values: np.ndarray
    away_m: float
    """Root mean square distance both ways, that back beyond the tolerance [m]."""


def search_designs(task: SearchTask, scene: Scene) -> list[NumberDesign]:
    """Designs of a posed scene, the best first."""
    own = tree_of(scene.graph)
    is_quick = task.choice.graph != "keep" or task.choice.harmonics is not None
    if not is_quick or (task.choice.graph == "keep" and own is None):
        return search_numbers(task, scene)
    quick = QuickSearch(task, scene, own)
    found: list[NumberDesign] = []
    error: SolveError | None = None
    candidates = quick.candidates()
    if not candidates:
        raise KeyboardInterrupt
    task.log.quick_m = candidates[0].away_m
    if task.stop.asked:
        return [quick.unsolved(candidates[0])]
    for candidate in candidates:
        try:
            found += search_numbers(
                task,
                quick.scene_of(candidate.graph),
                start=candidate.values if len(candidate.values) else None,
                several_starts=False,
                graph=candidate.graph.words(quick.sections) if quick.is_graph_free else "",
            )
        except SolveError as one:
            error = one
        if task.is_over or _is_enough(task, found):
            break
    if not found:
        raise error or KeyboardInterrupt
    return sorted(found, key=lambda one: one.distance.total_m)


def _is_enough(task: SearchTask, found: list[NumberDesign]) -> bool:
    share = 0.1 if not task.choice.ranges else 0.7
    return bool(found) and min(d.distance.total_m for d in found) < share * task.tolerance_m


class QuickSearch:
    """Graphs and starts of a task, ranked by the quick motion."""

    def __init__(self, task: SearchTask, scene: Scene, own: TreeGraph | None) -> None:
        self._task, self._wanted = task, task.wanted.coarser
        self.sections = scene.bellows.count // 2
        self.is_graph_free = task.choice.graph != "keep"
        self._own = own or straight(self.sections)
        self._sizes = sizes_of(scene, scene.bellows.count)
        self._base = with_tree(scene.replace({"network.feed_line": None}), self._own, self._sizes)
        self._scene = scene
        numbers = task.choice.numbers(self._base)
        self._keys = FreeKeys(self._base, LENGTHS) if numbers is None else numbers[0]
        self._ranges = None if numbers is None else numbers[1]
        self._limits = None if numbers is None else limits_of(task, self._keys)
        self._random = random.Random(task.seed)
        self._slots = {
            int(number.path[2]): k
            for k, number in enumerate(self._keys.numbers)
            if number.path[:2] == ("network", "tubes") and number.path[-1] == "length"
        }
        """Place of each tube's length among the numbers, by the tube."""

    def scene_of(self, graph: TreeGraph) -> Scene:
        """The scene with a graph."""
        if not self.is_graph_free:
            return self._scene
        return with_tree(self._scene, graph, self._sizes)

    def unsolved(self, candidate: QuickCandidate) -> NumberDesign:
        """A candidate as it is, where the search was interrupted before a solution."""
        scene = self.scene_of(candidate.graph)
        numbers = self._task.choice.numbers(scene)
        names: tuple[str, ...] = ()
        units: tuple[str, ...] = ()
        if numbers is not None:
            keys, _ = numbers
            scene, names = keys.validated(candidate.values), keys.names
            units = tuple(number.unit for number in keys.numbers)
        tip = self._motion(candidate.graph).tip(
            candidate.values if len(candidate.values) else self._keys.values
        )
        near = distance(self._wanted, tip, self._task.tolerance_m)
        none = np.zeros((0, 2))
        return NumberDesign(scene, names, units, candidate.values, near, none, (), "interrupted")

    def candidates(self) -> list[QuickCandidate]:
        """The best graphs with their numbers, the best first."""
        if not self.is_graph_free:
            return self._of_one_graph()
        graphs = list(itertools.islice(self._all_graphs(), FEW_GRAPHS + 1))
        ranked = self._ranked(graphs) if len(graphs) <= FEW_GRAPHS else self._evolved()
        best = ranked[0].away_m
        near = [one for one in ranked if one.away_m <= best + DIFFERENT * self._task.tolerance_m]
        return near[:FULL_GRAPHS]

    @property
    def _until(self) -> float:
        began = self._task.log.began
        return min(self._task.until, began + QUICK_SHARE * self._task.budget_s)

    @property
    def _is_over(self) -> bool:
        return self._task.stop.asked or clock.perf_counter() > self._until

    # -- one graph -------------------------------------------------------------------

    def _of_one_graph(self) -> list[QuickCandidate]:
        """Fits from several starts: one harmonic of many sizes and periods, and chance."""
        found = []
        first, *drawn = self._starts(QUICK_DRAWS)
        drawn.sort(key=lambda start: self._cost(self._own, start))
        for start in [*drawn[:2], first, *drawn[2:QUICK_STARTS]]:
            try:
                found.append(self._fitted(self._own, start, QUICK_EVALUATIONS))
            except KeyboardInterrupt:
                break
            best = min(one.away_m for one in found)
            self._task.tell()
            again = sum(one.away_m < SAME_OPTIMUM * best for one in found)
            if self._is_over or best < 0.3 * self._task.tolerance_m or again >= ENOUGH_TIMES:
                break
        return _distinct(found)[:FULL_DESIGNS]

    def _starts(self, count: int) -> Iterator[np.ndarray]:
        """The scene's own numbers, then others by chance: high harmonics are small."""
        assert self._ranges is not None
        ranges, numbers = self._ranges, self._keys.numbers
        drawn = ranges.starts(self._keys.values, count, self._task.seed)
        yield drawn[0]
        for own in drawn[1:]:
            found = own.copy()
            for k, number in enumerate(numbers):
                if number.path[0] == "input" and number.path[1] in ("cosine", "sine"):
                    found[k] *= 0.8 / (1 + int(number.path[2])) ** 2
                if number.path == ("input", "mean"):
                    found[k] = self._mean_pressure
            yield found if self._limits is None else self._sized(found)

    def _sized(self, values: np.ndarray) -> np.ndarray:
        """Numbers whose input keeps its limits and moves the tip as far as the path is long."""
        assert self._limits is not None
        motion, found = self._motion(self._own), self._limits.within(values)
        amplitudes = [
            k for k, own in enumerate(self._keys.numbers) if own.path[1] in ("cosine", "sine")
        ]
        for _ in range(SIZINGS):
            tip = motion.tip(found)
            way = np.linalg.norm(np.diff(tip, axis=0, append=tip[:1]), axis=1).sum()
            found[amplitudes] *= min(self._wanted.length / max(float(way), 1e-9), MOST_SIZING)
            found = self._limits.within(found)
        return found

    @property
    def _mean_pressure(self) -> float:
        """That of a straight rod as long as the path is high in the mean [Pa]."""
        assert self._task.choice.harmonics is not None
        rod = ArcRod.of(SceneQuantities(self._base))
        length = self._base.actuator.length
        height = float(self._wanted.points[:, 1].mean())
        level = (height / length - 1) / (2 * rod.stretch) - self._base.gauge_pressure
        return float(np.clip(level, *self._task.choice.harmonics.limits))

    def _cost(self, graph: TreeGraph, values: np.ndarray) -> float:
        """Sum of squares of a start."""
        residuals = PathResiduals(self._motion(graph), self._wanted, self._limits)
        return float(np.sum(residuals(values) ** 2))

    # -- all graphs --------------------------------------------------------------------

    def _all_graphs(self) -> Iterator[TreeGraph]:
        count = 2 * self.sections
        if self._task.choice.graph == "chain":
            yield from map(chain, itertools.permutations(range(count)))
            return
        for parent in itertools.product(range(-1, count), repeat=count):
            if _is_tree(parent):
                yield tree(parent)

    def _ranked(self, graphs: list[TreeGraph]) -> list[QuickCandidate]:
        found = [self._as_it_is(graph) for graph in graphs]
        found.sort(key=lambda one: one.away_m)
        if self._ranges is None:
            return found
        fitted = []
        for one in found[:RANKED]:
            try:
                fitted.append(self._fitted(one.graph, one.values, QUICK_EVALUATIONS))
            except KeyboardInterrupt:
                return sorted([*fitted, *found[:1]], key=lambda one: one.away_m)
            if self._is_over:
                break
        return sorted(fitted, key=lambda one: one.away_m)

    # -- many graphs ---------------------------------------------------------------------

    def _evolved(self) -> list[QuickCandidate]:
        """The best after many changes, each from one of the best so far."""
        seen = {graph.key: graph for graph in self._first_graphs()}
        starts = [*self._starts(3)] if self._ranges is not None else [np.zeros(0)]
        pool = [self._fitted(g, s, QUICK_EVALUATIONS) for g in seen.values() for s in starts[:2]]
        elite = self._best(pool)
        near = 0.2 if self._task.choice.ranges else 0.05
        for _ in range(MOST_CHANGES if self._ranges is not None else MOST_PLAIN_CHANGES):
            if self._is_over or elite[0].away_m < near * self._task.tolerance_m:
                break
            place = min(int(self._random.expovariate(4.0 / self._elite)), len(elite) - 1)
            parent = elite[place]
            graph = self._changed(parent.graph)
            for _ in range(MOST_MORE_CHANGES):
                # Beside the best all are known sooner or later: look farther off.
                if graph.key in seen or self._random.random() < MORE_CHANGES:
                    graph = self._changed(graph)
            if graph.key in seen:
                continue
            seen[graph.key] = graph
            values = self._moved(parent, graph)
            try:
                child = self._fitted(graph, values, CHANGE_EVALUATIONS)
            except KeyboardInterrupt:
                return elite
            if child.away_m < elite[-1].away_m:
                elite = self._best([*elite, child])
                self._task.tell()
        if self._task.stop.asked:
            return elite
        return [self._fitted(one.graph, one.values, 2 * QUICK_EVALUATIONS) for one in elite]

    def _first_graphs(self) -> list[TreeGraph]:
        plain = straight(self.sections)
        own = [self._own, mirrored(self._own, self.sections), plain, mirrored(plain, self.sections)]
        if self._task.choice.graph == "chain":
            own = [graph for graph in own if graph.is_chain]
        changed = [self._changed(self._changed(graph)) for graph in own]
        return [*own, *changed]

    def _changed(self, graph: TreeGraph) -> TreeGraph:
        change = changed_chain if self._task.choice.graph == "chain" else changed_tree
        return change(graph, self._random)

    def _moved(self, parent: QuickCandidate, graph: TreeGraph) -> np.ndarray:
        """A parent's numbers for another graph: each bellow keeps the tube that feeds it."""
        found = parent.values.copy()
        if not len(found):
            return found
        own = {far: q for q, (far, _) in enumerate(parent.graph.parents)}
        for q, (far, _) in enumerate(graph.parents):
            if q in self._slots and own[far] in self._slots:
                found[self._slots[q]] = parent.values[self._slots[own[far]]]
        return found

    def _best(self, pool: list[QuickCandidate]) -> list[QuickCandidate]:
        """The best of every graph."""
        found: dict[object, QuickCandidate] = {}
        for one in sorted(pool, key=lambda one: one.away_m):
            found.setdefault(one.graph.key, one)
        return list(found.values())[: self._elite]

    @property
    def _elite(self) -> int:
        return ELITE if self._ranges is not None else PLAIN_ELITE

    # -- one candidate -----------------------------------------------------------------

    def _motion(self, graph: TreeGraph) -> QuickMotion:
        wanted = self._task.wanted
        return QuickMotion(self._keys, graph, wanted.times if wanted.timing == "given" else None)

    def _as_it_is(self, graph: TreeGraph) -> QuickCandidate:
        values = self._keys.values
        found = distance(self._wanted, self._motion(graph).tip(values), self._task.tolerance_m)
        own = values if self._ranges is not None else np.zeros(0)
        return QuickCandidate(graph, own, found.total_m)

    def _fitted(self, graph: TreeGraph, start: np.ndarray, evaluations: int) -> QuickCandidate:
        if self._ranges is None:
            return self._as_it_is(graph)
        motion = self._motion(graph)
        residuals = PathResiduals(motion, self._wanted, self._limits, both_ways=True)
        limits = SearchLimits(
            met_cost=(
                (QUICK_MET if self._wanted.timing == "free" else 0.01) * self._task.tolerance_m
            )
            ** 2,
            evaluations=evaluations,
            until=self._task.until,
            stop=self._task.stop,
        )
        fit = least_squares(residuals, self._ranges, [start], limits=limits)
        found = distance(self._wanted, motion.tip(fit.values), self._task.tolerance_m)
        return QuickCandidate(graph, fit.values, found.total_m)


def _is_tree(parent: tuple[int, ...]) -> bool:
    """Whether every bellow leads to the inlet."""
    for bellow in range(len(parent)):
        here, steps = bellow, 0
        while here != INLET and steps <= len(parent):
            here, steps = parent[here], steps + 1
        if here != INLET:
            return False
    return True


def _distinct(found: list[QuickCandidate]) -> list[QuickCandidate]:
    """Candidates by their distance, without those that are as far and as large as another."""
    kept: list[QuickCandidate] = []
    for one in sorted(found, key=lambda one: one.away_m):
        if all(not np.allclose(one.values, other.values, rtol=0.02) for other in kept):
            kept.append(one)
    return kept
