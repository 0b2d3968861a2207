"""An open connection to a board, and what is known of the pump behind it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.byte_log import ByteLog
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sensors.pressure_sensors import board_sensor, phidget_sensor
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.base import SensorSpec
from viscodesign.storage.cached_property import cached_property

if TYPE_CHECKING:
    from viscodesign.pump.kinds.base import PumpKind


@dataclass(frozen=True)
class Connection:
    """An open board, and what is known of the pump behind it."""

    kind: PumpKind
    board: Any  # a controller of that kind
    log: ByteLog
    clock: Clock
    pump: Any  # the spec's section; None without a spec
    ambient: float
    """Absolute [Pa]."""
    names: tuple[str, ...]
    """Names of the inlets; empty where no spec names them."""

    @cached_property
    def axes(self) -> tuple[int, ...]:
        """Ids of the spec's axes; without a spec, of all that answer."""
        if self.pump is not None:
            return tuple(self.pump.axes(len(self.names)))
        return tuple(self.kind.answering(self.board))

    @property
    def inlets(self) -> tuple[str, ...]:
        """One name per axis."""
        numbered = tuple(f"{self.kind.noun}{axis}" for axis in self.axes)
        return self.names or (("inlet",) if len(self.axes) == 1 else numbered)

    def connected_pump(
        self, gauges: PressureReadings | None = None, *, switches: bool = False
    ) -> Pump:
        """The pump behind the contract of `Pump`, by default without its sensors and switches."""
        gauges = gauges or PressureReadings([None] * len(self.axes), self.ambient)
        return self.kind.pump(
            self.board, self.pump, self.axes, gauges, self.clock, switches=switches
        )

    @contextlib.contextmanager
    def gauges(self) -> Iterator[PressureReadings]:
        """What measures the inlets' pressures: sensors of the spec, or the axes themselves."""
        known = self.pump is not None and (self.board.has_pins or not self.board.simulated)
        sensors = each(self.pump.sensor if known else None, len(self.inlets))
        with contextlib.ExitStack() as opened:
            reads = [
                self.kind.own_gauge(self, axis) if sensor is None else self._sensor(sensor, opened)
                for axis, sensor in zip(self.axes, sensors, strict=True)
            ]
            own = [k for k, sensor in enumerate(sensors) if sensor is None]
            yield PressureReadings(reads, self.ambient, self.inlets, exact=own)

    def _sensor(self, sensor: SensorSpec, opened: contextlib.ExitStack) -> Callable[[], float]:
        if self.board.has_pins if sensor.on == "auto" else sensor.on == "board":
            return board_sensor(self.board, sensor.channel)
        return opened.enter_context(phidget_sensor(sensor.channel))
