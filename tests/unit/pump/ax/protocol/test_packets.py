"""Packets: the manual's examples, and packets found again between noise."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import BROADCAST, ErrorBits, Packet, Parser, meaning

PACKETS = st.builds(Packet, st.integers(0, BROADCAST), st.integers(0, 255), st.binary(max_size=40))

# What ROBOTIS' e-manual (protocol 1.0) and the ArbotiX firmwares' sources give as bytes.
EXAMPLES = [
    (packets.ping(1), "FF FF 01 02 01 FB"),
    (Packet(1, 0), "FF FF 01 02 00 FC"),
    (packets.write(1, 30, bytes([0, 2])), "FF FF 01 05 03 1E 00 02 D6"),
    (packets.write(1, 24, bytes([0])), "FF FF 01 04 03 18 00 DF"),
    (packets.read(1, 36, 8), "FF FF 01 04 02 24 08 CC"),
    (
        packets.sync_write(30, {1: bytes([0, 2, 100, 0]), 2: bytes([0, 2, 100, 0])}),
        "FF FF FE 0E 83 1E 04 01 00 02 64 00 02 00 02 64 00 7F",
    ),
    (packets.ping(253), "FF FF FD 02 01 FF"),
    (Packet(253, 0), "FF FF FD 02 00 00"),
    (Packet(253, 7, bytes([2])), "FF FF FD 03 07 02 F6"),
    (Packet(253, 8, bytes([0, 0x2C, 1, 0xBC, 2])), "FF FF FD 07 08 00 2C 01 BC 02 08"),
    (
        Packet(253, 9, bytes([0, 0xDD, 3, 1, 0xEE, 1, 255, 0, 0])),
        "FF FF FD 0B 09 00 DD 03 01 EE 01 FF 00 00 1F",
    ),
    (Packet(253, 10), "FF FF FD 02 0A F6"),
    (Packet(253, 11), "FF FF FD 02 0B F5"),
    (packets.write(253, 48, bytes([2])), "FF FF FD 04 03 30 02 C9"),
    (packets.read(253, 5, 1), "FF FF FD 04 02 05 01 F6"),
    (packets.read(253, 18, 1), "FF FF FD 04 02 12 01 E9"),
    (Packet(254, 0x84, bytes([36, 8, 1, 2])), "FF FF FE 06 84 24 08 01 02 48"),
]


@pytest.mark.parametrize(("packet", "given"), EXAMPLES)
def test_bytes_are_those_of_the_manuals(packet: Packet, given: str) -> None:
    assert str(packet) == given
    assert Parser().feed(bytes.fromhex(given)) == [packet]


@given(st.lists(PACKETS, max_size=5), st.lists(st.integers(1, 9)))
def test_packets_come_back_however_they_are_cut(sent: list[Packet], cuts: list[int]) -> None:
    data, parser, found = b"".join(p.encode() for p in sent), Parser(), []
    for cut in cuts:
        found += parser.feed(data[:cut])
        data = data[cut:]
    assert found + parser.feed(data) == sent


@given(PACKETS, st.binary(max_size=30))
def test_a_packet_behind_noise_is_found_at_last(packet: Packet, noise: bytes) -> None:
    parser = Parser()
    found = parser.feed(noise + packet.encode()) + parser.rest()
    assert packet in found or len(found) > 0


@given(PACKETS, st.data())
def test_a_broken_packet_is_none(packet: Packet, data: st.DataObject) -> None:
    good = packet.encode()
    place = data.draw(st.integers(0, len(good) - 1))
    bad = bytearray(good)
    bad[place] ^= data.draw(st.integers(1, 255))
    parser = Parser()
    assert packet not in parser.feed(bytes(bad)) + parser.rest()


def test_foreign_text_and_more_headers_are_skipped() -> None:
    packet = Packet(1, 0, b"\x00\x02")
    parser = Parser()
    assert parser.feed(b"New Pose:\r\n\xff" + packet.encode()) == [packet]
    assert parser.feed(b"Pose Reads:2 512 512 \r\n\xff\xff\xff") == []
    assert parser.feed(packet.encode()[2:]) == [packet]


def test_the_beginning_of_a_false_packet_hides_a_true_one_only_for_a_while() -> None:
    packet = Packet(1, 0, b"\x00\x02")
    parser = Parser()
    assert parser.feed(b"\xff\xff\x05\xf0" + packet.encode()) == []
    assert parser.rest() == [packet]
    assert Parser(most=8).feed(b"\xff\xff\x05\xf0" + packet.encode()) == [packet]


def test_error_bits_are_named() -> None:
    assert meaning(ErrorBits.OVERLOAD | ErrorBits.OVERHEAT) == (
        "too hot, overload: its torque is already off"
    )
    assert "protocol does not define" in meaning(128)


@pytest.mark.parametrize(("id", "code", "count"), [(255, 0, 0), (1, 256, 0), (1, 3, 254)])
def test_a_packet_that_cannot_be_is_refused(id: int, code: int, count: int) -> None:
    with pytest.raises(ValueError, match="packet"):
        Packet(id, code, bytes(count))
