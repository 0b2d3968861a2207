"""Measured curves of a bellow that snaps through: its pressure falls while it swells."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.curves import PiecewiseCubic

BRANCH_SAMPLES = 2001
"""Swellings at which the branch under increasing pressure is sampled."""


@dataclass(frozen=True, eq=False)
class SnapCurves:
    """Pressure, curvature and stretch of one bellow as functions of its swelling.

    Swelling: volume less that at zero gauge pressure, on the branch of the first rows [m^3].
    """

    pressure: PiecewiseCubic
    curvature: PiecewiseCubic
    stretch: PiecewiseCubic
    range: tuple[float, float]
    """Smallest and largest measured swelling [m^3]."""
    filled: float
    """Swelling at the pressure to which sealed parts are filled [m^3]."""

    @classmethod
    def through(
        cls, rows: np.ndarray, length: float, section: float, filled_at: float
    ) -> SnapCurves:
        """Interpolate rows (n, 4) of pressure, area, angle and extension, with increasing area.

        ``length`` of the bellow and ``section`` of its section [m]; ``filled_at`` [Pa].
        """
        pressure, area = rows[:, 0], rows[:, 1]
        law = PiecewiseCubic.monotone(area, pressure)
        falling = np.diff(pressure) < 0
        peak = int(np.argmax(falling)) if falling.any() else len(falling)
        rest = _crossing(law, area[: peak + 1], 0.0)
        swelling = length * (area - rest)
        angle, extension = (
            PiecewiseCubic.monotone(swelling, rows[:, k]).zeroed().scaled(1 / section)
            for k in (2, 3)
        )
        found = cls(
            PiecewiseCubic.monotone(swelling, pressure).zeroed(),
            angle,
            extension,
            (float(swelling[0]), float(swelling[-1])),
            0.0,
        )
        return replace(found, filled=found._first(filled_at))

    def loaded(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Swelling, curvature and stretch under pressures that change slowly from zero."""
        swelling = self._swelling(pressure)
        return swelling, self.curvature(swelling), self.stretch(swelling)

    def _swelling(self, pressure: np.ndarray) -> np.ndarray:
        """The first swelling that a pressure reaches if raised, or lowered, from zero."""
        low, high = self.range
        up = self._first_reached(np.maximum(pressure, 0.0), 1.0, high)
        down = self._first_reached(np.maximum(-pressure, 0.0), -1.0, -low)
        return np.asarray(up - down)

    def _first(self, pressure: float) -> float:
        """The first swelling of one pressure, to rounding error."""
        near = float(self._swelling(np.array(pressure)))
        step = (self.range[1] - self.range[0]) / BRANCH_SAMPLES
        ends = near - step, near + step
        values = [float(self.pressure(end)) - pressure for end in ends]
        if values[0] * values[1] > 0.0:  # at a maximum
            return near
        return _root(lambda s: float(self.pressure(s)) - pressure, *ends)

    def _first_reached(self, level: np.ndarray, side: float, end: float) -> np.ndarray:
        """Swelling (side 1) or shrinkage (-1) at which a pressure level is first reached.

        ``level`` of pressure [Pa] and ``end`` of the measured range [m^3] on that side, both >= 0.
        """
        span = self.range[1] - self.range[0]
        end = max(end, 0.0)
        last, beyond = (side * float(self.pressure(side * s)) for s in (end, end + span))
        reach = end + 1.1 * span * max(float(np.max(level)) - last, 0.0) / (beyond - last)
        samples = np.linspace(0.0, max(reach, span / BRANCH_SAMPLES), BRANCH_SAMPLES)
        highest = np.maximum.accumulate(side * self.pressure(side * samples))
        # On a plateau the bellow stops at its beginning and then snaps to its end.
        first = np.concatenate([[True], np.diff(highest) > 0.0])
        return np.asarray(np.interp(level, highest[first], samples[first]))


def _crossing(law: PiecewiseCubic, area: np.ndarray, pressure: float) -> float:
    """The area at which a rising part of a curve through ``area`` (n,) has a pressure."""
    ends = [float(law(a)) - pressure for a in (area[0], area[-1])]
    for end, value in zip(ends, (area[0], area[-1]), strict=True):
        if abs(end) <= 1e-12 * max(map(abs, ends)):
            return float(value)
    return _root(lambda a: float(law(a)) - pressure, area[0], area[-1])


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function changes its sign between two places, to rounding error."""
    from scipy.optimize import brentq

    return float(brentq(function, low, high, xtol=1e-300))
