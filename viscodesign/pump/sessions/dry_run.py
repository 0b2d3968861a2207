"""Rehearsals: what a session would send, found on a simulated pump; no port is opened."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.byte_log import SentBytes
from viscodesign.pump.consent import ignore
from viscodesign.pump.play.stream_result import OnStop
from viscodesign.pump.profile import Playback
from viscodesign.pump.sessions.arguments import typed
from viscodesign.pump.sessions.board_names import board_kind
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, connected
from viscodesign.pump.sessions.reports import result_lines
from viscodesign.pump.sessions.streaming import StreamSession
from viscodesign.pump.sessions.uploading import UploadSession
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

SHOWN_PACKETS = 10
"""Packets of a stream that are printed."""
AT_ONCE = BoardAddress(pace="max")
"""A simulated board whose time does not wait; it presses into nothing here."""
HEADING = "[dry run] no port is opened, nothing moves"


@dataclass(frozen=True)
class Rehearsal:
    """What would be sent."""

    text: str
    """The plan and the packets, for people."""
    packets: tuple[bytes, ...]
    """Everything that would be sent, reads included."""


@typed
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


def rehearse_stream(session: StreamSession) -> Rehearsal:
    """The plan, and the packets that would set something."""
    log = SentBytes()
    with connected(AT_ONCE, session.scene, Plant(), log=log) as link:
        pump = link.connected_pump()
        pump.connect()
        result = session.stream_on(pump, StopRequest(), lambda tick: None).play()
    packets = [data for data in log.sent if link.board.sets(data)]
    lines = [
        HEADING,
        *session.description(),
        f"would send {len(packets)} packets that set something; first {SHOWN_PACKETS} and last:",
        *(f"  {link.board.shown(packet)}" for packet in packets[:SHOWN_PACKETS]),
        "  ...",
        f"  {link.board.shown(packets[-1])}",
        f"[dry run] {result_lines(result)[0]}",
    ]
    return Rehearsal("\n".join(lines), tuple(log.sent))


def rehearse_upload(session: UploadSession) -> Rehearsal:
    """The plan and the packets, those on the way to the start only counted."""
    log, poses, request = SentBytes(), session.poses, StopRequest()

    def end_after_one_round(elapsed: float) -> None:
        if poses.playback == "loop" and elapsed > poses.duration:
            request.times, request.first = 1, "dry run"

    with connected(AT_ONCE, session.scene, Plant(), poses=True, log=log) as link:
        pump = link.connected_pump()
        pump.connect()
        result = poses.play_on(pump, request, ignore, end_after_one_round)
    if result is not None and result.status == "stopped":
        raise PumpError(f"the simulated pump cannot play this: {result.reason}")
    lines = [HEADING, *session.description(), *poses.sent_lines(log.sent)]
    return Rehearsal("\n".join(lines), tuple(log.sent))
