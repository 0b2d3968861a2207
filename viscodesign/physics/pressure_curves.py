"""Measured curves of a bellow whose pressure determines what it does."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.curves import PiecewiseCubic


@dataclass(frozen=True, eq=False)
class PressureCurves:
    """Volume beyond rest [m^3], curvature [1/m] and stretch [1] against gauge pressure [Pa]."""

    volume: PiecewiseCubic
    curvature: PiecewiseCubic
    stretch: PiecewiseCubic

    @classmethod
    def through(cls, rows: np.ndarray, length: float, section: float) -> PressureCurves:
        """Interpolate rows (n, 4) of pressure, area, angle and extension, with increasing pressure.

        ``length`` of the bellow and ``section`` of its section [m].
        """
        pressure = rows[:, 0]
        return cls(
            *(
                PiecewiseCubic.monotone(pressure, rows[:, k + 1]).zeroed().scaled(factor)
                for k, factor in enumerate((length, 1 / section, 1 / section))
            )
        )

    def loaded(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """All three at pressures of any shape."""
        return self.volume(pressure), self.curvature(pressure), self.stretch(pressure)
