"""One graph with numbers, as near to the wanted path as its quick motion comes."""

from __future__ import annotations

from typing import Self

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.inverse.number_search import NumberDesign, limits_of
from viscodesign.inverse.quick_motion import QuickMotion
from viscodesign.inverse.search_task import SearchTask
from viscodesign.inverse.tip_residuals import PathResiduals, distance
from viscodesign.inverse.tree_graph import TreeGraph, sizes_of, straight, with_tree
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.studies.least_squares import SearchLimits, least_squares

QUICK_EVALUATIONS = 40
LENGTHS = ["network.tubes[*].length"]
QUICK_SHARE = 0.6
"""Part of the budget after which ranking is cut."""
QUICK_MET = 0.25
"""Part of the tolerance at which the quick motion is near enough."""


@dataclass(frozen=True, eq=False)
class QuickCandidate:
    """A graph, its numbers, and how near its quick motion comes."""

    graph: TreeGraph
    values: np.ndarray
    away_m: float
    """Root mean square distance both ways, that back beyond the tolerance [m]."""


class QuickFit:
    """Fits of a task's graphs by the quick motion, within a part of its budget."""

    def __init__(self, task: SearchTask, scene: Scene, own: TreeGraph | None) -> None:
        self._arguments = scene, own
        self.task, self.wanted = task, task.wanted.coarser
        self.sections = scene.bellows.count // 2
        self.is_graph_free = task.choice.graph != "keep"
        self.own = own or straight(self.sections)
        self._sizes = sizes_of(scene, scene.bellows.count)
        self.base = with_tree(scene.replace({"network.feed_line": None}), self.own, self._sizes)
        self._scene = scene
        numbers = task.choice.numbers(self.base)
        self.keys = FreeKeys(self.base, LENGTHS) if numbers is None else numbers[0]
        self.ranges = None if numbers is None else numbers[1]
        self.limits = None if numbers is None else limits_of(task, self.keys)

    def of_task(self, task: SearchTask) -> Self:
        """The same for another task."""
        return type(self)(task, *self._arguments)

    def scene_of(self, graph: TreeGraph) -> Scene:
        """The scene with a graph."""
        if not self.is_graph_free:
            return self._scene
        return with_tree(self._scene, graph, self._sizes)

    def unsolved(self, candidate: QuickCandidate) -> NumberDesign:
        """A candidate as it is, where the search was interrupted before a solution."""
        scene = self.scene_of(candidate.graph)
        numbers = self.task.choice.numbers(scene)
        names: tuple[str, ...] = ()
        units: tuple[str, ...] = ()
        if numbers is not None:
            keys, _ = numbers
            scene, names = keys.validated(candidate.values), keys.names
            units = tuple(number.unit for number in keys.numbers)
        tip = self.motion(candidate.graph).tip(
            candidate.values if len(candidate.values) else self.keys.values
        )
        near = distance(self.wanted, tip, self.task.tolerance_m)
        none = np.zeros((0, 2))
        return NumberDesign(scene, names, units, candidate.values, near, none, (), "interrupted")

    @property
    def _until(self) -> float:
        began = self.task.log.began
        return min(self.task.until, began + QUICK_SHARE * self.task.budget_s)

    @property
    def is_over(self) -> bool:
        """Whether ranking has to end; asked where work is left."""
        return self.task.is_beyond(self._until)

    def motion(self, graph: TreeGraph) -> QuickMotion:
        """The quick motion of a graph."""
        wanted = self.task.wanted
        return QuickMotion(self.keys, graph, wanted.times if wanted.timing == "given" else None)

    def as_it_is(self, graph: TreeGraph) -> QuickCandidate:
        """A graph with the scene's own numbers."""
        values = self.keys.values
        found = distance(self.wanted, self.motion(graph).tip(values), self.task.tolerance_m)
        own = values if self.ranges is not None else np.zeros(0)
        return QuickCandidate(graph, own, found.total_m)

    def fitted(self, graph: TreeGraph, start: np.ndarray, evaluations: int) -> QuickCandidate:
        """A graph with the best numbers from a start."""
        if self.ranges is None:
            return self.as_it_is(graph)
        motion = self.motion(graph)
        residuals = PathResiduals(motion, self.wanted, self.limits, both_ways=True)
        limits = SearchLimits(
            met_cost=((QUICK_MET if self.wanted.timing == "free" else 0.01) * self.task.tolerance_m)
            ** 2,
            evaluations=evaluations,
            until=self.task.until,
            stop=self.task.stop,
        )
        fit = least_squares(residuals, self.ranges, [start], limits=limits)
        found = distance(self.wanted, motion.tip(fit.values), self.task.tolerance_m)
        return QuickCandidate(graph, fit.values, found.total_m)

    def cost(self, graph: TreeGraph, values: np.ndarray) -> float:
        """Sum of squares of a start."""
        residuals = PathResiduals(self.motion(graph), self.wanted, self.limits)
        return float(np.sum(residuals(values) ** 2))
