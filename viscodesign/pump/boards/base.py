"""What every board of servos can be asked; by default it passes everything through to their bus."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import ClassVar

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.ax.protocol.packets import Instruction, shown
from viscodesign.pump.ax.protocol.registers import FULL
from viscodesign.pump.ax.protocol.transactions import Transactions
from viscodesign.pump.boards.controller import Controller
from viscodesign.pump.bus.line import Line

MOVING_PATIENCE = 0.05
"""For a reply while something moves [s]: three times what the slowest adapters take."""
LONGEST_MOVING_WAIT = 0.15
"""For all tries to get one [s]: a silence of a quarter of a second stops a pump."""


@dataclass(frozen=True)
class Goal:
    """Where one servo is to go."""

    count: int
    """Goal position, 0 to 1023."""
    speed: int
    """Speed register, 1 to 1023 (0 would be full speed, and is refused)."""
    torque: int | None = None
    """Torque limit register, 1 to 1023; None leaves it as it is."""
    held: int | None = None
    """Torque limit in force, which ``torque`` differs from in one byte: only that one is sent."""

    def __post_init__(self) -> None:
        if not 0 <= self.count <= FULL:
            raise PumpError(f"goal position must be 0 to {FULL} counts; got {self.count}")
        if not 1 <= self.speed <= FULL:
            raise PumpError(f"speed register must be 1 to {FULL}; got {self.speed}")
        if self.torque is not None and not 1 <= self.torque <= FULL:
            raise PumpError(f"torque limit register must be 1 to {FULL}; got {self.torque}")


class Board(Controller, Transactions):
    """One kind of board between a serial line and the servos' bus; a board is a file."""

    limits_torque: ClassVar[bool] = True
    """Whether a move sets torque limits too, in the same transaction."""

    def __init__(self, line: Line, axes: Sequence[int] = ()) -> None:
        Controller.__init__(self, line, axes)
        Transactions.__init__(self, line)

    @staticmethod
    def sets(request: bytes) -> bool:
        return request[4:5] in (bytes([Instruction.WRITE]), bytes([Instruction.SYNC_WRITE]))

    @staticmethod
    def shown(request: bytes) -> str:
        return shown(request)

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        """Set registers of the EEPROM where they differ, read back: for `pump calibrate` alone."""
        super().write_permanent(servo, address, data)
        self.verify(data[0] if address == registers.ID.address else servo, address, data)

    def hurry(self) -> None:
        """From now on something moves: give up asking before a silence has lasted too long."""
        self.patience, self.longest = MOVING_PATIENCE, LONGEST_MOVING_WAIT

    def move(self, goals: Mapping[int, Goal]) -> None:
        """Set speed and goal of all named servos, in one transaction where the board can.

        Torque limits only where the board `limits_torque`. Nobody acknowledges it: whether it
        came, the next readings show.
        """
        blocks: dict[int, dict[int, bytes]] = {}
        high_bytes = {}
        for servo, goal in goals.items():
            data = registers.GOAL_POSITION.encode(goal.count)
            data += registers.MOVING_SPEED.encode(goal.speed)
            if goal.torque is not None:
                limit = registers.TORQUE_LIMIT.encode(goal.torque)
                if goal.held is None:
                    data += limit
                elif goal.held // 256 == goal.torque // 256:
                    data += limit[:1]
                else:  # lies apart
                    high_bytes[servo] = limit[1:]
            # A packet has one length, so there are several where only some limits change.
            blocks.setdefault(len(data), {})[servo] = data
        for _, block in sorted(blocks.items()):
            self.send(packets.sync_write(registers.GOAL_POSITION.address, block))
        if high_bytes:
            self.send(packets.sync_write(registers.TORQUE_LIMIT.address + 1, high_bytes))

    def halt(self) -> None:
        """Stop a program that runs on the board itself."""
