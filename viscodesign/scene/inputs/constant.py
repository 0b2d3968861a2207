"""`kind: constant`."""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from viscodesign.scene.inputs.base import PiecewiseLinear, points_of
from viscodesign.units import PressureLevel


class ConstantInput(PiecewiseLinear):
    """A constant pressure."""

    name: ClassVar[str] = "constant"
    kind: Literal["constant"]
    value: PressureLevel = Field(description="Gauge pressure above the baseline")

    def vertices(self, duration: float) -> np.ndarray:
        return np.array([(0.0, self.value), (duration, self.value)])

    def initial(self) -> float:
        return self.value

    def profile(self) -> list[tuple[float, float]]:
        return points_of(self.vertices(1.0))
