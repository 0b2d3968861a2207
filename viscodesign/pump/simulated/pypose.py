"""The firmware that ArbotiX boards come with, PyPose's, with its traps, and its pose engine.

Read from `pypose.ino` and `BioloidController.cpp` of vanadiumlabs' ArbotiX repository. The firmware
acknowledges whatever is sent to id 253, before it does it; answers writes for servos that are not
there; forgets all at a reset; and while it plays looks at one byte for each move. Its TEST is left
out. The engine counts in its own integers: positions in eighths of a count, frames of 33 ms, a step
of each frame that is a whole number of eighths, and no way to wait.
"""

from __future__ import annotations

from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.ax.protocol.packets import Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.simulated.firmware import Firmware, Work, hang

SIZE_POSE, LOAD_POSE, LOAD_SEQ, PLAY, LOOP = 7, 8, 9, 10, 11
FIRMWARE_FRAME = 0.033
FIRMWARE_FRAME_MS = 33
SHIFT = 3
MAX_SERVOS = 30
POSES = 30
ENTRIES = 50
END_OF_SEQUENCE = 255
READ_PAUSE = 0.025
HALT = ord("H")


class PoseEngine:
    """Poses, a sequence of them, and the way from one to the next."""

    def __init__(self, board: Firmware) -> None:
        self.board = board
        self.size = 0
        self.pose = [512] * MAX_SERVOS
        """Where each servo was sent last, in eighths; before a reading 512, which is count 64."""
        self.poses = [[0] * MAX_SERVOS for _ in range(POSES)]
        self.sequence: list[tuple[int, int]] = [(0, 0)] * ENTRIES
        self.frames = 0  # since power came: how often all servos were sent somewhere

    def obey(self, code: int, given: bytes, length: int) -> Work:
        """One of its instructions but LOOP; ``given``: the parameters and what lies behind them."""
        if code == SIZE_POSE:
            yield from self._set_size(given[0])
        elif code == LOAD_POSE and given[0] < POSES:  # beyond lies other memory
            words = [given[k : k + 2] for k in range(1, 2 * self.size, 2)]
            self.poses[given[0]][: self.size] = [int.from_bytes(w, "little") for w in words]
        elif code == LOAD_SEQ:
            for k in range(length // 3):
                time = int.from_bytes(given[3 * k + 1 : 3 * k + 3], "little", signed=True)
                self.sequence[k] = (given[3 * k], time)
        elif code == PLAY:
            yield from self.play()

    def _set_size(self, size: int) -> Work:
        """Also reads where the servos are; an unreadable one is taken to be at -1."""
        self.size = min(size, MAX_SERVOS)
        for servo in range(self.size):
            position = registers.PRESENT_POSITION.address
            count = yield from self.board.ask_servo(servo + 1, position, 2)
            self.pose[servo] = count << SHIFT
            yield self.board.now + READ_PAUSE

    def play(self) -> Work:
        """Each entry once; `halted` says whether an H ended it. Looks for one between moves."""
        self.halted = False
        for pose, time in self.sequence:
            if pose == END_OF_SEQUENCE:
                return
            if self.board.read() == HALT:
                self.halted = True
                return
            yield from self._move(self.poses[pose] if pose < POSES else [0] * MAX_SERVOS, time)
        yield from hang()  # it runs off the end of the array

    def _move(self, target: list[int], time: int) -> Work:
        goals = [position << SHIFT for position in target]
        frames = _divided(time, FIRMWARE_FRAME_MS) + 1
        steps = [_divided(abs(goals[i] - self.pose[i]), frames) + 1 for i in range(self.size)]
        moving = True
        while moving:
            yield self.board.now + FIRMWARE_FRAME
            moving = not all([self._step(i, goals[i], steps[i]) for i in range(self.size)])
            self._send()

    def _step(self, servo: int, goal: int, step: int) -> bool:
        """Whether it stands at the goal."""
        left = goal - self.pose[servo]
        if abs(left) < step or left == 0:
            self.pose[servo] = goal
            return True
        self.pose[servo] += step if left > 0 else -step
        return False

    def _send(self) -> None:
        self.frames += 1
        words = [(self.pose[i] >> SHIFT) & 0xFFFF for i in range(self.size)]
        if words:
            goals = {i: word.to_bytes(2, "little") for i, word in enumerate(words, 1)}
            packet = packets.sync_write(registers.GOAL_POSITION.address, goals)
            self.board.bench.answer(packet, self.board.now)


def _divided(number: int, by: int) -> int:
    """As C divides: towards zero; by zero as this processor does it."""
    return int(number / by) if by else -1


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
        if self.engine.sequence[0][0] == END_OF_SEQUENCE:
            yield from hang()
        yield from self.engine.play()
        while not self.engine.halted:
            yield from self.engine.play()
