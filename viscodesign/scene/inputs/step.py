"""`kind: step`."""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.units import PressureLevel, Time


class StepInput(PiecewiseLinear):
    """A step from the baseline to a pressure."""

    name: ClassVar[str] = "step"
    kind: Literal["step"]
    value: PressureLevel = Field(description="Gauge pressure above the baseline after the step")
    time: Time = Field(0.0, ge=0, description="Time of the step")

    def vertices(self, duration: float) -> np.ndarray:
        before = [(0.0, 0.0), (self.time, 0.0)] if self.time > 0 else []
        end = max(duration, self.time) + 1.0
        return np.array([*before, (self.time, self.value), (end, self.value)])

    def initial(self) -> float:
        return 0.0

    def profile(self) -> list[tuple[float, float]]:
        return [(0.0, 0.0), (0.0, self.value)]
