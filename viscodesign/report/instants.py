"""Which instants to draw, and the outline of a bent body."""

from __future__ import annotations

import numpy as np

from viscodesign.trajectory import Trajectory


def spread_instants(trajectory: Trajectory, count: int) -> np.ndarray:
    """Indices of up to ``count`` times, ascending, spread over the shapes that occur.

    The first and the last, then always the one whose shape is farthest from all chosen
    so far: a motion that pauses is not drawn twice, a fast one is not skipped.
    """
    shape = trajectory.shape
    flat = shape.reshape(len(shape), -1)
    chosen = [0]
    distance = np.linalg.norm(flat - flat[0], axis=1)
    smallest = 0.01 * trajectory.length * np.sqrt(shape.shape[1])
    while len(chosen) < min(count, len(shape)):
        farthest = int(np.argmax(distance))
        if distance[farthest] < smallest:
            break
        chosen.append(farthest)
        distance = np.minimum(distance, np.linalg.norm(flat - flat[farthest], axis=1))
    return np.array(sorted(chosen))


def normals(axis: np.ndarray) -> np.ndarray:
    """Unit normals (K, 2) of an axis (K, 2), to the right of the way from clamp to tip.

    Right is +x where the axis runs along +z.
    """
    tangent = np.gradient(axis, axis=0)
    length = np.hypot(tangent[:, 0], tangent[:, 1])
    unit = tangent / np.maximum(length, 1e-300)[:, None]
    return np.column_stack((unit[:, 1], -unit[:, 0]))


def outline(axis: np.ndarray, width: float) -> np.ndarray:
    """Closed outline (2 K, 2) of a body of ``width`` about its axis [m]."""
    side = normals(axis) * width / 2
    return np.concatenate([axis + side, (axis - side)[::-1]])
