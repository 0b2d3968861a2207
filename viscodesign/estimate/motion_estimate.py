"""A quick estimate of the motion: good to tens of percent, in milliseconds.

It answers one question: how far does the tip move when a term is added or removed?
Linear throughout, each part exact or a well-known first estimate:

- the network is a linear one, solved mode by mode for the input as it is; what is not
  linear enters by its mean over the motion (`network_estimate`);
- the axis is a row of arcs with the curvature that the pressures give; loads bend it
  further by their moments about it (`loaded_axis`);
- inertial forces are those of the first bending mode and the first stretching mode.

A term contributes to the sums of an estimate as it does to those of the balances
(`EstimateTerm`); which terms exist is not known here. Estimates with different terms are computed
side by side (`tips`), as most of the time of one goes into calls, not into numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.estimate.network_estimate import NetworkEstimate
from viscodesign.estimate.setting import EstimateSetting
from viscodesign.estimate.swinging_rods import SwingingRods
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class MotionEstimate:
    """The motion that follows from a set of terms."""

    setting: EstimateSetting
    terms: tuple[EstimateTerm, ...] = ()

    def plus(self, *terms: EstimateTerm) -> MotionEstimate:
        """The same with more terms."""
        return replace(self, terms=(*self.terms, *terms))

    @cached_property
    def network(self) -> NetworkEstimate:
        """Pressures and flows."""
        return NetworkEstimate.of(self.setting, self.terms)

    @cached_property
    def _path(self) -> np.ndarray:
        """The tip x, z at every sample (2, T) [m]."""
        return np.asarray(tips([self])[0])

    @property
    def tip(self) -> np.ndarray:
        """The tip at every sample (T, 2) [m]."""
        return self._path.T

    def distance(self, other: MotionEstimate) -> float:
        """Largest distance of the two tips over the output times [m]."""
        return tip_distance(self.setting, self._path, other._path)

    def bending_rate(self) -> float:
        """Angular frequency of the first bending mode [1/s]."""
        return float(_rods([self]).bending_rate[0])

    def axial_rate(self) -> float:
        """Angular frequency of the first stretching mode [1/s]."""
        return float(_rods([self]).axial_rate[0])


def tips(estimates: Sequence[MotionEstimate]) -> np.ndarray:
    """The tips of estimates of one setting x, z at every sample (S, 2, T) [m]."""
    return _rods(estimates).tips()


def tip_distance(setting: EstimateSetting, one: np.ndarray, other: np.ndarray) -> float:
    """Largest distance of two tips (2, T) over the output times [m]."""
    apart = (one - other)[:, setting.output_mask]
    found = float(np.max(np.hypot(apart[0], apart[1])))
    return found if math.isfinite(found) else math.inf


def _rods(estimates: Sequence[MotionEstimate]) -> SwingingRods:
    networks, terms = [one.network for one in estimates], [one.terms for one in estimates]
    return SwingingRods(estimates[0].setting, networks, terms)
