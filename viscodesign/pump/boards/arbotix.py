"""`--board arbotix`: an ArbotiX with the firmware it comes with, PyPose's.

It plays sequences of poses by itself, and lets single reads and writes through to the servos:
neither PING nor SYNC_WRITE. It acknowledges a write before it does it, even where no servo is
there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, Packet
from viscodesign.pump.ax.protocol.transactions import (
    ARBOTIX,
    ROS_MODEL,
    TRIES,
    NoReplyError,
    ServoError,
    Transactions,
)
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus.line import Line

HALT = b"H"  # looked for between two moves; not a packet
LONGEST_READ = 26  # bytes; a longer read overwrites the sequence
LONGEST_WRITE = 2  # bytes; the firmware cuts off the rest
HALTS = 3  # times that a halt is sent; further ones do no harm
READING_TIME = 0.03  # that SIZE_POSE takes for each servo [s]
SETTLING_TIME = 0.25
"""More, for variants of the firmware that try again or print what they read [s]."""


class Arbotix(Board):
    """While it plays it looks at one byte for each move, so then nothing but a halt is sent."""

    name = "arbotix"
    baud = 38_400
    streams = False
    plays_poses = True
    limits_torque = False
    boot = 2.0
    patience = 0.5

    def __init__(self, line: Line, axes: Sequence[int] = ()) -> None:
        super().__init__(line, axes)
        self._speeds: dict[int, int] = {}  # moving speeds that were last sent

    def _identity(self) -> str:
        request = packets.read(ARBOTIX, registers.MODEL.address, registers.MODEL.size)
        try:
            reply = self.ask(request, 2, 0)
        except NoReplyError as error:
            raise PumpError(
                f"no ArbotiX answers at {self.baud} baud: {error} It may also be playing poses, "
                "which `pump stop --board arbotix` ends; an adapter without an ArbotiX is "
                "the board dynamixel"
            ) from None
        if reply.parameters:
            model = registers.MODEL.decode(reply.parameters)
            kind = "the ROS firmware" if model == ROS_MODEL else f"model {model}"
            raise PumpError(
                f"this ArbotiX runs {kind}, not PyPose's; use the board arbotix-ros with "
                "`pump stream`, or load the sketch pypose.ino onto the board"
            )
        self.hello()
        return "ArbotiX with the PyPose firmware"

    def hello(self) -> None:
        """Check that the board listens, and is at the beginning of a packet."""
        self.ping(ARBOTIX)

    def read(self, servo: int, address: int, count: int) -> bytes:
        if count > LONGEST_READ:
            raise PumpError(
                f"servo {servo}: {count} bytes at once; the PyPose firmware reads {LONGEST_READ}"
            )
        try:
            return super().read(servo, address, count)
        except ServoError as fault:
            if fault.errors != ErrorBits.INSTRUCTION:
                raise
            # No servo says that of a read: it is the board, of packets that came broken.
            self.hello()
            return super().read(servo, address, count)

    def write(self, servo: int, address: int, data: bytes) -> None:
        if not 1 <= len(data) <= LONGEST_WRITE:
            raise PumpError(
                f"servo {servo}: {len(data)} bytes at once; the PyPose firmware writes one or two"
            )
        self._speeds.pop(servo, None)
        super().write(servo, address, data)
        # Without torque a servo gives the position it has as its goal.
        if address != registers.GOAL_POSITION.address:
            self.verify(servo, address, data)

    def answers(self, servo: int, tries: int = TRIES) -> bool:
        return super().answers(servo, tries)

    def hurry(self) -> None:
        """Nothing to do: it plays by itself."""

    def move(self, goals: Mapping[int, Goal]) -> None:
        """One write for each goal, and for each speed that changes."""
        position, speed = registers.GOAL_POSITION, registers.MOVING_SPEED
        for servo, goal in goals.items():
            if self._speeds.get(servo) != goal.speed:
                super().write(servo, speed.address, speed.encode(goal.speed))
                self._speeds[servo] = goal.speed
            super().write(servo, position.address, position.encode(goal.count))

    def halt(self) -> None:
        """End a sequence after the move it is in; whether it has ended, `is_idle` tells."""
        self.line.drain()
        self.line.write(HALT * HALTS)

    def is_idle(self, patience: float) -> bool:
        """Whether it answers within a time [s]: only for a board that was halted or is done.

        While it plays, the bytes of the question would stand in the way of a halt.
        """
        try:
            # A conversation of its own: a board that did not listen owes no reply.
            Transactions(self.line).ask(packets.ping(ARBOTIX), 0, tries=1, patience=patience)
        except NoReplyError:
            return False
        return True

    def tell(self, packet: Packet) -> None:
        """Send one of the firmware's own instructions that may be repeated."""
        self.ask(packet, 0)

    def size_pose(self, packet: Packet) -> None:
        """Send SIZE_POSE, and wait while it reads where the servos are and hears nothing."""
        self.tell(packet)
        self.line.clock.sleep(READING_TIME * packet.parameters[0] + SETTLING_TIME)

    def start(self, packet: Packet) -> None:
        """Send PLAY or LOOP, once and never again.

        A greeting goes before it: behind the rest of an incomplete packet the board would
        complain of this one and obey it nonetheless.
        """
        self.hello()
        super().start(packet)


class SimulatedArbotix(Arbotix):
    """A computed ArbotiX with PyPose, and a pump behind it."""

    simulated = True
