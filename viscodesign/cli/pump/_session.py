"""A board for one command: opened once, every byte logged, and let go of whatever happens."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.errors import PumpError, UsageError

if TYPE_CHECKING:
    from viscodesign.cli.pump._setting import Setting
    from viscodesign.pump.boards.base import Board
    from viscodesign.pump.bus.byte_log import ByteLog
    from viscodesign.pump.bus.clock import Clock
    from viscodesign.pump.sensors.base import PressureSource
    from viscodesign.pump.sensors.pressure_readings import PressureReadings
    from viscodesign.pump.simulated.plant import Plant
    from viscodesign.scene.pump import Pump, Sensor


@dataclass(frozen=True)
class Way:
    """How a command line says to reach a board."""

    board: str
    port: str | None
    baud: int | None
    pace: str = "1"
    log: Path | None = None

    @property
    def simulated(self) -> bool:
        """Whether nothing real moves."""
        from viscodesign.pump.sessions.open_board import board_kind

        return board_kind(self.board).simulated

    @property
    def label(self) -> str:
        """To be put before what is told of a simulated board."""
        return "[simulated] " if self.simulated else ""

    @property
    def hints(self) -> list[str]:
        """What would make its port better."""
        from viscodesign.pump.bus.ports import latency_hint

        hint = "" if self.port is None else latency_hint(self.port)
        return [f"{self.port} {hint}"] if hint else []

    def clock(self) -> Clock:
        """The real one; a simulated board's at the pace asked for."""
        from viscodesign.pump.bus.clock import PacedClock, SteppedClock, WallClock

        if self.simulated:
            return SteppedClock() if self.pace == "max" else PacedClock(_factor(self.pace))
        if self.pace != "1":
            raise UsageError(f"--pace {self.pace}: only the simulated board's time can be changed")
        return WallClock()


def _factor(text: str) -> float:
    with contextlib.suppress(ValueError):
        if 0.0 < (factor := float(text)) < float("inf"):
            return factor
    raise UsageError(f"--pace {text}: give a factor above 0, such as 10, or max")


@contextlib.contextmanager
def opened(
    way: Way, clock: Clock, setting: Setting, plant: Plant | None = None
) -> Iterator[tuple[Board, ByteLog]]:
    """The board and the log of its bytes; nothing is asked of it yet, and nothing moves."""
    from viscodesign.cli.output import complain
    from viscodesign.pump.bus.byte_log import ByteLog
    from viscodesign.pump.sessions.open_board import open_board

    log = ByteLog(way.log, complain)
    pump, ambient = setting.pump, setting.ambient
    try:
        board = open_board(way.board, way.port, way.baud, log, clock, pump, plant, ambient)
        try:
            yield board, log
        finally:
            # A port that is gone has told so already.
            with contextlib.suppress(PumpError):
                board.line.close()
    finally:
        log.close()


@contextlib.contextmanager
def gauges(
    board: Board, pump: Pump | None, ambient: float, inlets: Sequence[str]
) -> Iterator[PressureReadings]:
    """The pressure sensors of the inlets, each on the board or on a Phidgets' kit.

    ``ambient``: absolute [Pa].
    """
    from viscodesign.pump.sensors.pressure_readings import PressureReadings
    from viscodesign.scene.per_inlet import each

    sensors = each(None if pump is None else pump.sensor, len(inlets))
    with contextlib.ExitStack() as open_sources:
        reads: list[Callable[[], float] | None] = []
        for sensor in sensors:
            source = None if sensor is None else _source(board, sensor)
            if source is not None:
                open_sources.callback(source.close)
            reads.append(None if source is None else source.absolute)
        yield PressureReadings(reads, ambient, inlets)


def _source(board: Board, sensor: Sensor) -> PressureSource:
    from viscodesign.pump.sensors.board_analog import BoardAnalog
    from viscodesign.pump.sensors.phidget import Phidget

    where = sensor.on
    if where == "auto":
        where = "board" if board.has_pins else "phidget"
    return BoardAnalog(board, sensor.channel) if where == "board" else Phidget(sensor.channel)
