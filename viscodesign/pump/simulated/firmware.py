"""What the firmwares of the ArbotiX share: one processor, its inbox, and a parser with faults.

Read from the sources of vanadiumlabs' `pypose.ino` and `ros.ino` (ArbotiX repositories): one FF
begins a packet, nothing ends it but its length, and lengths below 2 or above 144 never end.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Generator

from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import Instruction, Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import BITS_PER_BYTE, Device, Outbox

Work = Generator[float, None, None]
"""Yields the moment at which the processor goes on, or `WHEN_BYTES_COME`."""
WHEN_BYTES_COME = -math.inf
NEVER = math.inf
INBOX_SIZE = 63  # bytes that the serial port keeps while the processor is busy; more are lost
LONGEST_LEN = 144  # of a packet: its parameters and checksum fill `params[143]`
LATENCY = 1e-3  # of the adapter, towards the host [s]
SERVO_TIMEOUT = 1e-3  # how long it waits for a servo that is not there [s]


class Firmware(Device):
    """A program on the board, written as the board's is: one thing after the other."""

    baud: int
    checksum_error: int
    """Error byte that answers a wrong checksum."""

    def __init__(self, bench: SimulatedBench) -> None:
        super().__init__()
        self.bench = bench
        self.now = 0.0
        self._coming = Outbox()
        self._inbox = bytearray()
        self._sent = 0.0
        self._program: Work | None = None
        self._wake = NEVER
        self.start()

    def reset(self, now: float, boot: float = 0.0) -> None:
        """Power, the button or DTR: all is forgotten, and what comes meanwhile is lost."""
        self.now = now
        self._parameters = bytearray(LONGEST_LEN - 1)
        self._received = b""
        self.start()
        self._program = self._loop(now + boot)
        self._wake = next(self._program)

    @abstractmethod
    def start(self) -> None:
        """What the sketch sets up."""

    @abstractmethod
    def own(self, packet: Packet) -> Work:
        """Do what a packet to the board itself says."""

    def obey(self, packet: Packet) -> Work:
        """Do what a complete packet says: reads and writes pass on to the servos."""
        if packet.id == ARBOTIX:
            yield from self.own(packet)
        elif packet.code == Instruction.READ:
            # Whatever lies in the buffer then goes back, once.
            yield from self.ask_servo(packet.id, self._parameters[0], self._parameters[1])
            self.send(self._received)
            self._received = b""
        elif packet.code == Instruction.WRITE:
            # One byte or two, whatever its length; acknowledged for any id.
            size = 1 if len(packet.parameters) == 2 else 2
            data = bytes(self._parameters[1 : 1 + size])
            self.bench.answer(packets.write(packet.id, self._parameters[0], data), self.now)
            self.reply(packet.id, 0)

    def feed(self, data: bytes, now: float) -> None:
        self.run(now)
        moment = max(now, self._coming.last)
        for value in data:
            moment += BITS_PER_BYTE / self.baud
            self._coming.put(bytes([value]), moment)

    def take(self, now: float) -> bytes:
        self.run(now)
        return super().take(now)

    def due(self) -> float:
        return min(super().due(), self._next())

    def run(self, until: float) -> None:
        """Run the processor up to a moment; the first call is power-on."""
        if self._program is None:
            self.reset(until)
        while (moment := self._next()) <= until:
            self.now = max(moment, self.now)
            self._receive(self.now)
            self.bench.advance(self.now)
            self._wake = next(self._program) if self._program else NEVER
        self._receive(until)
        self.bench.advance(until)

    def _next(self) -> float:
        """When the processor has something to do."""
        if self._wake != WHEN_BYTES_COME:
            return self._wake
        return self.now if self._inbox else self._coming.due()

    def _receive(self, now: float) -> None:
        self._inbox += self._coming.take(now)[: max(INBOX_SIZE - len(self._inbox), 0)]

    def read(self) -> int:
        """The next byte, or -1 where none is there."""
        return self._inbox.pop(0) if self._inbox else -1

    def send(self, data: bytes) -> None:
        """Send at the port's speed, behind what is still going out."""
        self._sent = max(self._sent, self.now) + len(data) * BITS_PER_BYTE / self.baud
        self.outbox.put(data, self._sent + LATENCY)

    def reply(self, id: int, error: int, data: bytes = b"") -> None:
        self.send(Packet(id, error, data).encode())

    def _loop(self, ready: float) -> Work:
        yield ready
        self._inbox.clear()
        while True:
            while (yield from self._byte()) != 0xFF:
                pass
            yield from self._packet()

    def _byte(self) -> Generator[float, None, int]:
        while not self._inbox:
            yield WHEN_BYTES_COME
        return self.read()

    def _packet(self) -> Work:
        """Behind one FF: further ones are skipped, then id, length, instruction, the rest."""
        while (id := (yield from self._byte())) == 0xFF:
            pass
        length = yield from self._byte()
        code = yield from self._byte()
        if not 2 <= length <= LONGEST_LEN:
            yield from hang()
        total = id + length + code
        for place in range(length - 1):
            self._parameters[place] = yield from self._byte()
            total += self._parameters[place]
        if total % 256 != 255:
            self.reply(id, self.checksum_error)
        else:
            yield from self.obey(Packet(min(id, 254), code, bytes(self._parameters[: length - 2])))

    def ask_servo(self, id: int, address: int, count: int) -> Generator[float, None, int]:
        """What `ax12GetRegister` gives: the first one or two bytes, or -1.

        The packet stays in a buffer. Where nothing answers the one before stays there.
        """
        answered = self.bench.answer(packets.read(id, address, count), self.now)
        if answered is None:
            yield self.now + SERVO_TIMEOUT
            return -1
        reply, delay = answered
        self._received = reply.encode()
        yield self.now + delay + (8 + len(self._received)) * BITS_PER_BYTE / 1e6
        value = self._received[5:-1] if count == 1 else self._received[5:7]
        return int.from_bytes(value[:2], "little")


def hang() -> Work:
    """Do nothing until a reset."""
    while True:
        yield NEVER
