"""What an upload would send, found out on a computed board at once; no port is opened."""

from __future__ import annotations

from collections import Counter

import numpy as np

from viscodesign.cli.pump._poses import Poses, player_of, pump_with
from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.boards.arbotix import HALT, Arbotix
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.packets import Instruction, shown
from viscodesign.pump.bus.recording_line import RecordingLine
from viscodesign.pump.bus.transactions import ARBOTIX
from viscodesign.pump.sessions.open_board import simulated_bench
from viscodesign.pump.simulated.direct_line import DirectLine
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.pypose import PyPose


class NoPressure(Plant):
    """Plungers that press into nothing: what is sent depends on no pressure."""

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        none: np.ndarray = np.zeros_like(positions)
        return none


def rehearsed(poses: Poses, *, moves: bool) -> list[str]:
    """The plan and the packets, those for the way to the start only counted."""
    sent = _sent(poses, moves=moves)
    told = [data for data in sent if data[2:3] == bytes([ARBOTIX]) or data.startswith(HALT)]
    others = Counter(_kind(data) for data in sent if data not in told)
    return [
        "[dry run] no port is opened, nothing moves",
        *poses.lines(),
        f"would send to the servos, from home on: "
        f"{', '.join(f'{number} {kind}' for kind, number in sorted(others.items()))}",
        f"would send to the board, {len(told)} packets:",
        *(f"  {shown(data)}" for data in told),
    ]


def _sent(poses: Poses, *, moves: bool) -> list[bytes]:
    clock = SteppedClock()
    bench = simulated_bench(poses.settings, NoPressure())
    line = RecordingLine(DirectLine(PyPose(bench), clock))
    pump = pump_with(Arbotix(line, poses.lead.servos), poses, clock)
    wish = StopRequest()

    def see(elapsed: float) -> None:
        # A loop is left after its first round.
        if poses.fit.looped and elapsed > poses.fit.duration:
            wish.times, wish.first = 1, "dry run"

    player = player_of(pump, poses, wish, see, tell=lambda words: None)
    pump.connect()
    player.load()
    if moves:
        ending = player.approach(poses.lead)
        if ending.status != "complete":
            raise PumpError(f"the way to the start cannot be gone: {ending.reason}")
        player.play()
    return line.sent


def _kind(data: bytes) -> str:
    return {Instruction.READ: "reads", Instruction.WRITE: "writes"}.get(
        Instruction(data[4]), "others"
    )
