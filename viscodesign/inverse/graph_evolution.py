"""The best of many graphs: changed at random, each fitted from the numbers that it came from."""

from __future__ import annotations

import math
import random

import numpy as np

from viscodesign.inverse.graph_trials import GraphTrials, graph_trials
from viscodesign.inverse.quick_fit import QUICK_EVALUATIONS, QuickCandidate, QuickFit
from viscodesign.inverse.quick_starts import QuickStarts
from viscodesign.inverse.tree_changes import changed_chain, changed_tree
from viscodesign.inverse.tree_graph import TreeGraph, mirrored, straight
from viscodesign.lazy_dataclass import dataclass

GraphPair = tuple[TreeGraph, np.ndarray]
"""A graph, and the numbers from which it is fitted."""


@dataclass(frozen=True)
class EvolutionRules:
    """Sizes and ends of a search by changes of graphs."""

    change_evaluations: int = 15
    more_changes: float = 0.25
    most_more_changes: int = 4
    """Chance of one more change at once, and how many more there may be."""
    generation: int = 16
    plain_generation: int = 64
    """Graphs that are changed from the same elite, and tried side by side."""
    most_draws: int = 50
    """Changes in a row that lead to known graphs only, after which a generation is complete."""
    elite: int = 8
    plain_elite: int = 24
    """Graphs that are changed, the best the most: with numbers that are fitted, and without."""


RULES = EvolutionRules()
CHANGES_PER_S, PLAIN_CHANGES_PER_S = 2.5, 150.0
"""Changed graphs for each second of the budget, whose numbers are fitted, and of such as have none
that are free: about a quarter of what an idle core does, so that the budget seldom ends the search,
and a busy machine finds what an idle one does."""


class GraphEvolution:
    """Changes of a task's graphs, and the best of them."""

    def __init__(self, fit: QuickFit) -> None:
        self._fit, self._starts = fit, QuickStarts(fit)
        self._random = random.Random(fit.task.seed)
        self._seen: set[object] = set()
        self._has_numbers = fit.ranges is not None
        self._slots = {
            int(number.path[2]): k
            for k, number in enumerate(self._fit.keys.numbers)
            if number.path[:2] == ("network", "tubes") and number.path[-1] == "length"
        }
        """Place of each tube's length among the numbers, by the tube."""

    def best(self) -> list[QuickCandidate]:
        """The best after many changes, each from one of the best so far; none without a fit."""
        with graph_trials(self._fit) as trials:
            elite = self._evolved(trials)
            if self._fit.task.stop.asked:
                return elite
            pairs = [(one.graph, one.values) for one in elite]
            finer = trials.fitted(pairs, 2 * QUICK_EVALUATIONS)
        return [finer.get(k, one) for k, one in enumerate(elite)]

    def _evolved(self, trials: GraphTrials) -> list[QuickCandidate]:
        """The elite at the end."""
        first = self._first_pairs()
        self._seen = {graph.key for graph, _ in first}
        elite = self._best([*trials.fitted(first, QUICK_EVALUATIONS).values()])
        near = 0.2 if self._fit.task.choice.ranges else 0.05
        left = self._planned
        while elite and left > 0 and elite[0].away_m >= near * self._fit.task.tolerance_m:
            changed = self._generation(elite, left)
            if not changed or self._fit.is_over:
                break
            left -= len(changed)
            elite = self._best([*elite, *trials.fitted(changed, RULES.change_evaluations).values()])
            self._fit.task.report()
        return elite

    @property
    def _planned(self) -> int:
        """Changed graphs that are tried."""
        per_second = CHANGES_PER_S if self._has_numbers else PLAIN_CHANGES_PER_S
        return math.ceil(per_second * self._fit.task.budget_s)

    def _generation(self, elite: list[QuickCandidate], most: int) -> list[GraphPair]:
        """New graphs, each changed from one of the elite, with the numbers that it had."""
        size = min(most, RULES.generation if self._has_numbers else RULES.plain_generation)
        found: list[GraphPair] = []
        failed = 0
        while len(found) < size and failed < RULES.most_draws:
            place = min(int(self._random.expovariate(4.0 / self._elite)), len(elite) - 1)
            graph = self._new_graph(elite[place].graph)
            if graph.key in self._seen:
                failed += 1
                continue
            failed = 0
            self._seen.add(graph.key)
            found.append((graph, self._moved(elite[place], graph)))
        return found

    def _new_graph(self, parent: TreeGraph) -> TreeGraph:
        graph = self._changed(parent)
        for _ in range(RULES.most_more_changes):
            # Beside the best all are known sooner or later: look farther off.
            if graph.key in self._seen or self._random.random() < RULES.more_changes:
                graph = self._changed(graph)
        return graph

    def _first_pairs(self) -> list[GraphPair]:
        """The first graphs, each from two starts."""
        graphs = {graph.key: graph for graph in self._first_graphs()}.values()
        starts = [*self._starts.drawn(3)][:2] if self._has_numbers else [np.zeros(0)]
        return [(graph, start) for graph in graphs for start in starts]

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
        return RULES.elite if self._has_numbers else RULES.plain_elite
