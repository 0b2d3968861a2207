"""What hangs on the pins of a board: the pressure sensor and the limit switches."""

from __future__ import annotations

from dataclasses import dataclass, field

from viscodesign.pumps.sensors.phidget_1140 import HIGHEST_RATIO, LOWEST_RATIO, ratio_of
from viscodesign.pumps.virtual.bench import Bench
from viscodesign.pumps.virtual.plant import AMBIENT

SWITCH_DISTANCE = 10
"""Counts behind the ends of travel at which the limit switches stand."""


@dataclass
class Pins:
    """Read by the firmwares; the first plunger's sensor and switches."""

    bench: Bench
    ambient: float = AMBIENT
    """Absolute [Pa]."""
    broken: dict[str, float] = field(default_factory=dict)
    """Pins that give one value whatever happens: 'A0' a ratio, 'D1' a level."""

    def analog(self, channel: int) -> float:
        """Voltage over supply; nothing hangs on other channels, which float about zero."""
        pump = self.bench.drives[0].pump
        name = f"A{channel}"
        if name in self.broken:
            return self.broken[name]
        if pump.sensor is None or pump.sensor.channel != channel:
            return 0.0
        ratio = ratio_of(self.ambient + float(self.bench.pressures[0]))
        return min(max(ratio, LOWEST_RATIO), HIGHEST_RATIO)

    def high(self, pin: int, pulled_up: bool) -> bool:
        """Level of a digital pin; an open one is high only where it is pulled up."""
        name = f"D{pin}"
        if name in self.broken:
            return bool(self.broken[name])
        return pulled_up and not self._grounded(name)

    def _grounded(self, name: str) -> bool:
        """Whether a switch connects the pin to ground now."""
        pump = self.bench.drives[0].pump
        if pump.limit_switches is None:
            return False
        switches = pump.limit_switches
        low, high = pump.travel
        count = self.bench.servos[0].position
        pressed = {
            switches.low: count < low - SWITCH_DISTANCE,
            switches.high: count > high + SWITCH_DISTANCE,
        }
        return name in pressed and pressed[name] == (switches.normally == "open")
