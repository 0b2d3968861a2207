"""What the sensors of a pump show, into a file; nothing moves."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from viscodesign.errors import InterruptedRunError, PumpError, UsageError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.pump.ax.listen import listen
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, Tell, connected, unheard
from viscodesign.pump.sessions.record_file import recorded
from viscodesign.scene.scene import Scene

HIGHEST_RATE_HZ = 100.0


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
    tell: Tell = unheard,
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
