"""`kind: sine`."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from viscodesign.scene.inputs.base import SWING_START, SmoothInput
from viscodesign.scene.spec_part import copied
from viscodesign.units import Angle, Frequency, Pressure, PressureLevel


class SineInput(SmoothInput):
    """A sine: mean + amplitude sin(2 pi frequency t + phase)."""

    name: ClassVar[str] = "sine"
    coefficients: ClassVar[int] = 4
    kind: Literal["sine"]
    amplitude: Pressure = Field(description="Amplitude, half of the peak-to-peak value")
    frequency: Frequency = Field(gt=0, description="Frequency")
    phase: Angle = Field(0.0, description="Phase at t = 0")
    mean: PressureLevel = Field(0.0, description="Mean gauge pressure above the baseline")

    @property
    def period(self) -> float:
        return 1.0 / self.frequency

    @classmethod
    def expression(cls, t: Any, piece: Any, functions: Any) -> Any:
        mean, amplitude, rate, phase = (piece[k] for k in range(4))
        return mean + amplitude * functions.sin(rate * t + phase)

    def numbers(self) -> tuple[float, ...]:
        """Mean, amplitude, angular frequency [rad/s] and phase."""
        return self.mean, self.amplitude, 2 * math.pi * self.frequency, self.phase

    def later(self, delay: float) -> SineInput:
        return copied(self, {"phase": self.phase - 2 * math.pi * self.frequency * delay})

    def corners(self, duration: float) -> list[float]:
        return []

    def extremes(self, duration: float) -> tuple[float, float]:
        """The peaks that the run contains, and its ends."""
        first = self.phase / (2 * math.pi)
        last = first + self.frequency * duration
        ends = [float(v) for v in self.values(np.array([0.0, duration]))]
        # Peaks lie at 1/4, 3/4, 5/4, ... turns, alternately up and down.
        peaks = [
            self.mean + sign * self.amplitude
            for turn, sign in ((0.25, 1.0), (0.75, -1.0))
            if math.floor(last - turn) >= math.ceil(first - turn)
        ]
        return min([*ends, *peaks]), max([*ends, *peaks])

    def swing_time(self) -> float:
        if self.amplitude == 0.0:
            return math.inf
        return (math.pi - 2 * math.acos(1 - 2 * SWING_START)) / (2 * math.pi * self.frequency)
