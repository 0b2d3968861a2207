"""Designs over graphs and starts: ranked by the quick motion, fitted on the scene's own model.

Few graphs are all tried; of many, the best are changed at random and fitted again, each from the
numbers of the one that it came from. The best of them go on to the scene's own model.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

from viscodesign.errors import SolveError
from viscodesign.inverse.graph_evolution import GraphEvolution
from viscodesign.inverse.graph_trials import graph_trials
from viscodesign.inverse.number_search import NumberDesign, search_numbers
from viscodesign.inverse.quick_fit import QUICK_EVALUATIONS, QuickCandidate, QuickFit
from viscodesign.inverse.quick_starts import QuickStarts
from viscodesign.inverse.search_task import SearchTask
from viscodesign.inverse.tree_graph import INLET, TreeGraph, chain, tree, tree_of
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene

FEW_GRAPHS = 800
"""Graphs that are all tried."""


@dataclass(frozen=True)
class GraphSearchRules:
    """How many graphs are looked at, and how closely."""

    ranked: int = 40
    """Graphs whose numbers are fitted quickly after all were tried."""
    ranked_at_once: int = 8
    """Number of these between two looks at the clock."""
    full_graphs: int = 6
    """Graphs that go on to the scene's own model."""
    different: float = 1.5
    """Times the tolerance, from which a quick distance is not worth a solution if others are
    near."""
    met_share: float = 0.9
    plain_met_share: float = 0.1
    """Parts of the tolerance at which no other graph is solved: where numbers are fitted, and where
    only the right graph comes near."""


RULES = GraphSearchRules()


def search_designs(task: SearchTask, scene: Scene) -> list[NumberDesign]:
    """Designs of a posed scene, the best first."""
    own = tree_of(scene.graph)
    is_quick = task.choice.graph != "keep" or task.choice.harmonics is not None
    if not is_quick or (task.choice.graph == "keep" and own is None):
        return search_numbers(task, scene)
    fit = QuickFit(task, scene, own)
    found: list[NumberDesign] = []
    error: SolveError | None = None
    candidates = _candidates(fit)
    if not candidates:
        raise KeyboardInterrupt
    task.log.quick_m = candidates[0].away_m
    if task.stop.asked:
        return [fit.unsolved(candidates[0])]
    for candidate in candidates:
        if found and (_is_enough(task, found) or task.is_over):
            break
        try:
            found += search_numbers(
                task,
                fit.scene_of(candidate.graph),
                start=candidate.values if len(candidate.values) else None,
                several_starts=False,
                graph=candidate.graph.words(fit.sections) if fit.is_graph_free else "",
            )
        except SolveError as one:
            error = one
    if not found:
        raise error or KeyboardInterrupt
    return sorted(found, key=lambda one: one.distance.total_m)


def _is_enough(task: SearchTask, found: list[NumberDesign]) -> bool:
    share = RULES.met_share if task.choice.ranges else RULES.plain_met_share
    return bool(found) and min(d.distance.total_m for d in found) < share * task.tolerance_m


def _candidates(fit: QuickFit) -> list[QuickCandidate]:
    """The best graphs with their numbers, the best first."""
    if not fit.is_graph_free:
        return QuickStarts(fit).fitted()
    graphs = list(itertools.islice(_all_graphs(fit), FEW_GRAPHS + 1))
    found = _ranked(fit, graphs) if len(graphs) <= FEW_GRAPHS else GraphEvolution(fit).best()
    best = found[0].away_m
    near = [one for one in found if one.away_m <= best + RULES.different * fit.task.tolerance_m]
    return near[: RULES.full_graphs]


def _all_graphs(fit: QuickFit) -> Iterator[TreeGraph]:
    count = 2 * fit.sections
    if fit.task.choice.graph == "chain":
        yield from map(chain, itertools.permutations(range(count)))
        return
    for parent in itertools.product(range(-1, count), repeat=count):
        if _is_tree(parent):
            yield tree(parent)


def _is_tree(parent: tuple[int, ...]) -> bool:
    """Whether every bellow leads to the inlet."""
    for bellow in range(len(parent)):
        here, steps = bellow, 0
        while here != INLET and steps <= len(parent):
            here, steps = parent[here], steps + 1
        if here != INLET:
            return False
    return True


def _ranked(fit: QuickFit, graphs: list[TreeGraph]) -> list[QuickCandidate]:
    found = [fit.as_it_is(graph) for graph in graphs]
    found.sort(key=lambda one: one.away_m)
    if fit.ranges is None:
        return found
    fitted: list[QuickCandidate] = []
    with graph_trials(fit) as trials:
        for k in range(0, min(RULES.ranked, len(found)), RULES.ranked_at_once):
            if fitted and fit.is_over:
                break
            pairs = [(one.graph, one.values) for one in found[k : k + RULES.ranked_at_once]]
            fitted += trials.fitted(pairs, QUICK_EVALUATIONS).values()
    return sorted(fitted or found[:1], key=lambda one: one.away_m)
