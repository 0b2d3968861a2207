"""Control table of the servos AX-12A and AX-18A.

Positions in counts, speeds in 0.111 rpm, torques in 1/1023 of stall, voltages in 0.1 V, return
delay in 2 us, temperatures in degC. Source: ROBOTIS e-manual, AX-12A and AX-18A, Control Table.
"""

from __future__ import annotations

import math

from viscodesign.lazy_dataclass import dataclass

RAM = 24  # first address that is forgotten without power; below it lies the EEPROM
TABLE_END = 50  # behind the last address
FULL = 1023  # highest position, speed and torque
SPEED_UNIT = 0.111 / 60  # of the speed registers [turns/s]
COUNTS_PER_TURN = 1024 * 360.0 / 300.0
"""1024 counts span 300 degrees (Goal Position)."""
COUNT_ANGLE = 2 * math.pi / COUNTS_PER_TURN  # [rad]
SPEED_ROUNDING = 1e-9
"""Part of a unit that a speed may be above a value by rounding alone."""


def speed_register(speed: float) -> int:
    """Smallest value of a speed register that is at least as fast [turns/s].

    Never 0, which is full speed, and at most full speed.
    """
    return min(max(math.ceil(abs(speed) / SPEED_UNIT - SPEED_ROUNDING), 1), FULL)


@dataclass(frozen=True)
class Register:
    """One or two bytes, low one first."""

    address: int
    size: int
    name: str
    initial: int = 0
    """As delivered, or after power came; where the types differ, or it is measured, 0."""
    highest: int = 255
    """Values above are refused."""
    writable: bool = True
    directed: bool = False
    """Whether bit 10 tells the direction: set for clockwise, which is towards lower counts."""

    @property
    def addresses(self) -> range:
        """Addresses of its bytes."""
        return range(self.address, self.address + self.size)

    def encode(self, value: int) -> bytes:
        return value.to_bytes(self.size, "little")

    def decode(self, data: bytes | bytearray) -> int:
        """The value; of a directed register the signed one, positive towards higher counts."""
        value = int.from_bytes(data[: self.size], "little")
        if not self.directed:
            return value
        return -(value & FULL) if value & 0x400 else value & FULL

    def within(self, data: bytes | bytearray, start: int) -> int:
        """The value in a block that was read from address ``start`` on."""
        return self.decode(data[self.address - start :])


MODEL = Register(0, 2, "model number", writable=False)
FIRMWARE = Register(2, 1, "firmware version", 24, writable=False)
ID = Register(3, 1, "id", 1, 253)
BAUD = Register(4, 1, "baud rate", 1)
RETURN_DELAY = Register(5, 1, "return delay", 250, 254)
CW_LIMIT = Register(6, 2, "clockwise angle limit", 0, FULL)
CCW_LIMIT = Register(8, 2, "counter-clockwise angle limit", FULL, FULL)
TEMPERATURE_LIMIT = Register(11, 1, "highest temperature")
LOWEST_VOLTAGE = Register(12, 1, "lowest voltage", 60)
HIGHEST_VOLTAGE = Register(13, 1, "highest voltage", 140)
MAX_TORQUE = Register(14, 2, "max torque", 0, FULL)
STATUS_LEVEL = Register(16, 1, "status return level", 2, 2)
ALARM_LED = Register(17, 1, "alarm LED", 36)
SHUTDOWN = Register(18, 1, "shutdown", 36)
TORQUE_ENABLE = Register(24, 1, "torque enable", 0, 1)
LED = Register(25, 1, "LED")
CW_MARGIN = Register(26, 1, "clockwise compliance margin", 1)
CCW_MARGIN = Register(27, 1, "counter-clockwise compliance margin", 1)
CW_SLOPE = Register(28, 1, "clockwise compliance slope", 32)
CCW_SLOPE = Register(29, 1, "counter-clockwise compliance slope", 32)
GOAL_POSITION = Register(30, 2, "goal position", 0, FULL)
MOVING_SPEED = Register(32, 2, "moving speed", 0, 2047)
TORQUE_LIMIT = Register(34, 2, "torque limit", 0, FULL)
PRESENT_POSITION = Register(36, 2, "present position", writable=False)
PRESENT_SPEED = Register(38, 2, "present speed", writable=False, directed=True)
PRESENT_LOAD = Register(40, 2, "present load", writable=False, directed=True)
PRESENT_VOLTAGE = Register(42, 1, "present voltage", writable=False)
PRESENT_TEMPERATURE = Register(43, 1, "present temperature", writable=False)
REGISTERED = Register(44, 1, "registered instruction", writable=False)
MOVING = Register(46, 1, "moving", writable=False)
LOCK = Register(47, 1, "EEPROM lock")
PUNCH = Register(48, 2, "punch", 32, FULL)

TABLE = tuple(value for value in list(globals().values()) if isinstance(value, Register))
"""All of them, by address."""
