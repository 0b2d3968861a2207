"""Thirty poses that serve more than thirty moves: what a search may be content with."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.pump.poses.engine import MOST_POSES
from viscodesign.pump.poses.search import Pose, Vertex


def poses_of(vertices: Sequence[Vertex]) -> list[Pose]:
    """The different poses of a path, in the order in which they are first needed."""
    return list(dict.fromkeys((v.goals, number % 2) for number, v in enumerate(vertices)))


def shared_poses(vertices: Sequence[Vertex], grid: int) -> set[Pose]:
    """At most thirty poses near those of a path, goals on a grid.

    The two nearest of a phase are united until few enough are left.
    """
    clusters: list[_Cluster] = [
        (np.array(goals, dtype=float), phase, 1) for goals, phase in poses_of(vertices)
    ]
    while len(clusters) > MOST_POSES:
        first, second = _nearest(clusters)
        (a, phase, m), (b, _, n) = clusters[first], clusters[second]
        clusters = [c for i, c in enumerate(clusters) if i not in (first, second)]
        clusters.append(((m * a + n * b) / (m + n), phase, m + n))
    return {
        (tuple(int(grid * round(x / grid)) for x in goals), phase) for goals, phase, _ in clusters
    }


_Cluster = tuple[np.ndarray, int, int]
"""Mean goals, phase and number of members."""


def _nearest(clusters: list[_Cluster]) -> tuple[int, int]:
    goals = np.array([goals for goals, _, _ in clusters])
    phases = np.array([phase for _, phase, _ in clusters])
    apart = np.abs(goals[:, None] - goals[None]).max(-1)
    apart[phases[:, None] != phases[None]] = np.inf
    np.fill_diagonal(apart, np.inf)
    first, second = np.unravel_index(int(np.argmin(apart)), apart.shape)
    return int(first), int(second)
