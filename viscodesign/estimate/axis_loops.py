"""Axes as rows of arcs, and how loads turn and draw them: by native loops, or by arrays."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.native.angles import MAX_ANGLE, sines_and_cosines
from viscodesign.native.loops import native_loops
from viscodesign.native.machine import this_machine
from viscodesign.native.unavailable import NativeUnavailable

TINY = 1e-30


def axes_laid(
    curvature: np.ndarray, stretch: np.ndarray, length: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Ends, middles [m] and unit tangents (S, 2, K, T) of pieces of this reference length [m].

    ``curvature`` [1/m] and ``stretch`` (S, K, T) are those of every piece.
    """
    rows, *rest = curvature.shape
    nodes, middle, direction = np.empty((3, rows, 2, *rest))
    turned = np.max(np.abs(curvature), initial=0.0) * length * rest[0]
    try:
        if not turned <= MAX_ANGLE:
            return _laid_by_arrays(curvature, stretch, length)
        _by_loop("lay_axes", length, (curvature, stretch), (nodes, middle, direction))
    except NativeUnavailable:
        return _laid_by_arrays(curvature, stretch, length)
    return nodes, middle, direction


def axes_strained(
    stiffnesses: tuple[np.ndarray, np.ndarray],
    vectors: tuple[np.ndarray, np.ndarray, np.ndarray],
    force: np.ndarray,
    most: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Angles [rad], of up to ``most``, and stretches (S, K, T) by forces at the ends of pieces.

    ``stiffnesses`` (K,): moment per angle [N m], and force per stretch [N]; ``vectors``: ends,
    middles and tangents (S, 2, K, T); ``force`` (S, 2, K, T or 1) [N].
    """
    nodes = vectors[0]
    turned, drawn = np.empty((2, len(nodes), *nodes.shape[2:]))
    compliances = [1 / own for own in stiffnesses]
    given = (*compliances, *vectors, np.broadcast_to(force, nodes.shape))
    try:
        _by_loop("strain_axes", most, given, (turned, drawn))
    except NativeUnavailable:
        return _strained_by_arrays(stiffnesses, vectors, force, most)
    return turned, drawn


def _by_loop(
    loop: str, number: float, given: Sequence[np.ndarray], found: Sequence[np.ndarray]
) -> None:
    """By a loop of `native.source.axes`. Raises `NativeUnavailable`."""
    this_machine()  # code that was made before may have been switched off
    loops = native_loops()
    rows, pieces, samples = len(found[0]), *found[0].shape[-2:]
    arrays = [*given, np.empty(3 * samples), *found]
    reals = [np.ascontiguousarray(values, float).reshape(-1) for values in arrays]
    loops(loop, rows, pieces, samples, number, *reals)


def _laid_by_arrays(
    curvature: np.ndarray, stretch: np.ndarray, length: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    half_turn = curvature * (length / 2)
    pieces = half_turn.shape[1]
    across, along = sines_and_cosines((2 * np.tri(pieces) - np.eye(pieces)) @ half_turn)
    # The sine of an angle over the angle, also at zero.
    angle = np.where(half_turn == 0.0, TINY, half_turn)
    direction = np.stack([across, along], axis=1)
    chord = (length * stretch * (sines_and_cosines(angle)[0] / angle))[:, None] * direction
    nodes = np.tri(pieces) @ chord
    return nodes, nodes - chord / 2, direction


def _strained_by_arrays(
    stiffnesses: tuple[np.ndarray, np.ndarray],
    vectors: tuple[np.ndarray, np.ndarray, np.ndarray],
    force: np.ndarray,
    most: float,
) -> tuple[np.ndarray, np.ndarray]:
    nodes, middle, direction = vectors
    per_turn, per_stretch = (np.reshape(own, (-1, 1)) for own in stiffnesses)
    carried = sum_to_tip(force)
    moment = moment_of(middle, carried) - sum_to_tip(moment_of(nodes, force))
    along = direction * carried
    return np.clip(moment / per_turn, -most, most), (along[:, 0] + along[:, 1]) / per_stretch


def moment_of(arm: np.ndarray, force: np.ndarray) -> np.ndarray:
    """Moments (S, K, T) of forces about the clamp, from vectors (S, 2, K, T): x into z."""
    return np.asarray(arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0])


def sum_to_tip(values: np.ndarray) -> np.ndarray:
    """Sums from each piece to the tip (S, ..., K, T)."""
    return np.asarray(np.tri(values.shape[-2]).T @ values)
