"""Rules that stop the pump by what its pressure sensors read."""

from __future__ import annotations

from dataclasses import field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.guard import NOISE_SAMPLES, Guard

FROZEN_PRESSURE_CHANGE = 6e3
"""A reading that stays the same to the last bit while the model's pressure changes by this
much is none [Pa]; the sensor is good to 1.5 % of its span, 5.7 kPa."""


@dataclass
class PressureCap(Guard):
    """No inlet above the cap in two samples; a sample without a number counts as above."""

    rule = "pressure_cap"
    may_retreat = True
    cap: float
    """Gauge [Pa]."""
    above: dict[int, int] = field(default_factory=dict, init=False)
    """By inlet, samples in succession."""

    def _fault(self, sample: Sample) -> str | None:
        broken = None
        for inlet, pressure in enumerate(sample.pressure):
            # Not `pressure > cap`: a nan is to count as above.
            over = pressure is not None and not pressure <= self.cap
            self.above[inlet] = self.above.get(inlet, 0) + 1 if over else 0
            if broken is None and self.above[inlet] >= NOISE_SAMPLES:
                broken = (
                    f"{(pressure or 0.0) / 1e3:.2f} kPa gauge in {NOISE_SAMPLES} samples"
                    f"{sample.inlet_words(inlet)}; the limit is {self.cap / 1e3:g} kPa "
                    "(pump.max_pressure)"
                )
        return broken


@dataclass
class SensorFrozen(Guard):
    """A reading that stays constant while the model's pressure changes is not valid."""

    rule = "sensor_frozen"
    still: dict[int, tuple[float, float, float]] = field(default_factory=dict, init=False)
    """By inlet: its reading, lowest and highest expected pressure since that changed [Pa]."""

    def _fault(self, sample: Sample) -> str | None:
        pairs = zip(sample.pressure, sample.wanted, strict=True)
        for inlet, (measured, expected) in enumerate(pairs):
            if measured is None or expected is None:
                self.still.pop(inlet, None)
                continue
            reading, low, high = self.still.get(inlet, (measured, expected, expected))
            if measured != reading:
                low = high = expected
            low, high = min(low, expected), max(high, expected)
            self.still[inlet] = (measured, low, high)
            if high - low > FROZEN_PRESSURE_CHANGE:
                return (
                    f"the pressure sensor is frozen: it kept reading {measured / 1e3:.2f} kPa "
                    f"while the pressure should have changed by {(high - low) / 1e3:.1f} kPa"
                    f"{sample.inlet_words(inlet)}. Check its cable, and the hose for a leak"
                )
        return None
