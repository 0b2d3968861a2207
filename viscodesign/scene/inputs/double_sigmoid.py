"""`kind: double_sigmoid`: the paper's pulse."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from viscodesign.scene.inputs.base import SWING_END, SmoothInput
from viscodesign.scene.spec_part import copied
from viscodesign.storage.distinct import distinct
from viscodesign.units import Pressure, PressureLevel, Time


class DoubleSigmoidInput(SmoothInput):
    r"""Fall and rise: start - drop s(t - fall_time) + drop s(t - rise_time).

    .. math:: s(t) = 1 / (1 + \exp(-2 k t)), \quad k = 6 / \text{transition}

    Source: the paper, section 2.1 (boundary condition) and Figure 3.
    """

    name: ClassVar[str] = "double_sigmoid"
    coefficients: ClassVar[int] = 6
    kind: Literal["double_sigmoid"]
    start: PressureLevel = Field(
        description="Gauge pressure above the baseline before and after the pulse"
    )
    drop: Pressure = Field(description="Height of the fall")
    fall_time: Time = Field(ge=0, description="Centre of the fall")
    rise_time: Time = Field(ge=0, description="Centre of the rise")
    transition: Time = Field(gt=0, description="Duration of a transition, 6/k")

    @classmethod
    def expression(cls, t: Any, piece: Any, functions: Any) -> Any:
        start, drop, fall_time, rise_time, rate = (piece[k] for k in range(5))
        fall = (1 + functions.tanh(rate * (t - fall_time))) / 2
        rise = (1 + functions.tanh(rate * (t - rise_time))) / 2
        return start - drop * fall + drop * rise

    def numbers(self) -> tuple[float, ...]:
        """Start, drop, centres of fall and rise [s], and rate of both [1/s]."""
        return self.start, self.drop, self.fall_time, self.rise_time, 6 / self.transition

    def later(self, delay: float) -> DoubleSigmoidInput:
        times = {"fall_time": self.fall_time + delay, "rise_time": self.rise_time + delay}
        return copied(self, times)

    def corners(self, duration: float) -> list[float]:
        """Where each transition begins: a solver with large steps could skip it."""
        begins = (self.fall_time - self.transition, self.rise_time - self.transition)
        return list(distinct([t for t in begins if 0.0 < t < duration]).tolist())

    def extremes(self, duration: float) -> tuple[float, float]:
        """At the ends and midway between fall and rise, where the two slopes cancel."""
        middle = (self.fall_time + self.rise_time) / 2
        found = self.values(np.array([0.0, min(middle, duration), duration]))
        return float(found.min()), float(found.max())

    def swing_time(self) -> float:
        """Duration of a single sigmoid: ln 99 / k."""
        if self.drop == 0.0:
            return math.inf
        return math.log(SWING_END / (1 - SWING_END)) * self.transition / 6
