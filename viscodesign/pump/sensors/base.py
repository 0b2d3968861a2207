"""What every source of pressures can be asked."""

from __future__ import annotations

from abc import ABC, abstractmethod

from viscodesign.errors import PumpError
from viscodesign.pump.sensors import phidget_1140


class SensorError(PumpError):
    """The pressure is not known: the sensor is open, shorted, frozen or out of its range."""


class PressureSource(ABC):
    """An absolute sensor; gauge pressures take off the ambient one and its error at rest."""

    @abstractmethod
    def ratio(self) -> float:
        """What the sensor says now, over its supply."""

    @abstractmethod
    def close(self) -> None:
        """Let go of it; a second time does nothing."""

    def absolute(self) -> float:
        """Pressure [Pa]; raises `SensorError` where the sensor says nothing of it."""
        ratio = self.ratio()
        if not phidget_1140.LOWEST_RATIO <= ratio <= phidget_1140.HIGHEST_RATIO:
            raise SensorError(
                f"the pressure sensor is open or shorted: it gives {ratio:.3f} of its supply. "
                "Check its plug and its channel (`pump.sensor.channel`)"
            )
        pressure = phidget_1140.absolute_pressure(ratio)
        if not phidget_1140.LOWEST <= pressure <= phidget_1140.HIGHEST:
            raise SensorError(
                f"{pressure / 1e3:.1f} kPa absolute is outside the pressure sensor's range, "
                "20 to 400 kPa"
            )
        return pressure


class Stillness:
    """Tells a frozen sensor: one value to the last bit while the pressure must have changed."""

    def __init__(self, least_change: float = 2 * phidget_1140.ACCURACY) -> None:
        self.least_change = least_change
        """Of the expected pressure [Pa], by which a live sensor says something else."""
        self._value: float | None = None
        self._expected = (0.0, 0.0)
        """Lowest and highest expected pressure since the value came first [Pa]."""

    def check(self, value: float, expected: float) -> None:
        """A reading and what it should be about; raises `SensorError` where it is frozen."""
        if value != self._value:
            self._value, self._expected = value, (expected, expected)
            return
        low, high = min(self._expected[0], expected), max(self._expected[1], expected)
        self._expected = low, high
        if high - low > self.least_change:
            raise SensorError(
                f"the pressure sensor is frozen: it kept reading {value / 1e3:.2f} kPa "
                f"while the pressure should have changed by {(high - low) / 1e3:.1f} kPa"
            )
