"""`--board arbotix`: an ArbotiX with the firmware it comes with, PyPose's.

It plays sequences of poses by itself, and lets single reads and writes through to the servos:
neither PING nor SYNC_WRITE. It says that a write was done before it does it, even where no servo
is there, so a write is checked by reading.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus import packets, registers
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.packets import ErrorBits, Packet, shown
from viscodesign.pump.bus.transactions import ARBOTIX, NoReplyError, ServoError, Transactions

HALT = b"H"
"""Looked for between two moves; not a packet."""
LONGEST_READ = 26
"""Bytes; a longer read overwrites the sequence."""
LONGEST_WRITE = 2
"""Bytes; the firmware cuts off the rest."""
ROS_MODEL = 300
"""Model number that the other firmware gives for itself."""
PATIENCE = 0.5
"""For a reply [s], as the firmware's own host program has it."""
HALTS = 3
"""Times that a halt is sent; one that nobody waits for does no harm."""
READING = 0.03
"""That SIZE_POSE takes for each servo [s]."""
SETTLING = 0.25
"""More, for variants of the firmware that try again or print what they read [s]."""


class Arbotix(Board):
    """While it plays it looks at one byte for each move, so then nothing but a halt is sent."""

    name = "arbotix"
    baud = 38_400
    streams = False
    has_pins = False
    boot = 2.0

    def __init__(self, line: Line, servos: Sequence[int] = ()) -> None:
        super().__init__(line, servos)
        self.wire = Transactions(line, PATIENCE)
        self._speeds: dict[int, int] = {}
        """Moving speeds that were last sent."""

    def identify(self) -> str:
        request = packets.read(ARBOTIX, registers.MODEL.address, registers.MODEL.size)
        try:
            reply = self.wire.ask(request, 2, 0)
        except NoReplyError as error:
            raise PumpError(
                f"no ArbotiX answers at {self.baud} baud: {error} It may also be playing poses, "
                "which `pump stop --board arbotix` ends; an adapter without an ArbotiX is "
                "--board dynamixel"
            ) from None
        if reply.parameters:
            model = registers.MODEL.decode(reply.parameters)
            kind = "the ROS firmware" if model == ROS_MODEL else f"model {model}"
            raise PumpError(
                f"this ArbotiX runs {kind}, not PyPose's; use --board arbotix-ros with "
                "`pump stream`, or load the sketch pypose.ino onto the board"
            )
        self.hello()
        return "ArbotiX with the PyPose firmware"

    def hello(self) -> None:
        """Ask for a sign of life: the board listens, and at the beginning of a packet."""
        self.wire.ping(ARBOTIX)

    def read(self, servo: int, address: int, count: int) -> bytes:
        if count > LONGEST_READ:
            raise PumpError(
                f"servo {servo}: {count} bytes at once; the PyPose firmware reads {LONGEST_READ}"
            )
        try:
            return self.wire.read(servo, address, count)
        except ServoError as fault:
            if fault.errors != ErrorBits.INSTRUCTION:
                raise
            # No servo says that of a read: it is the board, of packets that came broken.
            self.hello()
            return self.wire.read(servo, address, count)

    def write(self, servo: int, address: int, data: bytes) -> None:
        _refuse_long(servo, data)
        self.wire.write(servo, address, data)
        if address == registers.MOVING_SPEED.address:
            self._speeds[servo] = registers.MOVING_SPEED.decode(data)
        held = self.read(servo, address, len(data))
        # Without torque a servo gives the position it has as its goal.
        if held != data and address != registers.GOAL_POSITION.address:
            raise _not_taken(servo, address, data, held)

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        _refuse_long(servo, data)
        self.wire.write_permanent(servo, address, data)
        renamed = data[0] if address == registers.ID.address else servo
        held = self.read(renamed, address, len(data))
        if held != data:
            raise _not_taken(servo, address, data, held)

    def move(self, goals: Mapping[int, Goal]) -> None:
        """One write for each goal, and for each speed that changes; the positions tell the rest."""
        if not goals:
            raise PumpError("a move without servos")
        goal, speed = registers.GOAL_POSITION, registers.MOVING_SPEED
        for servo, each in goals.items():
            if self._speeds.get(servo) != each.speed:
                self.wire.write(servo, speed.address, speed.encode(each.speed))
                self._speeds[servo] = each.speed
            self.wire.write(servo, goal.address, goal.encode(each.count))

    def halt(self) -> None:
        """End a sequence after the move it is in; whether it has ended, `is_idle` tells."""
        self.line.drain()
        self.line.write(HALT * HALTS)

    def is_idle(self, patience: float) -> bool:
        """Whether it answers within a time [s]: only for a board that was halted or is done.

        While it plays, the bytes of the question would stand in the way of a halt.
        """
        try:
            # Of its own, since nothing is owed by a board that did not listen.
            Transactions(self.line).ask(packets.ping(ARBOTIX), 0, tries=1, patience=patience)
        except NoReplyError:
            return False
        return True

    def tell(self, packet: Packet) -> None:
        """One of the firmware's own instructions that may be repeated."""
        self.wire.ask(packet, 0)

    def size_pose(self, packet: Packet) -> None:
        """SIZE_POSE, and the time in which it reads where the servos are and hears nothing."""
        self.tell(packet)
        self.line.clock.sleep(READING * packet.parameters[0] + SETTLING)

    def start(self, packet: Packet) -> None:
        """PLAY or LOOP, sent once and never again.

        A greeting goes before it: what is left of a packet that was sent by halves would make
        the board complain of this one and obey it nonetheless.
        """
        self.hello()
        self.wire.start(packet)

    def analog(self, channel: int) -> float | None:
        return None

    def digital(self, pin: str) -> bool | None:
        return None


def _refuse_long(servo: int, data: bytes) -> None:
    if not 1 <= len(data) <= LONGEST_WRITE:
        raise PumpError(
            f"servo {servo}: {len(data)} bytes at once; the PyPose firmware writes one or two"
        )


def _not_taken(servo: int, address: int, data: bytes, held: bytes) -> PumpError:
    return PumpError(
        f"servo {servo}: address {address} was set to {shown(data)}, but reads {shown(held)}; "
        "switch the servo off and on, and check its supply and cable"
    )
