"""What boards share that let the whole protocol through to the servos' bus."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus import packets, registers
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.transactions import Transactions

QUICK = 0.05
"""For a reply while something moves [s]: three times what the slowest adapters take."""
MOST = 0.15
"""For all tries to get one [s]: a silence of a quarter of a second stops a pump."""


class BusBoard(Board):
    """Reads and writes go to the servos, a move to all of them in one SYNC_WRITE."""

    limits_torque = True

    def __init__(self, line: Line, servos: Sequence[int] = ()) -> None:
        super().__init__(line, servos)
        self.wire = Transactions(line)

    def read(self, servo: int, address: int, count: int) -> bytes:
        return self.wire.read(servo, address, count)

    def write(self, servo: int, address: int, data: bytes) -> None:
        self.wire.write(servo, address, data)

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        self.wire.write_permanent(servo, address, data)

    def hurry(self) -> None:
        self.wire.patience, self.wire.longest = QUICK, MOST

    def answers(self, servo: int) -> bool:
        """Asked once: of ids that are not there, each question costs its patience."""
        return self.wire.answers(servo)

    def move(self, goals: Mapping[int, Goal]) -> None:
        """Nobody answers a SYNC_WRITE: whether it came, the positions tell."""
        if not goals:
            raise PumpError("a move without servos")
        start = registers.GOAL_POSITION.address
        for blocks in _by_length(goals):
            self.wire.tell(packets.sync_write(start, blocks))
        if high := {servo: _high(goal.torque) for servo, goal in goals.items() if _is_high(goal)}:
            self.wire.tell(packets.sync_write(registers.TORQUE_LIMIT.address + 1, high))

    def halt(self) -> None:
        """No program runs on it."""

    def analog(self, channel: int) -> float | None:
        return None

    def digital(self, pin: str) -> bool | None:
        return None


def _by_length(goals: Mapping[int, Goal]) -> list[dict[int, bytes]]:
    """What each servo is sent; a packet has one length, so there are two where only some differ."""
    blocks = {servo: _block(goal) for servo, goal in goals.items()}
    lengths = sorted({len(block) for block in blocks.values()})
    return [{s: block for s, block in blocks.items() if len(block) == n} for n in lengths]


def _block(goal: Goal) -> bytes:
    """Goal position, moving speed and what is to be sent of the torque limit, side by side."""
    data = registers.GOAL_POSITION.encode(goal.count) + registers.MOVING_SPEED.encode(goal.speed)
    if goal.torque is None or _is_high(goal):
        return data
    return data + registers.TORQUE_LIMIT.encode(goal.torque)[: 2 if goal.held is None else 1]


def _is_high(goal: Goal) -> bool:
    """Whether only the high byte of the torque limit is to be sent, which lies apart."""
    if goal.torque is None or goal.held is None:
        return False
    return goal.torque // 256 != goal.held // 256


def _high(torque: int | None) -> bytes:
    return bytes([(torque or 0) // 256])
