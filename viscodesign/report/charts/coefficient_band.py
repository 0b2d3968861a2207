"""Where the tip may be by what is known of the coefficients, along its path."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection

from viscodesign.results.coefficient_band import COVERAGE_FACTOR
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_ELLIPSES = 600
BAND = "#c3d3e6"


def band_corners(trajectory: Trajectory) -> np.ndarray:
    """Corners (n, 2) [mm] of a frame about the band; none where none is known."""
    band = trajectory.uncertainty
    if band is None:
        return np.zeros((0, 2))
    around = COVERAGE_FACTOR * band.deviation
    tip = trajectory.tip[:, :2]
    return np.asarray(1e3 * np.stack([(tip - around).min(axis=0), (tip + around).max(axis=0)]))


def draw_band(axes: Axes, trajectory: Trajectory) -> None:
    """Draw 95 % ellipses [mm] about the tip at many times; nothing where none are known."""
    band = trajectory.uncertainty
    if band is None:
        return
    rows = np.unique(np.linspace(0, len(band.time) - 1, MOST_ELLIPSES).round().astype(int))
    around = [1e3 * (trajectory.tip[row, :2] + band.ellipse(row)) for row in rows]
    axes.add_collection(PolyCollection(around, facecolors=BAND, edgecolors=BAND, zorder=2))
