"""Thirty poses that serve more than thirty moves: candidates for a search to be content with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from viscodesign.pumps.pose_engine import MOST_POSES
from viscodesign.pumps.pose_search import Pose, Vertex


def poses_of(vertices: Sequence[Vertex]) -> list[Pose]:
    """The different poses of a way, in the order in which they are first needed."""
    return list(dict.fromkeys((v.goals, number % 2) for number, v in enumerate(vertices)))


def libraries(vertices: Sequence[Vertex], grid: int) -> Iterator[set[Pose]]:
    """Sets of at most thirty poses near those of a way, goals on a grid."""
    poses = poses_of(vertices)
    yield _merged([(np.array(goals, float), phase, 1) for goals, phase in poses], grid)
    # A way that is travelled back and forth meets its corners in both phases.
    goals = list(dict.fromkeys(vertex.goals for vertex in vertices))
    levels = _merged([(np.array(g, float), 0, 1) for g in goals], grid, MOST_POSES // 2)
    yield {(level, phase) for level, _ in levels for phase in (0, 1)}
    if len(goals[0]) == 1:
        low, high = min(goals)[0], max(goals)[0]
        even = np.unique(grid * np.round(np.linspace(low, high, MOST_POSES // 2) / grid))
        yield {((int(level),), phase) for level in even for phase in (0, 1)}


_Cluster = tuple[np.ndarray, int, int]
"""Mean goals, phase and number of members."""


def _merged(clusters: list[_Cluster], grid: int, most: int = MOST_POSES) -> set[Pose]:
    """Unite the two nearest of a phase until few enough are left."""
    while len(clusters) > most:
        first, second = _nearest(clusters)
        (a, phase, m), (b, _, n) = clusters[first], clusters[second]
        clusters = [c for i, c in enumerate(clusters) if i not in (first, second)]
        clusters.append(((m * a + n * b) / (m + n), phase, m + n))
    return {
        (tuple(int(grid * round(x / grid)) for x in goals), phase) for goals, phase, _ in clusters
    }


def _nearest(clusters: list[_Cluster]) -> tuple[int, int]:
    goals = np.array([goals for goals, _, _ in clusters])
    phases = np.array([phase for _, phase, _ in clusters])
    apart = np.abs(goals[:, None] - goals[None]).max(-1)
    apart[phases[:, None] != phases[None]] = np.inf
    np.fill_diagonal(apart, np.inf)
    first, second = np.unravel_index(int(np.argmin(apart)), apart.shape)
    return int(first), int(second)
