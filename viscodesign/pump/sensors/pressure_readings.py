"""Gauge pressure at each inlet."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from viscodesign.pump.sensors.pressure_sensors import SensorError

LARGEST_OFFSET = 6e3
"""A reading at rest this close to the ambient is the sensor's own error [Pa]: 1.5 % of span."""


class PressureReadings:
    """S inlets, each with a function that reads its absolute pressure [Pa], or None."""

    def __init__(
        self,
        sensors: Sequence[Callable[[], float] | None],
        ambient: float,
        names: Sequence[str] = (),
        exact: Sequence[int] = (),
    ) -> None:
        """``ambient``: absolute [Pa]; ``names`` of the inlets, for messages.

        ``exact``: inlets whose reading at rest is no error, such as what a regulator holds.
        """
        several = len(sensors) > 1 and len(names) == len(sensors)
        self.prefixes = tuple(f"{name}: " for name in names) if several else ("",) * len(sensors)
        self.sensors = tuple(sensors)
        self.ambient = ambient
        self.exact = frozenset(exact)
        self.offsets = [0.0 for _ in sensors]  # subtracted from each reading [Pa]

    def zero(self) -> list[str]:
        """Take small readings at rest as the sensors' own errors; returns a note for each.

        To be called before anything moves. A larger reading is taken as pressure that is there,
        so that a cap does not shift with it.
        """
        notes = []
        for k, measured in enumerate(self.read()):
            if measured is None or k in self.exact:
                continue
            shows = f"{self.prefixes[k]}{measured / 1e3:+.2f} kPa"
            if abs(measured) <= LARGEST_OFFSET:
                self.offsets[k] = measured
                notes.append(f"{shows} at rest is taken as the sensor's own error")
            else:
                notes.append(
                    f"{shows} gauge at rest: more than the sensor's error, so taken as pressure; "
                    "vent it, or correct ambient_pressure"
                )
        return notes

    def read(self) -> tuple[float | None, ...]:
        """Gauge pressure at each inlet [Pa]; raises `PumpError` where a sensor gives none."""
        return tuple(self._gauge(k) for k in range(len(self.sensors)))

    def _gauge(self, inlet: int) -> float | None:
        sensor = self.sensors[inlet]
        if sensor is None:
            return None
        try:
            return float(sensor()) - self.ambient - self.offsets[inlet]
        except SensorError as error:
            raise SensorError(f"{self.prefixes[inlet]}{error}") from None
