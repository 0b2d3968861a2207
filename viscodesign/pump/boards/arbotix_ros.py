"""`--board arbotix-ros`: the ArbotiX with its firmware for ROS."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.transactions import ARBOTIX, ROS_MODEL, NoReplyError
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus.line import Line

DIGITAL_IN, ANALOG_IN, DIGITAL_OUT = 5, 18, 47
"""Registers of the board itself: ports of 8 pins, channels, single pins (`ros.h`)."""
PULLED_UP = b"\x02"  # an input with its pull-up, so that a broken wire reads as high
FREE_PINS = [*range(1, 8), *range(12, 32)]  # D0 is the lamp, D8 to D11 are the serial ports
PULL_UP_INTERVAL = 1.0
"""A board that was reset has forgotten its pull-ups; so they are set anew this often [s]."""


class ArbotixRos(Board):
    """Lets SYNC_WRITE through; reads pins. Analog values have 8 bits."""

    name = "arbotix-ros"
    baud = 115_200
    has_pins = True
    boot = 2.0

    def __init__(self, line: Line, axes: Sequence[int] = ()) -> None:
        super().__init__(line, axes)
        self._pulled_up: dict[int, float] = {}  # when each pin was made an input [s of the clock]

    def _identity(self) -> str:
        request = packets.read(ARBOTIX, 0, 3)
        try:
            data = self.ask(request, 3, 0).parameters
        except NoReplyError as error:
            raise PumpError(
                f"no ArbotiX answers at {self.baud} baud. {error} The firmware of PyPose needs "
                "the board arbotix; an adapter without an ArbotiX needs the board dynamixel"
            ) from None
        if not data:
            raise PumpError("the firmware of PyPose answers here: use the board arbotix")
        if (model := int.from_bytes(data[:2], "little")) != ROS_MODEL:
            raise PumpError(f"model {model} answers with id {ARBOTIX}; an ArbotiX is {ROS_MODEL}")
        return f"ArbotiX with the firmware for ROS, version {data[2]}"

    def write(self, servo: int, address: int, data: bytes) -> None:
        """Read back: it acknowledges every write, and does not hear the servo."""
        super().write(servo, address, data)
        self.verify(servo, address, data)

    def analog(self, channel: int) -> float:
        if not 0 <= channel <= 7:
            raise UsageError(f"analog channel {channel}; the board has 0 to 7")
        (value,) = self.read(ARBOTIX, ANALOG_IN + channel, 1)
        return (value + 0.5) / 256

    def digital(self, pin: str) -> bool:
        found = re.fullmatch(r"D(\d{1,2})", pin)
        if not found or (number := int(found[1])) not in FREE_PINS:
            raise UsageError(
                f"{pin!r} cannot take a switch; D1 to D7 and D12 to D31 can "
                "(D0 is the lamp, D8 to D11 are the serial ports)"
            )
        now = self.line.clock.now()
        if now - self._pulled_up.get(number, -math.inf) >= PULL_UP_INTERVAL:
            super().write(ARBOTIX, DIGITAL_OUT + number, PULLED_UP)
            self._pulled_up[number] = now
        (levels,) = self.read(ARBOTIX, DIGITAL_IN + number // 8, 1)
        return bool(levels >> number % 8 & 1)


class Simulated(ArbotixRos):
    """`--board simulated`: a computed ArbotiX with the firmware for ROS, and a pump behind it."""

    name = "simulated"
    simulated = True
