"""`kind: square`."""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field, model_validator

from viscodesign.scene.inputs.base import PiecewiseLinear, periods_to_cover, points_of
from viscodesign.scene.spec_part import invalid_at
from viscodesign.units import Fraction, Frequency, PressureLevel


class SquareInput(PiecewiseLinear):
    """A square wave: high for the duty cycle of every period, then low."""

    name: ClassVar[str] = "square"
    kind: Literal["square"]
    high: PressureLevel = Field(description="Gauge pressure above the baseline, first level")
    low: PressureLevel = Field(description="Gauge pressure above the baseline, second level")
    frequency: Frequency = Field(gt=0, description="Frequency")
    duty: Fraction = Field(
        0.5, gt=0, lt=1, description="Duty cycle, the high fraction of a period", examples=["50 %"]
    )

    @model_validator(mode="after")
    def _check_levels(self) -> SquareInput:
        if self.high < self.low:
            raise invalid_at(
                "high", f"must be at least low, {self.low:g} Pa; got {self.high:g} Pa. Swap the two"
            )
        return self

    @property
    def period(self) -> float:
        return 1.0 / self.frequency

    def vertices(self, duration: float) -> np.ndarray:
        start = np.arange(float(periods_to_cover(duration * self.frequency)))
        times = np.stack((start, start + self.duty, start + self.duty, start + 1), axis=1)
        values = np.tile((self.high, self.high, self.low, self.low), len(start))
        return np.column_stack((times.reshape(-1) / self.frequency, values))

    def initial(self) -> float:
        return self.high

    def profile(self) -> list[tuple[float, float]]:
        return points_of(self.vertices(1.0 / self.frequency))
