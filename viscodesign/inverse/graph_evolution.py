"""The best of many graphs: changed at random, each fitted from the numbers that it came from."""

from __future__ import annotations

import random

import numpy as np

from viscodesign.inverse.quick_fit import QUICK_EVALUATIONS, QuickCandidate, QuickFit
from viscodesign.inverse.quick_starts import QuickStarts
from viscodesign.inverse.tree_changes import changed_chain, changed_tree
from viscodesign.inverse.tree_graph import TreeGraph, mirrored, straight

CHANGE_EVALUATIONS = 15
MORE_CHANGES, MOST_MORE_CHANGES = 0.25, 4
"""Chance of one more change at once, and how many more there may be."""
MOST_CHANGES, MOST_PLAIN_CHANGES = 1500, 20_000
"""Limits of graphs whose numbers are fitted, and of such as have none that are free."""
ELITE, PLAIN_ELITE = 8, 24
"""Graphs that are changed, the best the most: with numbers that are fitted, and without."""


class GraphEvolution:
    """Changes of a task's graphs, and the best of them."""

    def __init__(self, fit: QuickFit) -> None:
        self._fit, self._starts = fit, QuickStarts(fit)
        self._random = random.Random(fit.task.seed)
        self._slots = {
            int(number.path[2]): k
            for k, number in enumerate(self._fit.keys.numbers)
            if number.path[:2] == ("network", "tubes") and number.path[-1] == "length"
        }
        """Place of each tube's length among the numbers, by the tube."""

    def best(self) -> list[QuickCandidate]:
        """The best after many changes, each from one of the best so far."""
        seen = {graph.key: graph for graph in self._first_graphs()}
        starts = [*self._starts.drawn(3)] if self._fit.ranges is not None else [np.zeros(0)]
        pool = [
            self._fit.fitted(g, s, QUICK_EVALUATIONS) for g in seen.values() for s in starts[:2]
        ]
        elite = self._best(pool)
        near = 0.2 if self._fit.task.choice.ranges else 0.05
        for _ in range(MOST_CHANGES if self._fit.ranges is not None else MOST_PLAIN_CHANGES):
            if self._fit.is_over or elite[0].away_m < near * self._fit.task.tolerance_m:
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
                child = self._fit.fitted(graph, values, CHANGE_EVALUATIONS)
            except KeyboardInterrupt:
                return elite
            if child.away_m < elite[-1].away_m:
                elite = self._best([*elite, child])
                self._fit.task.tell()
        if self._fit.task.stop.asked:
            return elite
        return [self._fit.fitted(one.graph, one.values, 2 * QUICK_EVALUATIONS) for one in elite]

    def _first_graphs(self) -> list[TreeGraph]:
        plain = straight(self._fit.sections)
        own = [
            self._fit.own,
            mirrored(self._fit.own, self._fit.sections),
            plain,
            mirrored(plain, self._fit.sections),
        ]
        if self._fit.task.choice.graph == "chain":
            own = [graph for graph in own if graph.is_chain]
        changed = [self._changed(self._changed(graph)) for graph in own]
        return [*own, *changed]

    def _changed(self, graph: TreeGraph) -> TreeGraph:
        change = changed_chain if self._fit.task.choice.graph == "chain" else changed_tree
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
        return ELITE if self._fit.ranges is not None else PLAIN_ELITE
