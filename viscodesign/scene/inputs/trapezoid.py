"""`kind: trapezoid`."""

from __future__ import annotations

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field, model_validator

from viscodesign.scene.inputs.base import PiecewiseLinear, periods_to_cover, points_of
from viscodesign.scene.spec_part import invalid
from viscodesign.units import PressureLevel, Time


class TrapezoidInput(PiecewiseLinear):
    """A periodic trapezoid: rise from low to high, hold, fall to low, rest."""

    name: ClassVar[str] = "trapezoid"
    kind: Literal["trapezoid"]
    high: PressureLevel = Field(description="Gauge pressure above the baseline while held")
    low: PressureLevel = Field(0.0, description="Gauge pressure above the baseline at rest")
    rise: Time = Field(ge=0, description="Time from low to high")
    hold: Time = Field(0.0, ge=0, description="Time at high")
    fall: Time = Field(ge=0, description="Time from high to low")
    rest: Time = Field(0.0, ge=0, description="Time at low")

    @model_validator(mode="after")
    def _check_period(self) -> TrapezoidInput:
        if self.period <= 0.0:
            raise invalid("rise, hold, fall and rest are all 0 s; the period must be above 0 s")
        return self

    @property
    def period(self) -> float:
        """Duration of a cycle [s]."""
        return self.rise + self.hold + self.fall + self.rest

    def vertices(self, duration: float) -> np.ndarray:
        cycles = periods_to_cover(duration / self.period)
        start = np.arange(cycles) * self.period
        top = start + self.rise
        end = top + self.hold
        times = np.stack((start, top, end, end + self.fall), axis=1).reshape(-1)
        values = np.tile((self.low, self.high, self.high, self.low), cycles)
        last = (cycles * self.period, self.low)
        return np.concatenate([np.column_stack((times, values)), [last]])

    def initial(self) -> float:
        return self.low

    def profile(self) -> list[tuple[float, float]]:
        return points_of(self.vertices(1.5 * self.period))
