"""What hangs on the pins of a board: the pressure sensor and the limit switches."""

from __future__ import annotations

from dataclasses import dataclass, field

from viscodesign.pump.sensors.phidget_1140 import HIGHEST_RATIO, LOWEST_RATIO, ratio_of
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.plant import AMBIENT
from viscodesign.scene.per_inlet import each

SWITCH_DISTANCE = 10
"""Counts behind the ends of travel at which the limit switches stand."""


@dataclass
class Pins:
    """Read by the firmwares: each plunger's sensor and switches, as the spec names them."""

    bench: SimulatedBench
    ambient: float = AMBIENT
    """Absolute [Pa]."""
    broken: dict[str, float] = field(default_factory=dict)
    """Pins that give one value whatever happens: 'A0' a ratio, 'D1' a level."""

    def analog(self, channel: int) -> float:
        """Voltage over supply; nothing hangs on other channels, which float about zero."""
        name = f"A{channel}"
        if name in self.broken:
            return self.broken[name]
        sensors = each(self.bench.drives[0].pump.sensor, len(self.bench.servos))
        for sensor, pressure in zip(sensors, self.bench.pressures, strict=True):
            if sensor is not None and sensor.channel == channel:
                ratio = ratio_of(self.ambient + float(pressure))
                return min(max(ratio, LOWEST_RATIO), HIGHEST_RATIO)
        return 0.0

    def high(self, pin: int, pulled_up: bool) -> bool:
        """Level of a digital pin; an open one is high only where it is pulled up."""
        name = f"D{pin}"
        if name in self.broken:
            return bool(self.broken[name])
        return pulled_up and not self._grounded(name)

    def _grounded(self, name: str) -> bool:
        """Whether a switch connects the pin to ground now."""
        pump, servos = self.bench.drives[0].pump, self.bench.servos
        low, high = pump.travel
        pairs = zip(servos, each(pump.limit_switches, len(servos)), strict=True)
        for servo, switches in pairs:
            if switches is not None and name in (switches.low, switches.high):
                beyond = (
                    servo.position < low - SWITCH_DISTANCE
                    if name == switches.low
                    else servo.position > high + SWITCH_DISTANCE
                )
                return beyond == (switches.normally == "open")
        return False
