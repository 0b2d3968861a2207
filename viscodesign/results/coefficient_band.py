"""How uncertain the tip is by the coefficients of its spec: the error that no mesh removes.

Plain data. To the first order in the deviations of independent numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice, json_ready
from viscodesign.storage.cached_property import cached_property

COVERAGE = 0.95
COVERAGE_FACTOR = 1.959963984540054
"""Half-width of the middle 95 % of a normal distribution, in standard deviations."""
STILL_M = 1e-12
"""Half-width below which a band has none [m]."""
STILL_WORDS = "none: no stated number moves the tip"
"""What is said of such a band in place of its width."""
MIN_ASPECT = 1e-3
"""Width over length below which an ellipse is drawn as if it had that width."""
NO_SHARED_BAND = (
    "a band of the coefficients (`uncertainty`) is not supported of actuators that share fluid"
)
"""The note of a run that cannot have one."""
BAND_COLUMNS = ("time_s", "tip_x_sd_m", "tip_z_sd_m", "tip_xz_covariance_m2")
"""Columns of `uncertainty.csv`."""


@dataclass(frozen=True)
class UncertainNumber:
    """A number of the spec, how well it is known, and what that does to the tip."""

    key: str
    """Key of the spec."""
    value: float
    """[unit]"""
    unit: str
    """In SI, "1" for a ratio."""
    deviation: float
    """One standard deviation [unit]."""
    assumed: bool
    """Whether it is a typical one, which the spec does not state."""
    share: float
    """Share of the variance of the tip's place, over all output times [1]."""


@dataclass(frozen=True, eq=False)
class CoefficientBand:
    """Variances of the tip's place at the output times."""

    covariance: np.ndarray
    """(T, 3): variances of x and z, and their covariance [m2]."""
    time: np.ndarray
    """(T,) [s]"""
    numbers: tuple[UncertainNumber, ...]
    """Those that contribute most come first."""
    left_out: tuple[tuple[str, str], ...] = ()
    """Keys that were stated or assumed and do not count, and why."""
    wall_s: float = 0.0
    """What it cost [s]."""

    @property
    def deviation(self) -> np.ndarray:
        """(T, 2) standard deviations of x and z [m]."""
        return np.asarray(np.sqrt(self.covariance[:, :2]))

    @cached_property
    def axes(self) -> tuple[np.ndarray, np.ndarray]:
        """Standard deviations (T, 2) [m] along the principal directions, least first, and these
        (T, 2, 2), one in each column."""
        xx, zz, xz = self.covariance.T
        sizes, directions = np.linalg.eigh(np.stack([xx, xz, xz, zz], axis=1).reshape(-1, 2, 2))
        return np.sqrt(np.maximum(sizes, 0.0)), directions

    @property
    def worst_row(self) -> int:
        """Output time at which the tip is most uncertain."""
        return int(np.argmax(self.axes[0][:, 1]))

    @property
    def half_width_m(self) -> float:
        """Half of the 95 % interval at that time, in the direction that is most uncertain [m]."""
        return COVERAGE_FACTOR * float(self.axes[0][self.worst_row, 1])

    @property
    def is_still(self) -> bool:
        """Whether no number moves the tip."""
        return self.half_width_m < STILL_M

    @property
    def is_assumed(self) -> bool:
        """Whether any deviation is a typical one."""
        return any(number.assumed for number in self.numbers)

    def ellipse(self, row: int, points: int = 48) -> np.ndarray:
        """x, z (points, 2) [m] about the tip, within which it is in both directions at 95 %."""
        sizes, directions = self.axes
        angle = np.linspace(0.0, 2 * math.pi, points, endpoint=False)
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        return np.asarray(COVERAGE_FACTOR * (circle * sizes[row]) @ directions[row].T)

    def document(self) -> dict[str, Any]:
        """As `summary.json` has it."""
        deviation = self.deviation.max(axis=0, initial=0.0)
        document = {
            "half_width_95_m": self.half_width_m,
            "time_s": self.time[self.worst_row],
            "tip_x_sd_max_m": deviation[0],
            "tip_z_sd_max_m": deviation[1],
            "method": "exact first derivatives; numbers normal and independent",
            "keys": [
                {
                    "key": number.key,
                    "value": number.value,
                    "unit": number.unit,
                    "standard_deviation": number.deviation,
                    "assumed": number.assumed,
                    "share_of_variance": number.share,
                }
                for number in self.numbers
            ],
            "left_out": [{"key": key, "reason": why} for key, why in self.left_out],
            "wall_s": self.wall_s,
        }
        return dict(json_ready(document))


def swept_ellipses(
    tip: np.ndarray, band: CoefficientBand, most: int, points: int = 48
) -> np.ndarray:
    """(n, points, 2) What 95 % ellipses sweep about a tip (T, 2) [m], in as many as ``most`` parts.

    Each part is the convex hull of two that follow each other: single ones would leave gaps where
    the tip is fast. A corner is that of both that lies farther in one direction; directions are
    spread such that corners are even on the mean ellipse.
    """
    rows = np.unique(np.linspace(0, len(band.time) - 1, most + 1).round().astype(int))
    xx, zz, xz = band.covariance[rows].T
    spread = np.stack([xx, xz, xz, zz], axis=1).reshape(-1, 2, 2)
    pairs = np.stack([spread[:-1], spread[1:]]) if len(rows) > 1 else np.stack([spread, spread])
    ends = np.stack([tip[rows[:-1]], tip[rows[1:]]]) if len(rows) > 1 else tip[None, rows][[0, 0]]
    sizes, axes = np.linalg.eigh(pairs.mean(axis=0))
    sizes = np.sqrt(np.maximum(sizes, MIN_ASPECT**2 * sizes[:, 1:] + STILL_M**2))
    angle = np.linspace(0.0, 2 * math.pi, points, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    normal = np.einsum("nij,nj,pj->npi", axes, 1 / sizes, circle)
    pull = np.einsum("enij,npj->enpi", pairs, normal)
    length = np.sqrt(np.maximum(np.einsum("enpi,npi->enp", pull, normal), 0.0))
    offset = pull / np.where(length > 0.0, length, 1.0)[..., None]
    corners = ends[:, :, None] + COVERAGE_FACTOR * offset
    reach = np.einsum("enpi,npi->enp", corners, normal)
    return np.asarray(np.where((reach[0] >= reach[1])[..., None], corners[0], corners[1]))


def why_no_band(warnings: Iterable[Notice], notes: Iterable[str], spec_text: str) -> str:
    """What is said of the error by the coefficients where a run has no band."""
    if any(own.code == "no_band" for own in warnings):
        return "unknown (see the warnings)"
    if NO_SHARED_BAND in notes:
        return "unknown (see the note)"
    if any(line.startswith("uncertainty:") for line in spec_text.splitlines()):
        return "left out"
    return "unknown (`uncertainty: typical` gives a first band)"
