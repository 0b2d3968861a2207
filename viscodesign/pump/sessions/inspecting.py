"""What is connected and how it is; and stopping it, whatever runs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from viscodesign.errors import PumpError
from viscodesign.pump.ax.hold import stop_all
from viscodesign.pump.ax.preflight import FoundServo, blocking_faults, identify
from viscodesign.pump.play.axis import FinalServoState
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sessions.connection import (
    SCANNED_IDS,
    SIMULATED,
    BoardAddress,
    Connection,
    Tell,
    connected,
    unheard,
)
from viscodesign.pump.sessions.reports import servo_document
from viscodesign.scene.pump import PumpSpec
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

    address: BoardAddress
    identity: str
    servos: tuple[FoundServo, ...]
    inlets: tuple[str, ...]
    """One name per servo."""
    pressure: tuple[float | None, ...] | None = None
    """Gauge, per inlet [Pa]; None where no spec names the sensors."""
    pressed: tuple[str, ...] = ()
    """Limit switches, such as 'low'."""
    objections: tuple[str, ...] = ()
    """Why the pump must not be moved as it is."""

    def document(self) -> dict[str, Any]:
        """Under names with units."""
        pins = {"pressure_pa_gauge": self.pressure, "switches_pressed": list(self.pressed)}
        return {
            "board": self.address.board,
            "simulated": self.address.simulated,
            "identity": self.identity,
            "servos": [servo_document(servo) for servo in self.servos],
            "inlets": self.inlets,
            **(pins if self.pressure is not None else {}),
            "objections": list(self.objections),
            "hints": self.address.hints,
        }


def status(
    address: BoardAddress = SIMULATED, scene: Scene | None = None, *, tell: Tell = unheard
) -> PumpStatus:
    """Read the servos that answer, and with a scene its sensors and switches; writes nothing."""
    with connected(address, scene, tell=tell) as link:
        identity = link.board.identify()
        servos = tuple(identify(link.board, servo) for servo in link.servos)
        if link.pump is None:
            return PumpStatus(address, identity, servos, link.inlets)
        with link.gauges() as gauges:
            pressure = gauges.read()
        objections = [reason for servo in servos for reason in blocking_faults(servo, link.pump)]
        pressed = _pressed(link, link.pump)
        return PumpStatus(
            address, identity, servos, link.inlets, pressure, pressed, tuple(objections)
        )


def _pressed(link: Connection, pump: PumpSpec) -> tuple[str, ...]:
    """Switches that are pressed; their inlets are named where there are several."""
    ends = Switches.of(pump, link.servos).read(link.board)
    names = dict(zip(link.servos, link.inlets, strict=True))
    return tuple(
        f"{names[servo]} {end}" if len(names) > 1 else end
        for servo in ends
        for end in sorted(ends[servo])
    )


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
    with connected(address, tell=tell) as link:
        left = stop_all(link.board, list(ids or SCANNED_IDS), link.clock, release=release)
        if not left:
            raise PumpError(NO_SERVO if link.board.streams else f"{NO_SERVO}\n{BUSY_BOARD}")
    return left
