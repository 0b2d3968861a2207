"""Sessions that play nothing: status, recording what the sensors show, stopping whatever runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from viscodesign.errors import InterruptedRunError, PumpError, UsageError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.consent import Tell, ignore
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.play.axis import FinalAxisState, FoundAxis, Sample
from viscodesign.pump.play.pump import Pressed, Pump
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.sessions.arguments import typed
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, connected
from viscodesign.pump.sessions.record_file import recorded
from viscodesign.pump.sessions.record_folder import refuse_measured
from viscodesign.scene.scene import Scene

HIGHEST_RATE_HZ = 100.0
NO_REPLY = (
    "no {noun} answers, so nothing could be verified. If the pump moves, switch its power off. "
    "Is this the right board and baud rate?"
)


@dataclass(frozen=True)
class PumpStatus:
    """What answers on a bus, as it was read."""

    address: BoardAddress
    identity: str
    noun: str
    """What an axis of this pump is called."""
    axes: tuple[FoundAxis, ...]
    inlets: tuple[str, ...]
    """One name per axis."""
    pressure: tuple[float | None, ...] | None = None
    """Gauge, per inlet [Pa]; None where no spec names the sensors."""
    pressed: tuple[str, ...] = ()
    """Limit switches, such as 'low'."""

    @property
    def objections(self) -> tuple[str, ...]:
        """Why the pump must not be moved as it is."""
        return tuple(fault for axis in self.axes for fault in axis.faults)

    def document(self) -> dict[str, Any]:
        """Under names with units."""
        pins = {"pressure_pa_gauge": self.pressure, "switches_pressed": list(self.pressed)}
        return {
            "board": self.address.board,
            "simulated": self.address.simulated,
            "identity": self.identity,
            f"{self.noun}s": [axis.document for axis in self.axes],
            "inlets": self.inlets,
            **(pins if self.pressure is not None else {}),
            "objections": self.objections,
            "hints": self.address.hints,
        }


@typed
def status(
    address: BoardAddress = SIMULATED, scene: Scene | None = None, *, tell: Tell = ignore
) -> PumpStatus:
    """Read the axes that answer, and with a scene its sensors and switches; writes nothing."""
    with connected(address, scene, tell=tell) as link:
        identity, axes = link.connected_pump().inspect()
        found = PumpStatus(address, identity, link.kind.noun, tuple(axes), link.inlets)
        if link.pump is None:
            return found
        with link.gauges() as gauges:
            _, pressure, pressed = link.connected_pump(gauges, switches=True).look()
        return replace(found, pressure=pressure, pressed=_names(link, pressed))


def _names(link: Connection, ends: Pressed) -> tuple[str, ...]:
    """Switches that are pressed; their inlets are named where there are several."""
    names = dict(zip(link.axes, link.inlets, strict=True))
    return tuple(
        f"{names[axis]} {end}" if len(names) > 1 else end
        for axis in ends
        for end in sorted(ends[axis])
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


@typed
def record(
    path: str | Path,
    address: BoardAddress = SIMULATED,
    scene: Scene | None = None,
    *,
    rate: float = 30.0,
    duration: float | None = None,
    force: bool = False,
    stop: StopRequest | None = None,
    tell: Tell = ignore,
) -> RecordReport:
    """Record pressure, position, load, voltage and temperature to a CSV file; only reads.

    The columns are those of `stream`. ``scene`` names axes and sensors; without one all axes
    that answer are recorded, and no pressure. ``rate`` [Hz]; ``duration`` [s], by default until
    Ctrl-C or a request to ``stop``. Beside the table stands a JSON document of the same name.
    ``force`` replaces a record of a real pump, which is refused otherwise.
    """
    path = Path(path)
    _refuse_options(path, address, rate, duration)
    refuse_measured(path, force=force)
    with connected(address, scene, tell=tell) as link:
        facts: dict[str, Any] = {
            "board": address.board,
            "simulated": address.simulated,
            "identity": link.board.identify(),
        }
        with (
            link.gauges() as gauges,
            recorded(path, link.inlets, facts, link.kind.channels(link.pump)) as file,
            stop_on_signals(stop) as request,
        ):
            pump, ticks = link.connected_pump(gauges), Ticks(link.clock, 1.0 / rate)
            ticks.begin()
            try:
                while not request.asked and (duration is None or ticks.elapsed <= duration):
                    file.add(ticks.now, _heard(pump))
                    ticks.wait(lambda: not request.asked)
            except PumpError as error:
                file.state("stopped", reason=str(error))
                raise
            # Without a duration there is no other end than the user's.
            early = request.asked and duration is not None
            status = "interrupted" if early else "complete"
            link.log.event("ended", status=status, **ticks.document())
            file.state(status, ticks=ticks.document())
            return RecordReport(status, file.rows, path, **facts)


def _heard(pump: Pump) -> Sample:
    """What a pump shows that somebody else moves, or nobody; no pressure is expected."""
    states, pressure, pressed = pump.look()
    goals = {axis: state.goal for axis, state in states.items()}
    expected = (None,) * len(pressure)
    return Sample(pump.clock.now(), states, pressure, expected, pressed, goals, goals)


def _refuse_options(path: Path, address: BoardAddress, rate: float, duration: float | None) -> None:
    if not 0.0 < rate <= HIGHEST_RATE_HZ:
        raise UsageError(f"rate must be above 0 and at most {HIGHEST_RATE_HZ:g} Hz; got {rate:g}")
    if duration is not None and not 0.0 < duration < math.inf:
        raise UsageError(f"duration must be above 0 s and finite; got {duration:g}")
    if path.suffix == ".json":
        raise UsageError(f"{path}: its JSON would have the same name; call the table .csv")
    if address.pace == "max" and duration is None:
        raise UsageError(
            "pace max needs a duration (--duration): without one it would fill the disk"
        )


@typed
def stop(
    address: BoardAddress,
    *,
    ids: Sequence[int] = (),
    release: bool = False,
    tell: Tell = ignore,
) -> list[FinalAxisState]:
    """Halt the board, then hold every axis that answers (or ``release`` it).

    Works in any state and needs no scene. ``ids``: only these axes; by default all that answer.
    Says of each whether its state was verified; raises `PumpError` where none answers. A
    simulated pump lives only as long as its session: there is nothing to stop.
    """
    if address.simulated:
        return []
    with connected(address, tell=tell) as link:
        left = link.kind.stop(link, ids, release)
        if not left:
            more = "" if link.board.streams else f"\n{link.kind.no_reply}"
            raise PumpError(NO_REPLY.format(noun=link.kind.noun) + more)
    return left
