"""The firmware that ArbotiX boards come with, PyPose's, with its traps.

Read from `pypose.ino` of vanadiumlabs' ArbotiX repository. It acknowledges whatever is sent to
id 253, before it does it; answers writes for servos that are not there; forgets all at a reset;
and while it plays looks at one byte for each move. Its TEST is left out.
"""

from __future__ import annotations

from viscodesign.pump.ax.protocol.packets import Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.simulated.firmware import Firmware, Work, hang
from viscodesign.pump.simulated.pose_engine import END, LOAD_POSE, LOOP, PoseEngine


class PyPose(Firmware):
    """38400 baud; no pins, no way to ask what it is doing."""

    baud = 38_400
    checksum_error = 64

    def start(self) -> None:
        self.engine = PoseEngine(self)

    def own(self, packet: Packet) -> Work:
        self.reply(ARBOTIX, 0)
        if packet.code == LOOP:
            yield from self._loop_sequence()
        if packet.code == LOAD_POSE:
            self.send(b"New Pose:\r\n")
        length = len(packet.parameters)
        yield from self.engine.obey(packet.code, bytes(self._parameters), length)

    def _loop_sequence(self) -> Work:
        """Play the sequence until an H arrives; an empty one hangs, since no byte is read."""
        if self.engine.sequence[0][0] == END:
            yield from hang()
        yield from self.engine.play()
        while not self.engine.halted:
            yield from self.engine.play()
