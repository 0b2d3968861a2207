"""Quick fits of many graphs in several processes, the same for any number of them."""

from __future__ import annotations

import time as clock
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import Protocol

import numpy as np

from viscodesign.interrupt import StopRequest
from viscodesign.inverse.quick_fit import QuickCandidate, QuickFit
from viscodesign.inverse.tree_graph import TreeGraph
from viscodesign.lazy_dataclass import dataclass
from viscodesign.studies.parallel_rows import Chunk, RowProcesses, compute_alone

TRIALS_AT_ONCE = 4
"""Graphs that a process takes at once, and that are lost with it."""


@dataclass(frozen=True, eq=False)
class GraphTrial:
    """A graph to be fitted from a start, and its place among those that are asked for."""

    place: int
    graph: TreeGraph
    start: np.ndarray
    evaluations: int


class Compute(Protocol):
    """Results of chunks of trials as they come, until the user asks to stop."""

    def __call__(
        self, chunks: Iterable[list[GraphTrial]], stop: StopRequest, /
    ) -> Iterator[Chunk[GraphTrial, QuickCandidate]]: ...


class GraphTrials:
    """Fits of a task's graphs."""

    def __init__(self, fit: QuickFit, compute: Compute) -> None:
        self._fit, self._compute = fit, compute

    def fitted(
        self, pairs: Sequence[tuple[TreeGraph, np.ndarray]], evaluations: int
    ) -> dict[int, QuickCandidate]:
        """Fits of graphs from their starts, by their place in ``pairs`` and in its order.

        Those are missing that were lost with their process, which is noted, or that the user did
        not wait for.
        """
        trials = [GraphTrial(k, *pair, evaluations) for k, pair in enumerate(pairs)]
        chunks = [trials[k : k + TRIALS_AT_ONCE] for k in range(0, len(trials), TRIALS_AT_ONCE)]
        found: dict[int, QuickCandidate] = {}
        for chunk in self._compute(chunks, self._fit.task.stop):
            found |= {t.place: own for t, own in zip(chunk.rows, chunk.results, strict=False)}
            self._fit.task.log.lost_graphs += len(chunk.lost)
        return dict(sorted(found.items()))


@contextmanager
def graph_trials(fit: QuickFit) -> Iterator[GraphTrials]:
    """Fits in as many processes as the task says."""
    if fit.task.workers == 1:
        yield GraphTrials(fit, partial(compute_alone, partial(_fit_trials, fit)))
        return
    # Ctrl-C is noted by this process alone, and so is progress.
    quiet = fit.of_task(replace(fit.task, progress=None, stop=StopRequest()))
    with RowProcesses(partial(_fit_trials, quiet), fit.task.workers) as processes:
        yield GraphTrials(fit, processes.compute)


def _fit_trials(fit: QuickFit, trials: list[GraphTrial], within_s: float) -> list[QuickCandidate]:
    """Fits of the first trials, as many as begin within a time [s]."""
    until = clock.perf_counter() + within_s
    found = [fit.fitted(trials[0].graph, trials[0].start, trials[0].evaluations)]
    for trial in trials[1:]:
        if clock.perf_counter() > until:
            break
        found.append(fit.fitted(trial.graph, trial.start, trial.evaluations))
    return found
