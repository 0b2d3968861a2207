"""The way to a board: its address, and an open connection with the pump that is behind it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from viscodesign.errors import PumpError, UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import ports
from viscodesign.pump.bus.byte_log import ByteLog, LoggedLine
from viscodesign.pump.bus.clock import Clock, PacedClock, SteppedClock, WallClock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.sensors.base import BoardAnalog, PressureSource
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.phidget import Phidget
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.open_board import (
    SimulatedArbotix,
    board_kind,
    servo_ids,
    simulated_line,
)
from viscodesign.pump.simulated.bench import AMBIENT, Plant
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pump import PumpSpec, SensorSpec
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

SCANNED_IDS = range(1, 9)
"""Servo ids that are tried where no spec names them."""

Tell = Callable[[str], None]
"""Receives one message that a user should read."""
Confirm = Callable[[str], bool]
"""Receives what is about to happen, its last line a question; whether the user agrees."""


def ignore(message: str) -> None:
    """Drop a message."""


@dataclass(frozen=True)
class BoardAddress:
    """Which board, and how to reach it."""

    board: str = "simulated"
    """`simulated`, `dynamixel`, `arbotix` or `arbotix-ros`."""
    port: str | None = None
    """Serial port, such as /dev/ttyUSB0; none for a simulated board."""
    baud: int | None = None
    """Bits per second; by default the board's own."""
    pace: str = "1"
    """Speed of a simulated board's time: 1 is real time, "max" runs without waiting."""
    log: Path | None = None
    """Where every byte is kept, as JSON lines."""

    @property
    def simulated(self) -> bool:
        """Whether nothing real moves."""
        return board_kind(self.board).simulated

    @property
    def label(self) -> str:
        """Goes in front of what is said about a simulated board."""
        return "[simulated] " if self.simulated else ""

    @property
    def hints(self) -> list[str]:
        """What would make its port faster."""
        hint = "" if self.port is None else ports.latency_hint(self.port)
        return [f"{self.port} {hint}"] if hint else []

    def clock(self) -> Clock:
        """Real time; for a simulated board, time at the requested pace."""
        if self.simulated:
            return SteppedClock() if self.pace == "max" else PacedClock(_factor(self.pace))
        if self.pace != "1":
            raise UsageError(f"--pace {self.pace}: only the simulated board's time can be changed")
        return WallClock()

    def require_consent(self, confirm: Confirm | None, text: str) -> None:
        """Ask before something moves; raises `UsageError` unless the user agrees.

        A simulated board needs no one to ask.
        """
        if confirm is None and not self.simulated:
            raise UsageError(
                "a real pump is about to move: pass `confirm`, a function that is given the plan "
                "and returns whether to go ahead"
            )
        if confirm is not None:
            require(confirm, text)


def require(confirm: Confirm, text: str) -> None:
    """Raise `UsageError` unless the user agrees."""
    if not confirm(text):
        raise UsageError("aborted; nothing moved")


def _factor(text: str) -> float:
    with contextlib.suppress(ValueError):
        if 0.0 < (factor := float(text)) < float("inf"):
            return factor
    raise UsageError(f"--pace {text}: expected a factor above 0, such as 10, or max")


SIMULATED = BoardAddress()


@dataclass(frozen=True)
class Connection:
    """An open board, and what is known of the pump behind it."""

    board: Board
    log: ByteLog
    clock: Clock
    pump: PumpSpec | None
    ambient: float
    """Absolute [Pa]."""
    names: tuple[str, ...]
    """Of the servos' inlets; empty where no spec names them."""

    @cached_property
    def servos(self) -> list[int]:
        """Ids of the spec's servos; without a spec, of all that answer."""
        if self.pump is not None:
            return servo_ids(self.pump)
        return [servo for servo in SCANNED_IDS if self.board.answers(servo)]

    @property
    def inlets(self) -> tuple[str, ...]:
        """One name per servo."""
        alone = len(self.servos) == 1
        return self.names or (("inlet",) if alone else tuple(f"servo{id}" for id in self.servos))

    @contextlib.contextmanager
    def gauges(self) -> Iterator[PressureReadings]:
        """The inlets' pressure sensors, each on the board or on a Phidgets interface kit."""
        sensors = each(None if self.pump is None else self.pump.sensor, len(self.inlets))
        with contextlib.ExitStack() as open_sources:
            reads: list[Callable[[], float] | None] = []
            for sensor in sensors:
                source = None if sensor is None else self._source(sensor)
                if source is not None:
                    open_sources.callback(source.close)
                reads.append(None if source is None else source.absolute)
            yield PressureReadings(reads, self.ambient, self.inlets)

    def _source(self, sensor: SensorSpec) -> PressureSource:
        on_board = self.board.has_pins if sensor.on == "auto" else sensor.on == "board"
        return BoardAnalog(self.board, sensor.channel) if on_board else Phidget(sensor.channel)


def _serial_line(port: str, baud: int, clock: Clock) -> Line:
    """An open port; its library is imported here, where a port is used."""
    with ports.serial_library():
        from viscodesign.pump.bus.serial_line import SerialLine
    return SerialLine(port, baud, clock)


@contextlib.contextmanager
def connected(
    address: BoardAddress,
    scene: Scene | None = None,
    plant: Plant | None = None,
    tell: Tell = ignore,
    *,
    poses: bool = False,
) -> Iterator[Connection]:
    """An open board and the scene's pump; nothing was asked yet, and nothing moves.

    ``plant``: what a simulated pump presses into; ``poses``: its board plays poses by itself.
    Closed on leaving, whatever happens.
    """
    kind, clock = board_kind(address.board), address.clock()
    refuse_port(address)
    pump, ambient, names = _known(scene, kind.simulated)
    log, baud = ByteLog(address.log, tell), address.baud or kind.baud
    try:
        if pump is not None and kind.simulated:
            line: Line = simulated_line(pump, clock, plant, ambient, poses=poses)
            kind = SimulatedArbotix if poses else kind
        else:
            line = _serial_line(str(address.port), baud, clock)
        how = {"board": address.board, "port": address.port, "baud": baud}
        log.event("opened", **how, simulated=kind.simulated)
        board = kind(LoggedLine(line, log), [] if pump is None else servo_ids(pump))
        clock.sleep(kind.boot)
        board.line.drain()
        try:
            yield Connection(board, log, clock, pump, ambient, names)
        finally:
            # A port that is gone has been reported already.
            with contextlib.suppress(PumpError):
                board.line.close()
    finally:
        log.close()


def unmonitored_pump(
    board: Board, pump: PumpSpec, servos: Sequence[int], clock: Clock
) -> ServoPump:
    """The pump behind a board that reads neither sensors nor switches."""
    none = PressureReadings([None] * len(servos), AMBIENT)
    return ServoPump(board, pump, servos, none, Switches({}), clock)


def _known(scene: Scene | None, simulated: bool) -> tuple[PumpSpec | None, float, tuple[str, ...]]:
    """Pump, ambient pressure and inlets: of a scene, of the simulated board, or of any pump."""
    if scene is not None:
        return pump_of(scene), scene.ambient_pressure, tuple(scene.inputs)
    if not simulated:
        return None, AMBIENT, ()
    default = {"syringe_diameter": "34.9 mm", "sensor": {"channel": 0}}
    return PumpSpec.model_validate(default), AMBIENT, ("inlet",)


def refuse_port(address: BoardAddress) -> None:
    """Refuse a port or baud rate that the board does not have, and a port left out."""
    kind, port, baud = board_kind(address.board), address.port, address.baud
    if kind.simulated and (port is not None or baud is not None):
        raise UsageError("--board simulated has no --port and no --baud: nothing real moves")
    if not kind.simulated and port is None:
        raise UsageError(
            f"--board {kind.name} needs --port, such as /dev/ttyUSB0; "
            "`viscodesign pump ports` lists those there are"
        )
    if baud is not None and baud <= 0:
        raise UsageError(f"--baud must be above 0, such as {kind.baud}; got {baud}")
