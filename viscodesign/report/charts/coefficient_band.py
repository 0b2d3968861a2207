"""Where the tip may be by what is known of the coefficients, along its path."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection

from viscodesign.report.layout.look import look
from viscodesign.results.coefficient_band import COVERAGE_FACTOR, CoefficientBand, swept_ellipses
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MAX_ELLIPSES = 600


def band_corners(trajectory: Trajectory) -> np.ndarray:
    """Corners (n, 2) [mm] of a frame about the band; none where none is known."""
    return corners_about(trajectory.tip[:, :2], trajectory.uncertainty)


def corners_about(tip: np.ndarray, band: CoefficientBand | None) -> np.ndarray:
    """Corners (n, 2) [mm] of a frame about the band of a tip (T, 2) [m]; none without one."""
    if band is None:
        return np.zeros((0, 2))
    around = COVERAGE_FACTOR * band.deviation
    return np.asarray(1e3 * np.stack([(tip - around).min(axis=0), (tip + around).max(axis=0)]))


def draw_band(axes: Axes, trajectory: Trajectory) -> None:
    """Draw what 95 % ellipses [mm] about the tip sweep; nothing where none are known."""
    if trajectory.uncertainty is not None:
        draw_ellipses(axes, trajectory.tip[:, :2], trajectory.uncertainty)


def draw_ellipses(axes: Axes, tip: np.ndarray, band: CoefficientBand) -> None:
    """Draw what 95 % ellipses [mm] about a tip (T, 2) [m] sweep."""
    around = [1e3 * own for own in swept_ellipses(tip, band, MAX_ELLIPSES)]
    colour = look().band
    axes.add_collection(PolyCollection(around, facecolors=colour, edgecolors=colour, zorder=2))
