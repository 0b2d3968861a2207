"""What a session would send, found on a computed pump without waiting; no port is opened."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.boards.arbotix import HALT, Arbotix
from viscodesign.pump.boards.simulated import Simulated
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.packets import Instruction, shown
from viscodesign.pump.bus.recording_line import RecordingLine
from viscodesign.pump.bus.transactions import ARBOTIX
from viscodesign.pump.play.stream import OnStop
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress
from viscodesign.pump.sessions.open_board import board_kind, simulated_bench, simulated_line
from viscodesign.pump.sessions.reports import result_lines
from viscodesign.pump.sessions.streaming import StreamSession
from viscodesign.pump.sessions.uploading import Playback, UploadSession
from viscodesign.pump.simulated.direct_line import DirectLine
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.pypose import PyPose
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
    """All that would be sent, reads included."""


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
        return rehearse_stream(
            StreamSession.prepare(
                scene, address, rate, on_stop, achievable, without_sensor, progress
            )
        )
    upload = UploadSession.prepare(scene, tolerance, playback, achievable, progress)
    return rehearse_upload(upload)


def rehearse_stream(session: StreamSession) -> Rehearsal:
    """The plan, and the packets that would set something."""
    clock, servos = SteppedClock(), session.plan.servos
    ambient = session.scene.ambient_pressure
    line = RecordingLine(simulated_line(session.settings, clock, None, ambient))
    # Nothing is measured here: a closed barrel would show another pressure than the actuator's.
    gauges = PressureReadings([None] * len(servos), ambient)
    unwired = session.settings.model_copy(update={"limit_switches": None})
    rehearsed = replace(session, clock=clock, settings=unwired)
    pump = rehearsed.pump_on(Simulated(line, servos), gauges)
    stream = rehearsed.stream_on(pump, StopRequest(), lambda tick: None)
    pump.connect()
    result = stream.play()
    setting = (Instruction.WRITE, Instruction.SYNC_WRITE)
    packets = [data for data in line.sent if data[4] in setting]
    lines = [
        HEADING,
        *session.description(),
        f"would send {len(packets)} packets that set something; first {SHOWN_PACKETS}, and last:",
        *(f"  {shown(packet)}" for packet in packets[:SHOWN_PACKETS]),
        "  ...",
        f"  {shown(packets[-1])}",
        f"[dry run] {result_lines(result)[0]}",
    ]
    return Rehearsal("\n".join(lines), tuple(line.sent))


class NoPressure(Plant):
    """Plungers that press into nothing: the packets do not depend on pressure."""

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        none: np.ndarray = np.zeros_like(positions)
        return none


def rehearse_upload(session: UploadSession) -> Rehearsal:
    """The plan and the packets, those on the way to the start only counted."""
    sent = _sent(session)
    shown_ones = [data for data in sent if data[2:3] == bytes([ARBOTIX]) or data.startswith(HALT)]
    others = Counter(_kind(data) for data in sent if data not in shown_ones)
    counted = ", ".join(f"{number} {kind}" for kind, number in sorted(others.items()))
    lines = [
        HEADING,
        *session.description(),
        f"would send to the servos, starting from home: {counted}",
        f"would send to the board, {len(shown_ones)} packets:",
        *(f"  {shown(data)}" for data in shown_ones),
    ]
    return Rehearsal("\n".join(lines), tuple(sent))


def _sent(session: UploadSession) -> Sequence[bytes]:
    clock = SteppedClock()
    bench = simulated_bench(session.settings, NoPressure())
    line = RecordingLine(DirectLine(PyPose(bench), clock))
    pump = session.pump_on(Arbotix(line, session.lead.servos), clock)
    request = StopRequest()
    player = session.player_on(pump, request, lambda words: None, _one_round(session, request))
    pump.connect()
    player.load()
    if session.playback != "none":
        result = player.approach(session.lead)
        if result.status != "complete":
            raise PumpError(f"the start cannot be reached: {result.reason}")
        player.play()
    return line.sent


def _one_round(session: UploadSession, request: StopRequest) -> Callable[[float], None]:
    def observe(elapsed: float) -> None:
        if session.fit.looped and elapsed > session.fit.duration:
            request.times, request.first = 1, "dry run"

    return observe


def _kind(data: bytes) -> str:
    return {Instruction.READ: "reads", Instruction.WRITE: "writes"}.get(
        Instruction(data[4]), "others"
    )
