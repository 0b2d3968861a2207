"""`--board arbotix-ros`: the ArbotiX with its firmware for ROS."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.boards.bus import BusBoard
from viscodesign.pump.bus import packets, registers
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.transactions import ARBOTIX, NoReplyError

MODEL = 300
LONGEST_READ = 24
DIGITAL_IN, ANALOG_IN, DIGITAL_OUT = 5, 18, 47
"""Registers of the board itself: ports of 8 pins, channels, single pins (`ros.h`)."""
PULLED_UP = b"\x02"
"""An input with its pull-up, so that a broken wire reads as high."""
FREE_PINS = [*range(1, 8), *range(12, 32)]
"""D0 is the lamp, D8 to D11 are the serial ports."""
SET_UP_AGAIN = 1.0
"""A board that was reset has forgotten its pull-ups; so they are set anew this often [s]."""


class ArbotixRos(BusBoard):
    """Lets SYNC_WRITE through; reads pins. Analog values have 8 bits."""

    name = "arbotix-ros"
    baud = 115_200
    streams = True
    has_pins = True
    boot = 2.0

    def __init__(self, line: Line, servos: Sequence[int] = ()) -> None:
        super().__init__(line, servos)
        self._set_up: dict[int, float] = {}
        """When each pin was made an input."""

    def identify(self) -> str:
        request = packets.read(ARBOTIX, 0, 3)
        try:
            data = self.wire.ask(request, 3, 0).parameters
        except NoReplyError as error:
            raise PumpError(
                f"no ArbotiX answers at {self.baud} baud. {error} The firmware of PyPose needs "
                "--board arbotix; an adapter without an ArbotiX needs --board dynamixel"
            ) from None
        if not data:
            raise PumpError("the firmware of PyPose answers here: use --board arbotix")
        if (model := int.from_bytes(data[:2], "little")) != MODEL:
            raise PumpError(f"model {model} answers with id {ARBOTIX}; an ArbotiX is {MODEL}")
        return f"ArbotiX with the firmware for ROS, version {data[2]}"

    def read(self, servo: int, address: int, count: int) -> bytes:
        """In pieces: its buffer for servos holds 32 bytes."""
        starts = range(address, address + count, LONGEST_READ)
        ends = [min(start + LONGEST_READ, address + count) for start in starts]
        pairs = zip(starts, ends, strict=True)
        return b"".join(self.wire.read(servo, start, end - start) for start, end in pairs)

    def write(self, servo: int, address: int, data: bytes) -> None:
        """Read back: it says of every write that it is done, and does not hear the servo."""
        for start, piece in _pieces(address, data):
            self.wire.write(servo, start, piece)
            self.wire.verify(servo, start, piece)

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        for start, piece in _pieces(address, data):
            self.wire.write_permanent(servo, start, piece)
            renamed = piece[0] if start == registers.ID.address else servo
            self.wire.verify(renamed, start, piece)

    def analog(self, channel: int) -> float:
        if not 0 <= channel <= 7:
            raise UsageError(f"analog channel {channel}; the board has 0 to 7")
        (value,) = self.wire.read(ARBOTIX, ANALOG_IN + channel, 1)
        return (value + 0.5) / 256

    def digital(self, pin: str) -> bool:
        number = pin_number(pin)
        now = self.line.clock.now()
        if now - self._set_up.get(number, -math.inf) >= SET_UP_AGAIN:
            self.wire.write(ARBOTIX, DIGITAL_OUT + number, PULLED_UP)
            self._set_up[number] = now
        (levels,) = self.wire.read(ARBOTIX, DIGITAL_IN + number // 8, 1)
        return bool(levels >> number % 8 & 1)


def _pieces(address: int, data: bytes) -> list[tuple[int, bytes]]:
    """Two bytes each, the most that it passes on; more it cuts off."""
    return [(address + k, data[k : k + 2]) for k in range(0, len(data), 2)]


def pin_number(pin: str) -> int:
    """Of 'D1' and its like, where a switch may hang."""
    found = re.fullmatch(r"D(\d{1,2})", pin)
    if not found or int(found[1]) not in FREE_PINS:
        raise UsageError(
            f"{pin!r} is no pin for a switch; those are D1 to D7 and D12 to D31 "
            "(D0 is the lamp, D8 to D11 are the serial ports)"
        )
    return int(found[1])
