"""The way to a board: its address, and an open connection with the pump that is behind it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

from viscodesign.errors import PumpError, UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus import ports
from viscodesign.pump.bus.byte_log import ByteLog, LoggedLine
from viscodesign.pump.bus.clock import Clock, PacedClock, SteppedClock, WallClock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.consent import Confirm, Tell, ignore, require
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.pump.sessions.board_names import board_kind, kind_behind
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.plant import AMBIENT, Plant
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class BoardAddress:
    """Which board, and how to reach it."""

    board: str = "simulated"
    """`simulated`, or a board of the pump's kind, such as `dynamixel`."""
    port: str | None = None
    """Serial port, such as /dev/ttyUSB0; none for a simulated board."""
    baud: int | None = None
    """Bits per second; by default the board's own."""
    pace: str | float = "1"
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
        if _factor(self.pace) != 1.0:
            raise UsageError(f"pace {self.pace}: only the simulated board's time can be changed")
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


def _factor(pace: str | float) -> float:
    with contextlib.suppress(TypeError, ValueError):
        if 0.0 < (factor := float(pace)) < float("inf"):
            return factor
    raise UsageError(f"pace {pace}: expected a factor above 0, such as 10, or max")


SIMULATED = BoardAddress()


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
    log: ByteLog | None = None,
) -> Iterator[Connection]:
    """An open board and the scene's pump; nothing was asked yet, and nothing moves.

    ``plant``: what a simulated pump presses into; ``poses``: its board plays poses by itself;
    ``log``: what hears every byte in place of the address's own. Closed on leaving, whatever
    happens.
    """
    kind, clock = kind_behind(address.board, scene), address.clock()
    board = kind.simulated_board(poses) if address.simulated else kind.boards()[address.board]
    refuse_port(address)
    # A pump that no spec describes is found by asking; a simulated one has one of its own.
    pump = kind.simulated_pump() if address.simulated else None
    ambient = AMBIENT
    names: tuple[str, ...] = ("inlet",) if address.simulated else ()
    if scene is not None:
        pump, ambient, names = pump_of(scene), scene.ambient_pressure, tuple(scene.inputs)
    log, baud = log or ByteLog(address.log, tell), address.baud or board.baud
    try:
        if address.simulated:
            device = kind.simulated_device(pump, len(names), plant, ambient, poses=poses)
            line: Line = DirectLine(device, clock)
        else:
            line = _serial_line(str(address.port), baud, clock)
        how = {"board": address.board, "port": address.port, "baud": baud}
        log.event("opened", **how, simulated=board.simulated)
        axes = () if pump is None else pump.axes(len(names))
        link = Connection(
            kind, board(LoggedLine(line, log), axes), log, clock, pump, ambient, names
        )
        clock.sleep(0.0 if board.simulated else board.boot)
        link.board.line.drain()
        try:
            yield link
        finally:
            # A port that is gone has been reported already.
            with contextlib.suppress(PumpError):
                link.board.line.close()
    finally:
        log.close()


def refuse_port(address: BoardAddress) -> None:
    """Refuse a port or baud rate that the board does not have, and a port left out."""
    kind, port, baud = board_kind(address.board), address.port, address.baud
    if kind.simulated and (port is not None or baud is not None):
        raise UsageError("the simulated board has no port and no baud rate: nothing real moves")
    if not kind.simulated and port is None:
        raise UsageError(
            f"the board {kind.name} needs a port, such as /dev/ttyUSB0 (--port); "
            "`viscodesign pump ports` lists those there are"
        )
    if baud is not None and baud <= 0:
        raise UsageError(f"baud rate must be above 0, such as {kind.baud}; got {baud}")
