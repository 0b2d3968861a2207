"""Packets of the Dynamixel protocol 1.0: built, and found again in a stream of bytes.

Instruction FF FF ID LEN INS P1..Pn CHK, status FF FF ID LEN ERR P1..Pn CHK, with
LEN = n + 2 and CHK = ~(ID + LEN + INS + P1 + .. + Pn), lowest byte.
Source: ROBOTIS e-manual, Protocol 1.0.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import IntEnum, IntFlag

from viscodesign.lazy_dataclass import dataclass

HEADER = b"\xff\xff"
BROADCAST = 254  # addresses all servos, and is never answered
MAX_PARAMETERS = 253  # LEN is one byte and counts two more
OVERHEAD = 6  # bytes of a packet around its parameters


class Instruction(IntEnum):
    """Instructions of the servos; firmwares add numbers of their own."""

    PING = 1
    READ = 2
    WRITE = 3
    REG_WRITE = 4
    ACTION = 5
    RESET = 6
    SYNC_WRITE = 0x83


class ErrorBits(IntFlag):
    """Error bits of a status packet."""

    VOLTAGE = 1
    ANGLE_LIMIT = 2
    OVERHEAT = 4
    RANGE = 8
    CHECKSUM = 16
    OVERLOAD = 32
    INSTRUCTION = 64


MEANINGS = {
    ErrorBits.VOLTAGE: "supply voltage out of its limits",
    ErrorBits.ANGLE_LIMIT: "goal position outside the angle limits",
    ErrorBits.OVERHEAT: "too hot",
    ErrorBits.RANGE: "value out of a register's range",
    ErrorBits.CHECKSUM: "request arrived with a wrong checksum",
    ErrorBits.OVERLOAD: "overload: its torque is already off",
    ErrorBits.INSTRUCTION: "instruction not understood",
}


def meaning(errors: int) -> str:
    """Words for the bits that are set."""
    words = [text for bit, text in MEANINGS.items() if errors & bit]
    return ", ".join(
        words if errors < 128 else [*words, "an error bit that the protocol does not define"]
    )


def shown(data: bytes) -> str:
    """Bytes as people write them: FF FF 01."""
    return data.hex(" ").upper() or "nothing"


@dataclass(frozen=True)
class Packet:
    """One instruction or status packet."""

    id: int
    code: int
    """The instruction, or the error bits."""
    parameters: bytes = b""

    def __post_init__(self) -> None:
        if not (0 <= self.id <= BROADCAST and 0 <= self.code <= 255):
            raise ValueError(f"a packet with id {self.id}, code {self.code}")
        if len(self.parameters) > MAX_PARAMETERS:
            raise ValueError(f"{len(self.parameters)} parameters; a packet holds {MAX_PARAMETERS}")

    def encode(self) -> bytes:
        body = bytes([self.id, len(self.parameters) + 2, self.code]) + self.parameters
        return HEADER + body + bytes([_checksum(body)])

    def __str__(self) -> str:
        return shown(self.encode())


def _checksum(body: bytes | bytearray) -> int:
    return ~sum(body) & 0xFF


def ping(servo: int) -> Packet:
    return Packet(servo, Instruction.PING)


def read(servo: int, address: int, count: int) -> Packet:
    return Packet(servo, Instruction.READ, bytes([address, count]))


def write(servo: int, address: int, data: bytes) -> Packet:
    return Packet(servo, Instruction.WRITE, bytes([address]) + data)


def sync_write(address: int, data: Mapping[int, bytes]) -> Packet:
    """The same registers of several servos, each its own values of one common length."""
    (length,) = {len(values) for values in data.values()}
    each = b"".join(bytes([servo]) + values for servo, values in data.items())
    return Packet(BROADCAST, Instruction.SYNC_WRITE, bytes([address, length]) + each)


class Parser:
    """Finds packets in bytes that come in pieces, between noise and foreign text.

    What looks like a packet and has a wrong length or checksum is searched again from its second
    byte, since a true packet may have begun inside it.
    """

    def __init__(self, most: int = MAX_PARAMETERS) -> None:
        """``most`` parameters of the longest packet that may come."""
        self._most = most
        self._bytes = bytearray()

    def feed(self, data: bytes) -> list[Packet]:
        """Packets that these bytes complete."""
        self._bytes += data
        return list(self._complete())

    def rest(self) -> list[Packet]:
        """Packets behind an unfinished one, once nothing more will come; the parser is reset."""
        found: list[Packet] = []
        while self._bytes:
            del self._bytes[0]
            found += self._complete()
        return found

    def _complete(self) -> Iterator[Packet]:
        data = self._bytes
        while (start := data.find(HEADER)) >= 0:
            del data[:start]
            if len(data) < OVERHEAD:
                return
            size = data[3] + 4
            if data[2] > BROADCAST or not OVERHEAD <= size <= OVERHEAD + self._most:
                del data[0]
            elif len(data) < size:
                return
            elif _checksum(data[2 : size - 1]) != data[size - 1]:
                del data[0]
            else:
                yield Packet(data[2], data[4], bytes(data[5 : size - 1]))
                del data[:size]
        del data[: len(data) - data.endswith(HEADER[:1])]
