"""`kind: ramp_hold`: an input kind in one file.

docs/extending.md has the contract of an input kind and says how the package finds this file.
"""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.units import Pressure, Time


class RampHold(PiecewiseLinear):
    """Rises from the baseline at a constant rate, then holds its level."""

    name: ClassVar[str] = "ramp_hold"
    kind: Literal["ramp_hold"]
    level: Pressure = Field(description="Gauge pressure above the baseline while held")
    ramp: Time = Field(gt=0, description="Time from the baseline to the level")

    def vertices(self, duration: float) -> np.ndarray:
        end = max(duration, self.ramp) + 1.0  # past the end of the run, so that the hold has a line
        return np.array([(0.0, 0.0), (self.ramp, self.level), (end, self.level)])

    def initial(self) -> float:
        return 0.0

    def profile(self) -> list[tuple[float, float]]:
        return [(0.0, 0.0), (self.ramp, self.level)]
