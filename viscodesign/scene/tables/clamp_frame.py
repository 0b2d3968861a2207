"""The frame of an actuator in space, by markers at its clamp whose places in it are known."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass

MIN_MARKERS = 3
ON_A_LINE = 0.05
"""Second largest extent of markers, over the largest, below which they lie on a line."""


@dataclass(frozen=True, eq=False)
class ClampFrame:
    """A rigid motion from the camera's frame to the actuator's: r -> R r + d."""

    rotation: np.ndarray
    """R (3, 3)"""
    shift: np.ndarray
    """d (3,) [m]"""
    misfit: float
    """Root mean square distance of the markers from their stated places [m]."""

    def placed(self, points: np.ndarray) -> np.ndarray:
        """Points (..., 3) of the camera's frame in the actuator's [m]."""
        return np.asarray(points @ self.rotation.T + self.shift)


def clamp_frame(seen: np.ndarray, places: np.ndarray) -> ClampFrame:
    """The frame in which markers that were ``seen`` (n, 3) are next to their ``places`` (n, 3) [m].

    The least squares of Kabsch (1976): a rotation, never a mirror image.
    """
    middle, own = seen.mean(axis=0), places.mean(axis=0)
    left, _, right = np.linalg.svd((places - own).T @ (seen - middle))
    sign = np.sign(np.linalg.det(left @ right))
    rotation = left @ np.diag([1.0, 1.0, sign]) @ right
    shift = own - rotation @ middle
    off = seen @ rotation.T + shift - places
    return ClampFrame(rotation, shift, float(np.sqrt(np.mean(np.sum(off**2, axis=1)))))


def are_on_a_line(places: np.ndarray) -> bool:
    """Whether markers (n, 3) leave a rotation open."""
    extents = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
    return bool(extents[1] <= ON_A_LINE * extents[0])
