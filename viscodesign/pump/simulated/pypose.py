"""The firmware that ArbotiX boards come with, PyPose's, with its traps.

Read from `pypose.ino` of vanadiumlabs' ArbotiX repository. It acknowledges whatever is sent
to id 253, before it does it; answers writes for servos that are not there; forgets all at a
reset; and while it plays looks at one byte for each move. Its TEST is left out: it hangs here.
"""

from __future__ import annotations

from viscodesign.pump.bus.packets import Instruction, Packet
from viscodesign.pump.bus.transactions import ARBOTIX
from viscodesign.pump.simulated.firmware import Firmware, Work, hang
from viscodesign.pump.simulated.pose_engine import PoseEngine

SIZE_POSE, LOAD_POSE, LOAD_SEQ, PLAY, LOOP, TEST = 7, 8, 9, 10, 11, 25
LONGEST_READ = 26
"""Longer ones overwrite what lies behind the buffer of 32 bytes: the sequence."""


class PyPose(Firmware):
    """38400 baud; no pins, no way to ask what it is doing."""

    baud = 38_400
    checksum_error = 64

    def start(self) -> None:
        self.engine = PoseEngine(self)

    def obey(self, packet: Packet) -> Work:
        if packet.id == ARBOTIX:
            self.reply(ARBOTIX, 0)
            yield from self._own(packet)
        elif packet.code == Instruction.READ:
            if self._parameters[1] > LONGEST_READ:
                self.engine.sequence[:] = [(0, 0)] * len(self.engine.sequence)
            yield from self.pass_read(packet)
        elif packet.code == Instruction.WRITE:
            yield from self.pass_write(packet)

    def _own(self, packet: Packet) -> Work:
        match packet.code:
            case code if code == SIZE_POSE:
                yield from self.engine.set_size(self._parameters[0])
            case code if code == LOAD_POSE:
                self.send(b"New Pose:")
                self.engine.load_pose(bytes(self._parameters))
                self.send(b"\r\n")
            case code if code == LOAD_SEQ:
                self.engine.load_sequence(bytes(self._parameters), len(packet.parameters) + 2)
            case code if code == PLAY:
                yield from self.engine.play()
            case code if code == LOOP:
                yield from self._loop_sequence()
            case code if code == TEST:
                yield from hang()

    def _loop_sequence(self) -> Work:
        """Round and round until an H; an empty one for ever, since nobody looks then."""
        if self.engine.sequence[0][0] == 255:
            yield from hang()
        while True:
            yield from self.engine.play()
            if self.engine.halted:
                return
