"""What boards share that let the whole protocol through to the servos' bus."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pumps import packets, registers
from viscodesign.pumps.boards.base import Board, Goal
from viscodesign.pumps.line import Line
from viscodesign.pumps.transaction import Transactions

QUICK = 0.05
"""For a reply while something moves [s]: three times what the slowest adapters take."""
MOST = 0.15
"""For all tries to get one [s]: a silence of a quarter of a second stops a pump."""


class BusBoard(Board):
    """Reads and writes go to the servos, a move to all of them in one SYNC_WRITE."""

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
            raise PumpError("a move of no servo")
        self.wire.tell(packets.sync_write(registers.GOAL_POSITION.address, _blocks(goals)))

    def halt(self) -> None:
        """No program runs on it."""

    def analog(self, channel: int) -> float | None:
        return None

    def digital(self, pin: str) -> bool | None:
        return None


def _blocks(goals: Mapping[int, Goal]) -> dict[int, bytes]:
    """Goal position and moving speed, which lie side by side."""
    goal, speed = registers.GOAL_POSITION, registers.MOVING_SPEED
    return {
        servo: goal.encode(each.count) + speed.encode(each.speed) for servo, each in goals.items()
    }
