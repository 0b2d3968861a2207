"""What `pump calibrate` keeps in a servo without power: its id, its angle limits, its answers."""

from __future__ import annotations

from dataclasses import dataclass

from viscodesign.errors import PumpError
from viscodesign.pump.ax.preflight import ANSWERS_ALL, FoundServo
from viscodesign.pump.ax.servo_state import read_register
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.registers import Register


@dataclass(frozen=True)
class RegisterChange:
    """One register of the EEPROM that is to hold another value."""

    servo: int
    register: Register
    before: int
    after: int

    def __str__(self) -> str:
        return f"servo {self.servo}: {self.register.name} {self.before} -> {self.after}"


def changes(servo: FoundServo, travel: tuple[int, int]) -> list[RegisterChange]:
    """What differs from a calibrated servo; nothing where nothing does."""
    wanted = [
        (registers.CW_LIMIT, servo.limits[0], travel[0]),
        (registers.CCW_LIMIT, servo.limits[1], travel[1]),
        (registers.STATUS_LEVEL, servo.status_level, ANSWERS_ALL),
    ]
    return [
        RegisterChange(servo.id, r, before, after) for r, before, after in wanted if before != after
    ]


def write(board: Board, change: RegisterChange) -> None:
    """Write one register, and see by reading that it holds the value."""
    data = change.register.encode(change.after)
    board.write_permanent(change.servo, change.register.address, data)
    renamed = change.register == registers.ID
    held = read_register(board, change.after if renamed else change.servo, change.register)
    if held != change.after:
        raise PumpError(f"{change}: it holds {held}; is its EEPROM locked? Switch it off and on")
