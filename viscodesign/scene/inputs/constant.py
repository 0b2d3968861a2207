"""`kind: constant`."""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.units import Pressure


class Constant(PiecewiseLinear):
    """One pressure, held."""

    name: ClassVar[str] = "constant"
    kind: Literal["constant"]
    value: Pressure = Field(description="Gauge pressure above the baseline")

    def vertices(self, duration: float) -> list[tuple[float, float]]:
        return [(0.0, self.value), (duration, self.value)]

    def initial(self) -> float:
        return float(self.value)

    def profile(self) -> list[tuple[float, float]]:
        return self.vertices(1.0)
