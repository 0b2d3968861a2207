"""Sessions that play nothing: status, recording what the sensors show, stopping whatever runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from viscodesign.errors import InterruptedRunError, PumpError, UsageError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.hold import stop_all
from viscodesign.pump.ax.preflight import FoundServo, blocking_faults, identify
from viscodesign.pump.ax.servo_state import listen
from viscodesign.pump.play.axis import FinalAxisState
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sessions.connection import (
    SCANNED_IDS,
    SIMULATED,
    BoardAddress,
    Connection,
    Tell,
    connected,
    ignore,
)
from viscodesign.pump.sessions.record_file import recorded
from viscodesign.pump.sessions.reports import servo_document
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene

HIGHEST_RATE_HZ = 100.0
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
    address: BoardAddress = SIMULATED, scene: Scene | None = None, *, tell: Tell = ignore
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


@dataclass(frozen=True)
class RecordReport:
    """What was recorded, and where it is."""

    status: str
    """`complete`, or `interrupted` before the stated duration."""
    rows: int
    file: Path
    board: str
    simulated: bool
    identity: str
    """What answered."""

    def document(self) -> dict[str, Any]:
        """The same for a program."""
        return {**asdict(self), "file": str(self.file)}

    def raise_failure(self) -> None:
        """Raise an interruption as an error."""
        if self.status == "interrupted":
            raise InterruptedRunError(f"interrupted; what was read so far is in {self.file}")


def record(
    path: str | Path,
    address: BoardAddress = SIMULATED,
    scene: Scene | None = None,
    *,
    rate: float = 30.0,
    duration: float | None = None,
    stop: StopRequest | None = None,
    tell: Tell = ignore,
) -> RecordReport:
    """Record pressure, position, load, voltage and temperature to a CSV file; only reads.

    The columns are those of `stream`. ``scene`` names servos and sensors; without one all servos
    that answer are recorded, and no pressure. ``rate`` [Hz]; ``duration`` [s], by default until
    Ctrl-C or a request to ``stop``. Beside the table stands a JSON document of the same name.
    """
    path = Path(path)
    _refuse_options(path, address, rate, duration)
    with connected(address, scene, tell=tell) as link:
        who = (address.board, address.simulated, link.board.identify())
        facts = dict(zip(("board", "simulated", "identity"), who, strict=True))
        with (
            link.gauges() as gauges,
            recorded(path, link.inlets, facts) as file,
            stop_on_signals(stop) as request,
        ):
            read_from = (link.board, link.servos, gauges, link.clock)
            try:
                ticks = listen(*read_from, request, file.add, rate=rate, duration=duration)
            except PumpError as error:
                file.state("stopped", reason=str(error))
                raise
            # Without a duration there is no other end than the user's.
            early = request.asked and duration is not None
            status = "interrupted" if early else "complete"
            link.log.event("ended", status=status, **ticks.document())
            file.state(status, ticks=ticks.document())
            return RecordReport(status, file.rows, path, *who)


def _refuse_options(path: Path, address: BoardAddress, rate: float, duration: float | None) -> None:
    if not 0.0 < rate <= HIGHEST_RATE_HZ:
        raise UsageError(f"--rate must be above 0 and at most {HIGHEST_RATE_HZ:g} Hz; got {rate:g}")
    if duration is not None and not 0.0 < duration < math.inf:
        raise UsageError(f"--duration must be above 0 s and finite; got {duration:g}")
    if path.suffix == ".json":
        raise UsageError(f"{path}: its JSON would have the same name; call the table .csv")
    if address.pace == "max" and duration is None:
        raise UsageError("--pace max needs --duration: without one it would fill the disk")


def stop(
    address: BoardAddress,
    *,
    ids: Sequence[int] = (),
    release: bool = False,
    tell: Tell = ignore,
) -> list[FinalAxisState]:
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
