"""Pressure at each inlet above the ambient."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from viscodesign.pump.sensors.base import SensorError

TRIM = 6e3
"""A sensor at rest this close to the ambient shows its own error [Pa]: 1.5 % of its span."""


class PressureReadings:
    """S inlets, each with what reads its absolute pressure [Pa], or None; and the ambient [Pa]."""

    def __init__(
        self,
        sensors: Sequence[Callable[[], float] | None],
        ambient: float,
        names: Sequence[str] = (),
    ) -> None:
        """``names`` of the inlets, to tell which one is meant where there are several."""
        several = len(sensors) > 1 and len(names) == len(sensors)
        self.before = tuple(f"{name}: " for name in names) if several else ("",) * len(sensors)
        """What stands before words about each."""
        self.sensors = tuple(sensors)
        self.ambient = ambient
        self.offsets = [0.0 for _ in sensors]
        """Taken off what each one reads [Pa]."""

    def zero(self) -> list[str]:
        """Take what each shows at rest as its own error, where it may be that; says what it did.

        To be called before anything moves. A reading farther from the ambient is taken as
        pressure that is there, so that a cap does not move away with it.
        """
        told = []
        for k, measured in enumerate(self.read()):
            if measured is None:
                continue
            shows = f"{self.before[k]}{measured / 1e3:+.2f} kPa"
            if abs(measured) <= TRIM:
                self.offsets[k] = measured
                told.append(f"{shows} at rest is taken as the sensor's own error")
            else:
                told.append(
                    f"{shows} gauge at rest: more than the sensor's error, so taken as pressure; "
                    "vent it, or correct ambient_pressure"
                )
        return told

    def read(self) -> tuple[float | None, ...]:
        """Gauge pressure at each inlet [Pa]; raises `PumpError` where a sensor gives none."""
        return tuple(self._gauge(k) for k in range(len(self.sensors)))

    def _gauge(self, inlet: int) -> float | None:
        sensor = self.sensors[inlet]
        if sensor is None:
            return None
        try:
            absolute = float(sensor())
        except SensorError as error:
            raise SensorError(f"{self.before[inlet]}{error}") from None
        return absolute - self.ambient - self.offsets[inlet]
