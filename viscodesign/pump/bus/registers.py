"""Control table of the servos AX-12A and AX-18A; where they differ, initial values are both's.

Source: ROBOTIS e-manual, AX-12A and AX-18A, Control Table.
"""

from __future__ import annotations

from dataclasses import dataclass

RAM = 24
"""First address that is forgotten without power; below it lies the EEPROM."""
END = 50
"""Behind the last address."""


@dataclass(frozen=True)
class Register:
    """One or two bytes, low one first."""

    address: int
    size: int
    name: str
    unit: str = ""
    writable: bool = True
    directed: bool = False
    """Whether bit 10 tells the direction: set for clockwise, which is towards lower counts."""

    def encode(self, value: int) -> bytes:
        return value.to_bytes(self.size, "little")

    def decode(self, data: bytes) -> int:
        """The value; of a directed register the signed one, positive towards higher counts."""
        value = int.from_bytes(data[: self.size], "little")
        if not self.directed:
            return value
        return -(value & 0x3FF) if value & 0x400 else value & 0x3FF

    def within(self, data: bytes, start: int) -> int:
        """The value out of a block that was read from ``start`` on."""
        return self.decode(data[self.address - start :])


MODEL = Register(0, 2, "model number", writable=False)
FIRMWARE = Register(2, 1, "firmware version", writable=False)
ID = Register(3, 1, "id")
BAUD = Register(4, 1, "baud rate", "2 Mbit/s / (v + 1)")
RETURN_DELAY = Register(5, 1, "return delay", "2 us")
CW_LIMIT = Register(6, 2, "clockwise angle limit", "counts")
CCW_LIMIT = Register(8, 2, "counter-clockwise angle limit", "counts")
TEMPERATURE_LIMIT = Register(11, 1, "highest temperature", "degC")
LOWEST_VOLTAGE = Register(12, 1, "lowest voltage", "0.1 V")
HIGHEST_VOLTAGE = Register(13, 1, "highest voltage", "0.1 V")
MAX_TORQUE = Register(14, 2, "max torque", "1/1023 of stall")
STATUS_LEVEL = Register(16, 1, "status return level")
ALARM_LED = Register(17, 1, "alarm LED", "error bits")
SHUTDOWN = Register(18, 1, "shutdown", "error bits")
TORQUE_ENABLE = Register(24, 1, "torque enable")
LED = Register(25, 1, "LED")
CW_MARGIN = Register(26, 1, "clockwise compliance margin", "counts")
CCW_MARGIN = Register(27, 1, "counter-clockwise compliance margin", "counts")
CW_SLOPE = Register(28, 1, "clockwise compliance slope", "counts")
CCW_SLOPE = Register(29, 1, "counter-clockwise compliance slope", "counts")
GOAL_POSITION = Register(30, 2, "goal position", "counts")
MOVING_SPEED = Register(32, 2, "moving speed", "0.111 rpm")
TORQUE_LIMIT = Register(34, 2, "torque limit", "1/1023 of stall")
PRESENT_POSITION = Register(36, 2, "present position", "counts", writable=False)
PRESENT_SPEED = Register(38, 2, "present speed", "0.111 rpm", writable=False, directed=True)
PRESENT_LOAD = Register(40, 2, "present load", "1/1023 of stall", writable=False, directed=True)
PRESENT_VOLTAGE = Register(42, 1, "present voltage", "0.1 V", writable=False)
PRESENT_TEMPERATURE = Register(43, 1, "present temperature", "degC", writable=False)
REGISTERED = Register(44, 1, "registered instruction", writable=False)
MOVING = Register(46, 1, "moving", writable=False)
LOCK = Register(47, 1, "EEPROM lock")
PUNCH = Register(48, 2, "punch", "1/1023 of stall")

TABLE: tuple[Register, ...] = tuple(
    value for value in list(globals().values()) if isinstance(value, Register)
)
"""All of them, by address."""

SPEED_UNIT = 0.111 / 60
"""Of the speed registers [turns/s]."""
