"""Requests and replies: nothing but the answer is taken for the answer."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import HEADER, Packet, Parser
from viscodesign.pump.ax.protocol.transactions import NoReplyError, ServoError, Transactions
from viscodesign.pump.bus.clock import Clock, SteppedClock
from viscodesign.pump.bus.line import Line

Behaviour = Callable[[int, Packet], list[tuple[float, bytes]]]
"""Number of a request and the request -> delays [s] and bytes of what comes then."""


class Scripted(Line):
    """A line on which comes what a function says."""

    def __init__(self, behaviour: Behaviour) -> None:
        self.clock: Clock = SteppedClock()
        self.sent: list[Packet] = []
        self._behaviour = behaviour
        self._coming: list[tuple[float, bytes]] = []

    def write(self, data: bytes) -> None:
        for packet in Parser().feed(data):
            answer = self._behaviour(len(self.sent), packet)
            self.sent.append(packet)
            for delay, reply in answer:
                earliest = self._coming[-1][0] if self._coming else 0.0
                self._coming.append((max(earliest, self.clock.now() + delay), reply))

    def read(self, most: int, deadline: float) -> bytes:
        if self._coming and self._coming[0][0] <= max(deadline, self.clock.now()):
            moment, data = self._coming.pop(0)
            self.clock.sleep_until(moment)
            return data
        self.clock.sleep_until(deadline)
        return b""

    def drain(self) -> bytes:
        data = b""
        while self._coming and self._coming[0][0] <= self.clock.now():
            data += self._coming.pop(0)[1]
        return data

    def close(self) -> None:
        pass


def truth(packet: Packet) -> bytes:
    """Register n holds n; writes are acknowledged."""
    if packet.code == packets.Instruction.READ:
        start, count = packet.parameters
        return Packet(packet.id, 0, bytes(range(start, start + count))).encode()
    return Packet(packet.id, 0).encode()


def well(_: int, packet: Packet) -> list[tuple[float, bytes]]:
    return [(0.001, truth(packet))]


def test_what_is_asked_is_answered() -> None:
    line = Scripted(well)
    wire = Transactions(line)
    assert wire.read(1, 36, 2) == bytes([36, 37])
    wire.write(1, 30, b"\x00\x02")
    wire.ping(1)
    assert [str(p) for p in line.sent] == [
        "FF FF 01 04 02 24 02 D2",
        "FF FF 01 05 03 1E 00 02 D6",
        "FF FF 01 02 01 FB",
    ]


@given(st.lists(st.floats(0.0, 3.0), min_size=12, max_size=12))
def test_a_late_reply_is_never_taken_for_another(delays: list[float]) -> None:
    def late(number: int, packet: Packet) -> list[tuple[float, bytes]]:
        return [(delays[number] if number < len(delays) else 0.0, truth(packet))]

    wire = Transactions(Scripted(late))
    for address in (36, 30, 32, 43, 38):
        for servo in (1, 2):
            try:
                assert wire.read(servo, address, 2) == bytes([address, address + 1])
            except NoReplyError:
                continue


@given(st.binary(max_size=40), st.booleans())
def test_noise_is_never_a_reply(noise: bytes, before: bool) -> None:
    assume(HEADER + b"\x01\x04" not in noise)
    assume(HEADER + b"\x01\x02" not in noise)

    def noisy(_: int, packet: Packet) -> list[tuple[float, bytes]]:
        return [(0.001, noise + truth(packet) if before else noise)]

    wire = Transactions(Scripted(noisy))
    if before:
        assert wire.read(1, 36, 2) == bytes([36, 37])
    else:
        with pytest.raises(NoReplyError):
            wire.read(1, 36, 2)


def test_another_id_and_another_length_are_no_reply() -> None:
    def stale(_: int, packet: Packet) -> list[tuple[float, bytes]]:
        return [(0.0, Packet(2, 0, b"\x00\x02").encode() + Packet(1, 0, b"\x07").encode())]

    with pytest.raises(NoReplyError, match="FF FF 02 04 00 00 02 F7"):
        Transactions(Scripted(stale)).read(1, 36, 2)


def test_what_came_before_is_drained() -> None:
    line = Scripted(well)
    line._coming.append((0.0, Packet(1, 0, b"\x63\x63").encode()))
    assert Transactions(line).read(1, 36, 2) == bytes([36, 37])


@pytest.mark.parametrize("lost", [1, 2])
def test_reads_and_absolute_writes_are_repeated(lost: int) -> None:
    dropped = set(range(lost))

    def lossy(_: int, packet: Packet) -> list[tuple[float, bytes]]:
        if packet.parameters[:1] not in (b"\x24", b"\x1e") or not dropped:
            return [(0.001, truth(packet))]
        dropped.pop()
        return []

    wire = Transactions(Scripted(lossy))
    assert wire.read(1, 36, 2) == bytes([36, 37])
    dropped.update(range(lost))
    wire.write(1, 30, b"\x00\x02")


@pytest.mark.parametrize("bits", [16, 64])
def test_a_request_that_came_broken_is_repeated(bits: int) -> None:
    def broken(number: int, packet: Packet) -> list[tuple[float, bytes]]:
        return [(0.001, Packet(1, bits).encode() if number == 0 else truth(packet))]

    assert Transactions(Scripted(broken)).read(1, 36, 2) == bytes([36, 37])


def test_a_program_is_started_once() -> None:
    line = Scripted(lambda number, packet: [])
    with pytest.raises(NoReplyError, match="may have started"):
        Transactions(line).start(Packet(253, 10))
    assert len(line.sent) == 1


def test_a_program_is_not_started_on_a_line_that_lost_replies() -> None:
    line = Scripted(lambda number, packet: well(number, packet) if number == 0 else [])
    wire = Transactions(line)
    wire.read(1, 0, 3)
    with pytest.raises(NoReplyError):
        wire.write(1, 30, b"\x00\x02")
    with pytest.raises(NoReplyError, match="not sent"):
        wire.start(packets.Packet(1, packets.Instruction.ACTION))
    assert packets.Instruction.ACTION not in [packet.code for packet in line.sent]


def test_overload_is_told_and_nothing_is_rewritten() -> None:
    line = Scripted(lambda number, packet: [(0.0, Packet(1, 32, b"\x00\x02").encode())])
    with pytest.raises(ServoError, match="torque is already off") as fault:
        Transactions(line).read(1, 36, 2)
    assert fault.value.data == b"\x00\x02"
    assert len(line.sent) == 1


def test_an_echo_is_no_reply() -> None:
    line = Scripted(lambda number, packet: [(0.0, packet.encode())])
    with pytest.raises(NoReplyError, match="only the request itself came back"):
        Transactions(line).read(1, 36, 2)
    line = Scripted(lambda number, packet: [(0.0, packet.encode() + truth(packet))])
    assert Transactions(line).read(1, 36, 2) == bytes([36, 37])


def test_reading_an_endlessly_chattering_line_ends_at_the_deadline() -> None:
    class Chatter(Scripted):
        def read(self, most: int, deadline: float) -> bytes:
            self.clock.sleep(0.01)
            return b"\xff\xff\x01"

    with pytest.raises(NoReplyError):
        Transactions(Chatter(lambda number, packet: [])).read(1, 36, 2)


def test_the_eeprom_is_written_for_calibration_alone() -> None:
    line = Scripted(well)
    wire = Transactions(line)
    with pytest.raises(PumpError, match="EEPROM"):
        wire.write(1, 6, b"\x00\x00")
    assert line.sent == []
    wire.write_permanent(1, 6, bytes([6, 7]))
    assert len(line.sent) == 1  # was there already
    wire.write_permanent(1, 6, bytes([6, 8]))
    assert str(line.sent[-1]) == str(packets.write(1, 6, bytes([6, 8])))


def test_a_reply_that_was_not_waited_for_is_never_taken_for_another() -> None:
    def slow(_: int, packet: Packet) -> list[tuple[float, bytes]]:
        return [(0.05, truth(packet))]

    line = Scripted(slow)
    wire, read = Transactions(line), line.read

    def interrupted(most: int, deadline: float) -> bytes:
        raise KeyboardInterrupt

    line.read = interrupted  # type: ignore[method-assign]
    with pytest.raises(KeyboardInterrupt):
        wire.read(1, 30, 2)
    line.read = read  # type: ignore[method-assign]
    assert wire.read(1, 36, 2) == bytes([36, 37])
