"""What is connected and how it is; and stopping it, whatever runs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from viscodesign.errors import PumpError
from viscodesign.pump.ax.hold import stop_all
from viscodesign.pump.ax.preflight import FoundServo, blocking_faults, identify
from viscodesign.pump.boards.base import Board
from viscodesign.pump.play.axis import FinalServoState
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sessions.connection import (
    SCANNED_IDS,
    SIMULATED,
    BoardAddress,
    PumpSetup,
    Tell,
    connected,
    pressure_gauges,
    unheard,
)
from viscodesign.pump.sessions.reports import servo_documents
from viscodesign.scene.scene import Scene

NO_SERVO = (
    "no servo answers, so nothing could be verified. If the pump moves, switch its power off. "
    "Is this the right --board and --baud?"
)
BUSY_BOARD = (
    "A move that the PyPose firmware plays cannot be interrupted: the halt acts when it is over, "
    "up to 32 s later. Until then nothing answers, and only switching the power off stops it."
)


@dataclass(frozen=True)
class PumpStatus:
    """What answers on a bus, as it was read."""

    board: str
    simulated: bool
    identity: str
    servos: tuple[FoundServo, ...]
    inlets: tuple[str, ...]
    """One name per servo."""
    pressure: tuple[float | None, ...] | None
    """Gauge, per inlet [Pa]; None where no spec names the sensors."""
    pressed: tuple[str, ...]
    """Limit switches, such as 'low'."""
    objections: tuple[str, ...]
    """Why the pump must not be moved as it is."""
    hints: tuple[str, ...]
    """What would make its port faster."""

    def document(self) -> dict[str, Any]:
        """Under names with units."""
        pins = {"pressure_pa_gauge": self.pressure, "switches_pressed": list(self.pressed)}
        return {
            "board": self.board,
            "simulated": self.simulated,
            "identity": self.identity,
            "servos": servo_documents(self.servos),
            "inlets": self.inlets,
            **(pins if self.pressure is not None else {}),
            "objections": list(self.objections),
            "hints": list(self.hints),
        }


def status(
    address: BoardAddress = SIMULATED, scene: Scene | None = None, *, tell: Tell = unheard
) -> PumpStatus:
    """Read the servos that answer, and with a scene its sensors and switches; writes nothing."""
    setup = PumpSetup.of(scene, simulated=address.simulated)
    with connected(address, address.clock(), setup, None, tell) as (board, _log):
        identity = board.identify()
        servos = tuple(identify(board, servo) for servo in setup.servos(board))
        names = setup.inlet_names([servo.id for servo in servos])
        pump = setup.pump
        pressure, pressed = (None, ()) if pump is None else _pins(board, setup, names)
        against = [] if pump is None else [r for s in servos for r in blocking_faults(s, pump)]
    return PumpStatus(
        board=address.board,
        simulated=address.simulated,
        identity=identity,
        servos=servos,
        inlets=names,
        pressure=pressure,
        pressed=pressed,
        objections=tuple(against),
        hints=tuple(address.hints),
    )


def _pins(
    board: Board, setup: PumpSetup, inlets: Sequence[str]
) -> tuple[tuple[float | None, ...], tuple[str, ...]]:
    """Pressures [Pa gauge], and the switches that are pressed."""
    assert setup.pump is not None
    with pressure_gauges(board, setup.pump, setup.ambient, inlets) as gauges:
        pressure = gauges.read()
    servos = setup.servos(board)
    ends = Switches.of(setup.pump, servos).read(board)
    prefix = [f"{name} " if len(inlets) > 1 else "" for name in inlets]
    of = dict(zip(servos, prefix, strict=True))
    return pressure, tuple(f"{of[servo]}{end}" for servo in ends for end in sorted(ends[servo]))


def stop(
    address: BoardAddress,
    *,
    ids: Sequence[int] = (),
    release: bool = False,
    tell: Tell = unheard,
) -> list[FinalServoState]:
    """Halt the board, then hold every servo that answers (or ``release``: switch torque off).

    Works in any state and needs no scene. ``ids``: only these servos; by default 1 to 8. Says
    of each servo whether its state was verified; raises `PumpError` where none answers. A
    simulated pump lives only as long as its session: there is nothing to stop.
    """
    if address.simulated:
        return []
    clock = address.clock()
    with connected(address, clock, PumpSetup(None), None, tell) as (board, _log):
        left = stop_all(board, list(ids or SCANNED_IDS), clock, release=release)
        if not left:
            raise PumpError(NO_SERVO if board.streams else f"{NO_SERVO}\n{BUSY_BOARD}")
    return left
