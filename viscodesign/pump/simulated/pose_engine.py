"""The pose engine of the ArbotiX, in its own integers.

Read from `BioloidController.cpp` of vanadiumlabs' ArbotiX repository: positions in eighths of
a count, frames of 33 ms, a step of each frame that is a whole number of eighths, and no way to
wait.
"""

from __future__ import annotations

from viscodesign.pump.bus import packets, registers
from viscodesign.pump.simulated.firmware import Firmware, Work, hang

FRAME = 0.033
FRAME_MS = 33
SHIFT = 3
SERVOS = 30
POSES = 30
ENTRIES = 50
END = 255
READ_PAUSE = 0.025
HALT = ord("H")


class PoseEngine:
    """Poses, a sequence of them, and the way from one to the next."""

    def __init__(self, board: Firmware) -> None:
        self.board = board
        self.size = 0
        self.pose = [512] * SERVOS
        """Where each servo was sent last, in eighths; before a reading 512, which is count 64."""
        self.poses = [[0] * SERVOS for _ in range(POSES)]
        self.sequence: list[tuple[int, int]] = [(0, 0)] * ENTRIES
        self.frames = 0
        """Since power came: how often all servos were sent somewhere."""

    def set_size(self, size: int) -> Work:
        """Also reads where the servos are; an unreadable one is taken to be at -1."""
        self.size = min(size, SERVOS)
        for servo in range(self.size):
            position = yield from self.board.ask_servo(
                servo + 1, registers.PRESENT_POSITION.address, 2
            )
            self.pose[servo] = position << SHIFT
            yield self.board.now + READ_PAUSE

    def load_pose(self, parameters: bytes) -> None:
        index = parameters[0]
        if index < POSES:  # beyond lies other memory
            self.poses[index] = [
                int.from_bytes(parameters[2 * i + 1 : 2 * i + 3], "little")
                for i in range(self.size)
            ] + self.poses[index][self.size :]

    def load_sequence(self, parameters: bytes, length: int) -> None:
        for i in range((length - 2) // 3):
            pose, low, high = parameters[3 * i : 3 * i + 3]
            self.sequence[i] = (pose, _signed(low + (high << 8)))

    def play(self) -> Work:
        """Each entry once; `halted` tells whether an H ended it. Looks for one between moves."""
        self.halted = False
        for pose, time in self.sequence:
            if pose == END:
                return
            if self.board.read() == HALT:
                self.halted = True
                return
            yield from self._move(self.poses[pose] if pose < POSES else [0] * SERVOS, time)
        yield from hang()  # it runs off the end of the array

    def _move(self, target: list[int], time: int) -> Work:
        goals = [position << SHIFT for position in target]
        frames = _divided(time, FRAME_MS) + 1
        steps = [_divided(abs(goals[i] - self.pose[i]), frames) + 1 for i in range(self.size)]
        moving = True
        while moving:
            yield self.board.now + FRAME
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
        goals = {
            i + 1: ((self.pose[i] >> SHIFT) & 0xFFFF).to_bytes(2, "little")
            for i in range(self.size)
        }
        if goals:
            packet = packets.sync_write(registers.GOAL_POSITION.address, goals)
            self.board.bench.answer(packet, self.board.now)


def _signed(word: int) -> int:
    """As a C int of 16 bits."""
    return word - 0x10000 if word >= 0x8000 else word


def _divided(number: int, by: int) -> int:
    """As C divides: towards zero; by zero as this processor does it."""
    if by == 0:
        return -1
    return abs(number) // abs(by) * (1 if (number < 0) == (by < 0) else -1)
