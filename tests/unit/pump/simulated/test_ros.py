"""The firmware for ROS: its own registers, and what it lets through."""

from __future__ import annotations

import pytest

from tests.pumps import HOME, bench
from tests.rig.full import FullRos
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import Packet, Parser
from viscodesign.pump.simulated.bench import STEP


class Host:
    def __init__(self, *ids: int, **settings: object) -> None:
        self.board = FullRos(bench(*(ids or (1,)), **settings))
        self.now = 0.0

    def send(self, packet: Packet, wait: float = 0.2) -> Packet | None:
        self.board.feed(packet.encode(), self.now)
        self.now += wait
        return next(iter(Parser().feed(self.board.take(self.now))), None)


def test_it_is_model_300() -> None:
    assert Host().send(packets.read(253, 0, 5)) == Packet(253, 0, bytes([44, 1, 0, 253, 34]))


def test_ambient_pressure_is_60_of_256() -> None:
    assert Host().send(packets.read(253, 18, 1)) == Packet(253, 0, bytes([60]))


def test_a_closed_switch_is_low_and_a_broken_wire_is_high() -> None:
    host = Host(limit_switches={"low": "D1", "high": "D2"}, travel=(100, 1000))
    read, pull_up = packets.read(253, 5, 1), packets.write(253, 48, b"\x02")
    assert host.send(read) == Packet(253, 0, b"\x00")
    assert host.send(pull_up) == Packet(253, 0)
    assert host.send(read) == Packet(253, 0, b"\x00")
    host.board.bench.servos[0].position = 80
    assert host.send(read) == Packet(253, 0, b"\x02")
    host.board.reset(host.now)  # forgets the pull-up
    assert host.send(read) == Packet(253, 0, b"\x00")


@pytest.mark.parametrize("address", [0, 5, 18, 100])
def test_it_refuses_to_write_what_is_only_read(address: int) -> None:
    assert Host().send(packets.write(253, address, b"\x01")) == Packet(253, 64)


def test_sync_write_passes_and_the_byte_behind_it_does_no_harm() -> None:
    host = Host(1, 2)
    assert host.send(packets.sync_write(30, {1: b"\x2c\x01", 2: b"\x90\x01"})) is None
    assert host.send(packets.read(1, 30, 2)) == Packet(1, 0, b"\x2c\x01")
    assert host.send(packets.sync_write(30, {1: b"\x2d\x01", 2: b"\x91\x01"})) is None
    assert host.send(packets.read(2, 30, 2)) == Packet(2, 0, b"\x91\x01")


def test_sync_read_answers_with_the_broadcast_id() -> None:
    position = HOME.to_bytes(2, "little")
    request = Packet(254, 0x84, bytes([36, 2, 1, 9]))
    assert Host().send(request) == Packet(254, 0, position + b"\xff\xff")


def test_ping_is_unanswered_and_a_wrong_checksum_is_16() -> None:
    host = Host()
    assert host.send(packets.ping(253)) is None
    host.board.feed(packets.ping(253).encode()[:-1] + b"\x00", host.now)
    assert host.board.take(host.now + 1.0) == Packet(253, 16).encode()


def test_its_loop_plays_once_and_a_halt_starts_it_again() -> None:
    host = Host()
    host.send(Packet(253, 7, b"\x01"))
    host.send(Packet(253, 8, bytes([0, 44, 1])))
    host.send(Packet(253, 9, bytes([0, 0xDD, 3, 0, 0xDD, 3, 255, 0, 0])))
    host.send(Packet(253, 11), 5.0)
    frames = host.board.engine.frames
    assert frames > 20
    assert host.send(packets.read(253, 0, 2)) is not None  # it has come to its end
    host.send(Packet(253, 8, bytes([0, 144, 1])))
    host.send(Packet(253, 11), 0.1)
    host.board.feed(b"H", host.now)
    host.now += 10.0
    host.board.take(host.now)
    assert host.board.engine.frames > frames + 30


def test_time_begins_when_it_is_first_spoken_to() -> None:
    host = Host()
    host.now = 1e6
    assert host.send(packets.read(253, 0, 2)) is not None
    assert host.board.bench._steps == pytest.approx(0.2 / STEP, abs=1)
