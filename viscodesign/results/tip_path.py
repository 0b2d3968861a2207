"""Size, length and area of a path in the plane, each with its gradient."""

from __future__ import annotations

import numpy as np


def extent(path: np.ndarray, component: int) -> float:
    """Largest less smallest x (0) or z (1) of a path (m, 2) [m]."""
    values = path[:, component]
    return float(values.max() - values.min())


def extent_gradient(path: np.ndarray, component: int) -> np.ndarray:
    """Gradient (m, 2) of `extent`: at its two ends, the first of equal ones."""
    found = np.zeros_like(path)
    values = path[:, component]
    found[np.argmax(values), component] += 1.0
    found[np.argmin(values), component] -= 1.0
    return found


def path_length(path: np.ndarray) -> float:
    """Length of a polyline (m, 2), not closed [m]."""
    return float(np.sum(np.hypot(*np.diff(path, axis=0).T)))


def path_length_gradient(path: np.ndarray) -> np.ndarray:
    """Gradient (m, 2) of `path_length`; zero of a segment without length."""
    steps = np.diff(path, axis=0)
    lengths = np.hypot(*steps.T)[:, None]
    directions = np.divide(steps, lengths, out=np.zeros_like(steps), where=lengths > 0)
    found = np.zeros_like(path)
    found[1:] += directions
    found[:-1] -= directions
    return found


def enclosed_area(path: np.ndarray) -> float:
    """Area (shoelace formula) of a path (m, 2) closed by a straight line [m2].

    Counter-clockwise positive, with x to the right and z upwards.
    """
    x, z = (path - path[0]).T
    return float(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z)) / 2


def enclosed_area_gradient(path: np.ndarray) -> np.ndarray:
    """Gradient (m, 2) of `enclosed_area`."""
    across = (np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0)) / 2
    return np.column_stack((across[:, 1], -across[:, 0]))
