"""Selecting times to draw, and the outline of a bent body."""

from __future__ import annotations

import numpy as np

from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes, rows_at

DISTINCT_DISTANCE = 0.01
"""Smallest difference worth drawing, relative to length and range of pressure."""


MAX_COMPARED_SHAPES = 5000
"""Number of shapes among which those to draw are selected."""


def spread_instants(trajectory: Trajectory, count: int, *, pressures: bool = False) -> np.ndarray:
    """Indices of up to ``count`` shapes, ascending, spread over what occurs.

    The first, the last, then always the one farthest from all chosen so far, by its shape
    and optionally its ``pressures``: a motion that pauses or repeats itself is not drawn
    twice, a fast one is not skipped.
    """
    compared = _compared(len(trajectory.shape))
    places = _configurations(trajectory, compared, pressures)
    distance = np.linalg.norm(places - places[0], axis=1)
    chosen = [0]
    last = len(places) - 1
    if distance[last] >= DISTINCT_DISTANCE or (trajectory.status != "complete" and last > 0):
        chosen.append(last)
        distance = np.minimum(distance, np.linalg.norm(places - places[last], axis=1))
    while len(chosen) < count:
        farthest = int(np.argmax(distance))
        if distance[farthest] < DISTINCT_DISTANCE:
            break
        chosen.append(farthest)
        distance = np.minimum(distance, np.linalg.norm(places - places[farthest], axis=1))
    return np.asarray(compared[sorted(chosen)])


def _compared(shapes: int) -> np.ndarray:
    """Indices of the compared shapes; of many, some at random, so that no cycle is missed."""
    if shapes <= MAX_COMPARED_SHAPES:
        return np.arange(shapes)
    scattered = np.random.default_rng(0).choice(shapes, MAX_COMPARED_SHAPES - 2, replace=False)
    return np.unique([0, *scattered.tolist(), shapes - 1])


def _configurations(trajectory: Trajectory, compared: np.ndarray, pressures: bool) -> np.ndarray:
    """One row per shape, scaled by the length and by the range of all pressures."""
    points = trajectory.shape.shape[1]
    shape: np.ndarray = rows_at(trajectory.shape, compared).reshape(len(compared), -1)
    shape = shape / (trajectory.length * np.sqrt(points))
    low, high = extremes(trajectory.pressure)
    span, largest = float(high.max() - low.min()), float(max(high.max(), -low.min()))
    # A range below a millionth is rounding, not motion.
    if not pressures or span <= 1e-6 * largest:
        return shape
    rows = trajectory.shape_rows[compared]
    scaled = rows_at(trajectory.pressure, rows) / (span * np.sqrt(trajectory.pressure.shape[1]))
    # Motion is seen better than a change of colour.
    return np.concatenate([shape, 0.5 * scaled], axis=1)


def normals(axis: np.ndarray) -> np.ndarray:
    """Unit normals (..., K, 2) of an axis (..., K, 2), to the right when looking towards the tip.

    Right is +x where the axis runs along +z.
    """
    tangent = np.gradient(axis, axis=-2)
    length = np.hypot(tangent[..., 0], tangent[..., 1])
    unit = tangent / np.maximum(length, 1e-300)[..., None]
    return np.stack((unit[..., 1], -unit[..., 0]), axis=-1)


def outline(axis: np.ndarray, width: float | np.ndarray) -> np.ndarray:
    """Closed outlines (..., 2 K, 2) of a body about its axis (..., K, 2) [m].

    ``width``: one for all, or (K,) [m].
    """
    side = normals(axis) * np.asarray(width)[..., None] / 2
    return np.concatenate([axis + side, (axis - side)[..., ::-1, :]], axis=-2)


def clamp_strokes(half: float, height: float, count: int) -> np.ndarray:
    """Hatching (count, 2, 2) above a clamp from -half to +half at z = 0, z pointing down."""
    foot = np.linspace(-half, half, count, endpoint=False)
    head = foot + 2 * half / count
    level = np.zeros(count)
    return np.stack(
        (np.stack((foot, level), axis=1), np.stack((head, level - height), axis=1)), axis=1
    )
