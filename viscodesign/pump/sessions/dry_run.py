"""Rehearsals: what a session would send, found on a simulated pump; no port is opened."""

from __future__ import annotations

from collections import Counter

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.packets import Instruction, shown
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.boards.arbotix import HALT, Arbotix
from viscodesign.pump.boards.simulated import Simulated
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.line import RecordingLine
from viscodesign.pump.play.stream_result import OnStop
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, ignore, unmonitored_pump
from viscodesign.pump.sessions.open_board import board_kind, simulated_line
from viscodesign.pump.sessions.reports import result_lines
from viscodesign.pump.sessions.streaming import StreamSession
from viscodesign.pump.sessions.uploading import Playback, UploadSession
from viscodesign.pump.simulated.bench import Plant
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

SHOWN_PACKETS = 10
"""Packets of a stream that are printed."""
HEADING = "[dry run] no port is opened, nothing moves"


@dataclass(frozen=True)
class Rehearsal:
    """What would be sent."""

    text: str
    """The plan and the packets, for people."""
    packets: tuple[bytes, ...]
    """Everything that would be sent, reads included."""


def rehearse(
    scene: Scene,
    address: BoardAddress = SIMULATED,
    *,
    rate: float = 30.0,
    on_stop: OnStop = "hold",
    tolerance: str = "1 kPa",
    playback: Playback = "once",
    achievable: bool = False,
    without_sensor: bool = False,
    progress: Progress | None = None,
) -> Rehearsal:
    """Plan a scene's pressures, and what a board would be sent for them; moves nothing.

    For a board that takes set-points in real time what `stream` would send (``rate`` [Hz],
    ``on_stop``), for one that plays poses what `upload` would (``tolerance``, ``playback``).
    """
    if board_kind(address.board).streams:
        options = (rate, on_stop, achievable, without_sensor, progress, True)
        return rehearse_stream(StreamSession(scene, address, *options))
    return rehearse_upload(UploadSession(scene, tolerance, playback, achievable, progress))


class NoPressure(Plant):
    """Plungers that press into nothing: a closed barrel would load them unlike the actuator."""

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        return np.asarray(np.zeros_like(positions))


def rehearse_stream(session: StreamSession) -> Rehearsal:
    """The plan, and the packets that would set something."""
    line, servos = _simulated_line(session.settings), session.plan.axes
    pump = unmonitored_pump(Simulated(line, servos), session.settings, servos, line.clock)
    stream = session.stream_on(pump, StopRequest(), lambda tick: None)
    pump.connect()
    result = stream.play()
    setting = (Instruction.WRITE, Instruction.SYNC_WRITE)
    packets = [data for data in line.sent if data[4] in setting]
    lines = [
        HEADING,
        *session.description(),
        f"would send {len(packets)} packets that write registers; first {SHOWN_PACKETS} and last:",
        *(f"  {shown(packet)}" for packet in packets[:SHOWN_PACKETS]),
        "  ...",
        f"  {shown(packets[-1])}",
        f"[dry run] {result_lines(result)[0]}",
    ]
    return Rehearsal("\n".join(lines), tuple(line.sent))


def rehearse_upload(session: UploadSession) -> Rehearsal:
    """The plan and the packets, those on the way to the start only counted."""
    line, servos = _simulated_line(session.settings, poses=True), session.lead.axes
    pump = unmonitored_pump(Arbotix(line, servos), session.settings, servos, line.clock)
    request = StopRequest()

    def end_after_one_round(elapsed: float) -> None:
        if session.fit.looped and elapsed > session.fit.duration:
            request.times, request.first = 1, "dry run"

    pump.connect()
    result = session.play_on(pump, request, ignore, end_after_one_round)
    if result is not None and result.status == "stopped":
        raise PumpError(f"the simulated pump cannot play this: {result.reason}")
    own = [data for data in line.sent if data[2:3] == bytes([ARBOTIX]) or data.startswith(HALT)]
    others = Counter(Instruction(data[4]).name.lower() for data in line.sent if data not in own)
    lines = [
        HEADING,
        *session.description(),
        "would send to the servos, starting at home: "
        + ", ".join(f"{number} {kind}s" for kind, number in sorted(others.items())),
        f"would send to the board, {len(own)} packets:",
        *(f"  {shown(data)}" for data in own),
    ]
    return Rehearsal("\n".join(lines), tuple(line.sent))


def _simulated_line(settings: PumpSpec, *, poses: bool = False) -> RecordingLine:
    return RecordingLine(simulated_line(settings, SteppedClock(), NoPressure(), poses=poses))
