"""The way to a board: its address, the pump that a spec puts behind it, one open connection."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import ports
from viscodesign.pump.bus.byte_log import ByteLog, LoggedLine
from viscodesign.pump.bus.clock import Clock, PacedClock, SteppedClock, WallClock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.serial_line import SerialLine
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.sensors.base import PressureSource
from viscodesign.pump.sensors.board_analog import BoardAnalog
from viscodesign.pump.sensors.phidget import Phidget
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.open_board import (
    SimulatedArbotix,
    board_kind,
    servo_ids,
    simulated_bench,
    simulated_line,
)
from viscodesign.pump.simulated.direct_line import DirectLine
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pump import PumpSpec, SensorSpec
from viscodesign.scene.scene import Scene

STANDARD_AMBIENT_PA = 101_325.0
"""Absolute [Pa]."""
SCANNED_IDS = range(1, 9)
"""Servo ids that are tried where no spec names them."""

Tell = Callable[[str], None]
"""Receives one message that a user should read."""
Confirm = Callable[[str], bool]
"""Receives what is about to happen, its last line a question; whether the user agrees."""


def unheard(message: str) -> None:
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
        if confirm is not None and not confirm(text):
            raise UsageError("aborted; nothing moved")


def _factor(text: str) -> float:
    with contextlib.suppress(ValueError):
        if 0.0 < (factor := float(text)) < float("inf"):
            return factor
    raise UsageError(f"--pace {text}: expected a factor above 0, such as 10, or max")


SIMULATED = BoardAddress()


@dataclass(frozen=True)
class PumpSetup:
    """The drive, where it is known, and the air around it."""

    pump: PumpSpec | None
    ambient: float = STANDARD_AMBIENT_PA
    """Absolute [Pa]."""
    inlets: tuple[str, ...] = ()
    """Names of the servos' inlets; empty where no spec names them."""

    @classmethod
    def of(cls, scene: Scene | None, *, simulated: bool = False) -> PumpSetup:
        """A scene's; without one, that of the simulated board, or what is known of any pump."""
        if scene is not None:
            return cls(pump_of(scene), scene.ambient_pressure, tuple(scene.inputs))
        if not simulated:
            return cls(None)
        default = {"syringe_diameter": "34.9 mm", "sensor": {"channel": 0}}
        return cls(PumpSpec.model_validate(default), inlets=("inlet",))

    def servos(self, board: Board) -> list[int]:
        """Ids of the spec's servos; without a spec, of all that answer."""
        if self.pump is not None:
            return servo_ids(self.pump)
        return [servo for servo in SCANNED_IDS if board.answers(servo)]

    def inlet_names(self, servos: Sequence[int]) -> tuple[str, ...]:
        """One name per servo."""
        if self.inlets:
            return self.inlets
        return ("inlet",) if len(servos) == 1 else tuple(f"servo{id}" for id in servos)


@contextlib.contextmanager
def connected(
    address: BoardAddress,
    clock: Clock,
    setup: PumpSetup,
    plant: Plant | None = None,
    tell: Tell = unheard,
    *,
    poses: bool = False,
) -> Iterator[tuple[Board, ByteLog]]:
    """An open board and the log of its bytes; nothing was asked yet, and nothing moves.

    ``plant``: what a simulated pump presses into; ``poses``: its board plays poses by itself.
    Closed on leaving, whatever happens.
    """
    kind, name, port = board_kind(address.board), address.board, address.port
    _refuse_port(kind, address)
    log, baud = ByteLog(address.log, tell), address.baud or kind.baud
    try:
        if not kind.simulated:
            line: Line = SerialLine(str(port), baud, clock)
        else:
            kind, line = _simulated(kind, clock, setup, plant, poses)
        log.event("opened", board=name, port=port, baud=baud, simulated=kind.simulated)
        board = kind(LoggedLine(line, log), [] if setup.pump is None else servo_ids(setup.pump))
        clock.sleep(kind.boot)
        board.line.drain()
        try:
            yield board, log
        finally:
            # A port that is gone has been reported already.
            with contextlib.suppress(PumpError):
                board.line.close()
    finally:
        log.close()


def _simulated(
    kind: type[Board], clock: Clock, setup: PumpSetup, plant: Plant | None, poses: bool
) -> tuple[type[Board], Line]:
    if setup.pump is None:
        raise UsageError("--board simulated needs the `pump:` section of a spec")
    if not poses:
        return kind, simulated_line(setup.pump, clock, plant, setup.ambient)
    device = PyPose(simulated_bench(setup.pump, plant, setup.ambient))
    return SimulatedArbotix, DirectLine(device, clock)


def _refuse_port(kind: type[Board], address: BoardAddress) -> None:
    port, baud = address.port, address.baud
    if kind.simulated and (port is not None or baud is not None):
        raise UsageError("--board simulated has no --port and no --baud: nothing real moves")
    if not kind.simulated and port is None:
        raise UsageError(
            f"--board {kind.name} needs --port, such as /dev/ttyUSB0; "
            "`viscodesign pump ports` lists those there are"
        )
    if baud is not None and baud <= 0:
        raise UsageError(f"--baud must be above 0, such as {kind.baud}; got {baud}")


@contextlib.contextmanager
def pressure_gauges(
    board: Board, pump: PumpSpec | None, ambient: float, inlets: Sequence[str]
) -> Iterator[PressureReadings]:
    """The inlets' pressure sensors, each on the board or on a Phidgets interface kit.

    ``ambient``: absolute [Pa].
    """
    sensors = each(None if pump is None else pump.sensor, len(inlets))
    with contextlib.ExitStack() as open_sources:
        reads: list[Callable[[], float] | None] = []
        for sensor in sensors:
            source = None if sensor is None else _source(board, sensor)
            if source is not None:
                open_sources.callback(source.close)
            reads.append(None if source is None else source.absolute)
        yield PressureReadings(reads, ambient, inlets)


def _source(board: Board, sensor: SensorSpec) -> PressureSource:
    where = sensor.on
    if where == "auto":
        where = "board" if board.has_pins else "phidget"
    return BoardAnalog(board, sensor.channel) if where == "board" else Phidget(sensor.channel)
