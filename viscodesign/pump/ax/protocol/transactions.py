"""Requests and their replies, each reply checked to be the one that was asked for."""

from __future__ import annotations

import math

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import ErrorBits, Instruction, Packet, Parser
from viscodesign.pump.ax.protocol.registers import ID, RAM, Register
from viscodesign.pump.bus.line import Line

TRIES = 3  # of what may be repeated
SILENCE = 0.1  # servos drop a packet whose bytes are this far apart [s] (e-manual, Protocol 1.0).
ARBOTIX = 253  # id by which the firmwares of the ArbotiX answer for themselves
ROS_MODEL = 300  # model number of its firmware for ROS
BROKEN = ErrorBits.CHECKSUM | ErrorBits.INSTRUCTION
"""Reported of a corrupt request (the PyPose firmware answers a wrong checksum by 64)."""
MAX_READ_BYTES = 4096  # taken from the line at once
REMEDIES = {
    ErrorBits.OVERLOAD: "Nothing holds the plunger now. Release the pressure, find what blocked "
    "it, and cycle the power",
    ErrorBits.OVERHEAT: "Let it cool down",
    ErrorBits.VOLTAGE: "Check the supply voltage and charge the battery",
    ErrorBits(0xFF): "See the log of bytes (--log FILE; log=... of the address in Python)",
}


class ServoError(PumpError):
    """A reply with error bits."""

    def __init__(self, servo: int, request: Packet, reply: Packet) -> None:
        self.servo = servo
        self.errors = ErrorBits(reply.code & 0x7F)
        self.data = reply.parameters
        """Registers that were read nonetheless; empty where it gave none."""
        remedy = next(words for bits, words in REMEDIES.items() if reply.code & bits)
        super().__init__(
            f"servo {servo} reports: {packets.meaning(reply.code)} (error byte {reply.code:#04x}, "
            f"asked {request}). {remedy}"
        )


class NoReplyError(PumpError):
    """Nothing came, or nothing that answers the request."""


class Transactions:
    """The host's side of the bus; one request at a time.

    Replies are checked for id, length, checksum and error bits. Reads and writes of absolute
    values are repeated where no valid reply came; what starts a motion program never is.

    A reply that did not come in time may come later, and then looks like the reply to something
    else. So a lost reply stays owed until a reply that cannot be confused with it has come: bytes
    do not overtake each other, so whatever was owed came before that, or never will.
    """

    patience: float = 0.1
    """How long to wait for a reply [s]."""
    longest: float = math.inf
    """How long to go on asking the same thing [s]."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self._owed: set[tuple[int, int]] = set()
        """Id and number of parameters of replies that did not come."""
        self._speaker: int | None = None  # the id that last sent registers

    def ping(self, servo: int) -> None:
        self.ask(packets.ping(servo), 0)

    def answers(self, servo: int, tries: int = 1) -> bool:
        """Whether a servo answers, with error bits too; asked once, since ids may be unused."""
        try:
            self.ask(packets.read(servo, ID.address, ID.size), ID.size, tries=tries)
        except ServoError:
            return True
        except NoReplyError:
            return False
        return True

    def read(self, servo: int, address: int, count: int) -> bytes:
        """Registers; asked up to `TRIES` times."""
        return self.ask(packets.read(servo, address, count), count).parameters

    def read_anyway(self, servo: int, address: int, count: int) -> tuple[bytes, ErrorBits]:
        """Registers and error bits; raises where no registers came."""
        try:
            return self.read(servo, address, count), ErrorBits(0)
        except ServoError as fault:
            if len(fault.data) != count:
                raise
            return fault.data, fault.errors

    def get(self, servo: int, register: Register) -> int:
        """Value of one register, whatever the error bits say."""
        data, _ = self.read_anyway(servo, register.address, register.size)
        return register.decode(data)

    def write(self, servo: int, address: int, data: bytes) -> None:
        """Set registers that are forgotten without power, to absolute values."""
        if address < RAM:
            raise PumpError(
                f"servo {servo}: address {address} is in the EEPROM, which only "
                "`pump calibrate` writes"
            )
        self.ask(packets.write(servo, address, data), 0)

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        """Set registers that are kept without power: for `pump calibrate` alone.

        Cells wear out, so what is there already is left alone.
        """
        if self.read(servo, address, len(data)) != data:
            self.ask(packets.write(servo, address, data), 0)

    def set(self, servo: int, register: Register, value: int, *, read_back: bool = False) -> None:
        """Write one register that is forgotten without power.

        ``read_back``: by a read of its own too, whatever the board has seen of it and the error
        bits say; raises `PumpError` where the servo holds something else.
        """
        self.write(servo, register.address, register.encode(value))
        if read_back and (held := self.get(servo, register)) != value:
            raise _kept_other(servo, register.name, value, held)

    def verify(self, servo: int, address: int, data: bytes) -> None:
        """Read back what was written; raises `PumpError` where a servo holds something else."""
        if (held := self.read(servo, address, len(data))) != data:
            where = f"address {address}"
            raise _kept_other(servo, where, packets.shown(data), packets.shown(held))

    def send(self, packet: Packet) -> None:
        """Send a packet that gets no answer."""
        self.line.drain()
        self.line.write(packet.encode())

    def start(self, packet: Packet) -> None:
        """Start a motion program: sent once, since it may have begun though no reply came."""
        if not self._settle(packet.id):
            raise NoReplyError(f"not sent: {packet}. Earlier replies were lost")
        try:
            self.ask(packet, 0, tries=1)
        except NoReplyError as error:
            raise NoReplyError(
                f"{error} It may have started all the same and is not repeated: check where "
                "the plunger is, and stop it with `pump stop`"
            ) from None

    def ask(
        self, packet: Packet, *lengths: int, tries: int = TRIES, patience: float | None = None
    ) -> Packet:
        """The reply, with one of these numbers of parameters.

        Raises `ServoError` where it has error bits, `NoReplyError` where none came. A request
        that is reported to be corrupt is repeated like a lost one.
        """
        came, reply = b"", None
        deadline = self.line.clock.now() + self.longest
        for k in range(tries):
            if k > 0 and self.line.clock.now() >= deadline:
                break
            settled = self._settle(packet.id)
            if not settled and packet.code == Instruction.READ:
                continue
            # Before it is sent: whatever breaks in between, the reply may still come.
            owed = {(packet.id, length) for length in lengths}
            self._owed |= owed
            reply, came = self._exchange(packet, lengths, patience or self.patience)
            if not settled:
                reply = None
            elif reply is not None:
                self._owed -= owed
                if not reply.code & BROKEN:
                    break
        if reply is None:
            raise NoReplyError(_nothing(packet, came, tries))
        if reply.parameters:
            self._speaker = packet.id
        if reply.code:
            raise ServoError(packet.id, packet, reply)
        return reply

    def _exchange(
        self, packet: Packet, lengths: tuple[int, ...], patience: float
    ) -> tuple[Packet | None, bytes]:
        """One request; its reply where one came, and all bytes that came."""

        def answers(reply: Packet) -> bool:
            refused = reply.code != 0 and not reply.parameters
            fits = len(reply.parameters) in lengths or refused
            return reply.id == packet.id and fits and reply != packet

        self.send(packet)
        deadline = self.line.clock.now() + patience
        parser, came = Parser(), b""
        while data := self.line.read(MAX_READ_BYTES, deadline):
            came += data
            for reply in filter(answers, parser.feed(data)):
                return reply, came
            if self.line.clock.now() >= deadline:  # on a line that never falls silent
                break
        return next(filter(answers, parser.rest()), None), came

    def _settle(self, servo: int) -> bool:
        """Wait out what this one owes; whether nothing can be taken for another reply now."""
        if not any(owing == servo for owing, _ in self._owed):
            return True
        deadline = self.line.clock.now() + SILENCE
        while self.line.read(MAX_READ_BYTES, deadline) and self.line.clock.now() < deadline:
            pass
        speaker = servo if self._speaker is None else self._speaker
        # A firmware that only acknowledges, before any servo has spoken: silence must do.
        silent = servo == ARBOTIX and self._speaker is None
        if any(map(self._speaks, {servo, speaker})) or silent:
            self._owed.clear()
            return True
        return False

    def _speaks(self, servo: int) -> bool:
        """Whether this one sends as many registers as none of the owed replies has."""
        length = next(n for n in range(3, 64) if (servo, n) not in self._owed)
        reply, _ = self._exchange(packets.read(servo, 0, length), (length,), self.patience)
        if reply is not None and len(reply.parameters) == length:
            return True
        self._owed.add((servo, length))
        return False


def _kept_other(servo: int, where: str, sent: object, held: object) -> PumpError:
    return PumpError(
        f"servo {servo}: {where} was set to {sent}, but reads {held}; switch the servo off and on, "
        "and check its supply and cable"
    )


def _nothing(packet: Packet, came: bytes, tries: int) -> str:
    asked = f"id {packet.id} did not answer {packet}"
    if packet.encode() in came:
        return (
            f"{asked}: only the request itself came back. The adapter echoes what it sends, or "
            "nothing else is on the bus"
        )
    times = "once" if tries == 1 else f"{tries} times"
    return (
        f"{asked}, sent {times}; received {packets.shown(came)}. Is the power on, the id right "
        "(`pump status`), and this the right board and baud rate?"
    )
