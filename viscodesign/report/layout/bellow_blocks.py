"""The outlines of bellows beside a bent axis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.report.layout.snapshots import normals
from viscodesign.results.trajectory import Trajectory

BELLOW_GAP = 0.12
"""Part of a section's length left between neighbouring bellows."""
AXIS_GAP = 0.08
"""Part of the half width left free on either side of the axis."""


def bellow_blocks(
    axis: np.ndarray, arc: np.ndarray, bellows: Sequence[str], width: np.ndarray
) -> np.ndarray:
    """Quadrangles (N, B, 4, 2) beside axes (N, K, 2), in the order of the bellows.

    ``arc`` (K,) is the reference arc length of the points, ``width`` (S,) that of every section,
    in the unit of the axes. The last two corners are the outer ones.
    """
    sections = len(bellows) // 2
    at = arc / arc[-1] * sections
    section = np.arange(sections)
    ends = np.stack((section + BELLOW_GAP / 2, section + 1 - BELLOW_GAP / 2))
    point = _interpolated(ends, at, axis)
    out = _interpolated(ends, at, normals(axis)) * 0.5 * width[:, None]
    columns = {}
    for side, sign in (("R", 1.0), ("L", -1.0)):
        near, far = point + AXIS_GAP * sign * out, point + sign * out
        columns[side] = np.stack((near[:, 0], near[:, 1], far[:, 1], far[:, 0]), axis=2)
    return np.stack([columns[b[0]][:, int(b[1:]) - 1] for b in bellows], axis=1)


def section_widths(run: Trajectory) -> np.ndarray:
    """Size along x of every section (S,) [m]."""
    return np.array(run.section_widths or [run.width] * (len(run.bellows) // 2))


def body_widths(run: Trajectory) -> np.ndarray:
    """The same at every point of the drawn axis (K,) [m]."""
    sections = len(run.bellows) // 2
    # The end of a section belongs to it.
    place = np.ceil(run.arc / run.arc[-1] * sections - 1e-9).astype(int) - 1
    return np.asarray(section_widths(run)[np.clip(place, 0, sections - 1)])


def _interpolated(at: np.ndarray, arc: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values (N, K, 2) along the arc at places (2, S): (N, 2, S, 2)."""
    return np.array([np.stack([np.interp(at, arc, v[:, i]) for i in (0, 1)], -1) for v in values])
