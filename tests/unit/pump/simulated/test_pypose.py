"""PyPose's firmware keeps its timing law and its traps.

Figures marked "image" were measured on the original firmware's image in an AVR emulator.
"""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pumps import HOME, bench
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.ax.protocol.packets import Packet, Parser
from viscodesign.pump.simulated.pypose import FIRMWARE_FRAME, PyPose

HELLO = packets.ping(253)
PLAY = Packet(253, 10)
LOOP = Packet(253, 11)


class Host:
    """Sends, and sees what comes until it is quiet."""

    def __init__(self, *ids: int) -> None:
        self.board = PyPose(bench(*(ids or (1,))))
        self.now = 0.0

    def send(self, data: Packet | bytes, wait: float = 0.2) -> bytes:
        self.board.feed(data if isinstance(data, bytes) else data.encode(), self.now)
        self.now += wait
        return self.board.take(self.now)

    def load(self, poses: list[list[int]], entries: list[tuple[int, int]]) -> None:
        self.send(Packet(253, 7, bytes([len(poses[0])])), 1.0)
        for index, pose in enumerate(poses):
            words = b"".join(count.to_bytes(2, "little") for count in pose)
            self.send(Packet(253, 8, bytes([index]) + words))
        each = [bytes([pose]) + ms.to_bytes(2, "little") for pose, ms in [*entries, (255, 0)]]
        self.send(Packet(253, 9, b"".join(each)))

    @property
    def busy(self) -> bool:
        """Whether it does not answer at once."""
        return self.send(HELLO) == b""

    def frames(self, wait: float) -> int:
        before = self.board.engine.frames
        self.send(PLAY, wait)
        return self.board.engine.frames - before


@given(st.integers(0, 1023), st.integers(0, 32767))
@settings(max_examples=40, deadline=None)
def test_the_law_of_its_time(target: int, ms: int) -> None:
    host = Host()
    host.load([[target]], [(0, ms)])
    distance = 8 * abs(target - HOME)
    step = distance // (ms // 33 + 1) + 1
    frames = distance // step + 1 if distance else 1
    assert host.frames(frames * FIRMWARE_FRAME + 0.1) == frames
    assert host.board.engine.pose[0] == 8 * target


@pytest.mark.parametrize(
    ("counts", "ms", "seconds"),
    [(10, 5000, 2.7), (0, 5000, 0.033)],  # image
)
def test_it_cannot_wait(counts: int, ms: int, seconds: float) -> None:
    host = Host()
    host.load([[HOME + counts]], [(0, ms)])
    assert host.frames(6.0) * FIRMWARE_FRAME == pytest.approx(seconds, rel=0.02)


@pytest.mark.parametrize("frames", [30, 50])  # image
def test_a_servo_that_is_not_there_makes_it_wait(frames: int) -> None:
    host = Host(1, 2)
    host.load(
        [[HOME, HOME, 0], [HOME + 10, HOME, 1000], [HOME + 10, HOME, 0]],
        [(0, 32), (1, 33 * frames - 1), (2, 33 * frames - 1)],
    )
    host.frames(0.2)
    assert host.frames(2 * (frames + 4) * FIRMWARE_FRAME) >= 2 * frames


@pytest.mark.parametrize(("entries", "alive"), [(46, True), (47, False)])  # image; and the end
def test_a_longer_sequence_wedges_it(entries: int, alive: bool) -> None:
    host = Host()
    host.load([[HOME]], [(0, 32)] * entries)
    assert host.busy != alive
    host.board.reset(host.now)
    assert not host.busy


@pytest.mark.parametrize("length", [0, 1, 145])
def test_impossible_lengths_wedge_it(length: int) -> None:
    host = Host()
    host.send(bytes([0xFF, 0xFF, 253, length, 1]) + bytes(200), 1.0)
    assert host.busy


def test_it_acknowledges_before_it_does_and_is_deaf_meanwhile() -> None:
    host = Host()
    assert host.send(Packet(253, 7, bytes([3])), 0.01) == Packet(253, 0).encode()
    assert host.send(HELLO, 0.03) == b""  # 26 ms for each servo
    host.now += 0.05
    assert host.board.take(host.now) == Packet(253, 0).encode()


def test_it_acknowledges_any_packet_and_writes_to_missing_servos() -> None:
    host = Host()
    assert host.send(Packet(253, 99)) == Packet(253, 0).encode()
    assert host.send(packets.write(77, 30, b"\x00\x02")) == Packet(77, 0).encode()


@pytest.mark.parametrize(
    "dropped",
    [packets.ping(1), Packet(1, 4, b"\x1e\x00\x02"), packets.sync_write(30, {1: b"\x00\x02"})],
)
def test_it_passes_reads_and_writes_alone(dropped: Packet) -> None:
    host = Host()
    assert host.send(dropped) == b""
    assert host.send(packets.read(1, 30, 2)) == Packet(1, 0, HOME.to_bytes(2, "little")).encode()


def test_longer_writes_are_cut_to_two_bytes() -> None:
    host = Host()
    assert host.send(packets.write(1, 30, b"\x2c\x01\x64\x00")) == Packet(1, 0).encode()
    assert host.send(packets.read(1, 30, 4)) == Packet(1, 0, b"\x2c\x01\x00\x00").encode()


def test_after_reading_the_pose_a_missing_servo_seems_to_answer() -> None:
    host = Host()
    assert host.send(packets.read(9, 36, 2)) == b""
    host.send(Packet(253, 7, bytes([1])), 0.5)
    (stale,) = Parser().feed(host.send(packets.read(9, 36, 2)))
    assert (stale.id, len(stale.parameters)) == (1, 2)
    assert host.send(packets.read(9, 36, 2)) == b""


def test_a_loaded_pose_prints_text() -> None:
    host = Host()
    host.send(Packet(253, 7, bytes([1])), 0.5)
    heard = host.send(Packet(253, 8, bytes([0, 44, 1])))
    assert heard == Packet(253, 0).encode() + b"New Pose:\r\n"


def test_a_wrong_checksum_and_a_packet_with_a_hole() -> None:
    host = Host()
    broken = HELLO.encode()[:-1] + b"\x12"
    assert host.send(broken) == Packet(253, 64).encode()
    host.send(packets.write(1, 30, b"\x00\x02").encode()[:5])
    assert host.send(HELLO) != Packet(253, 0).encode()  # its start was swallowed
    assert not host.busy


def test_halt_is_seen_between_moves_and_other_bytes_are_eaten() -> None:
    host = Host()
    host.load([[HOME + 100], [HOME]], [(0, 990), (1, 990)])
    host.send(LOOP, 0.1)
    host.send(HELLO, 0.1)
    host.send(b"HHH", 0.2)
    assert host.busy  # the bytes of the hello come first, one for each move
    host.now += 20.0
    assert not host.busy


def test_further_halts_are_harmless() -> None:
    host = Host()
    assert host.send(b"HHH") == b""
    assert not host.busy


def test_a_loop_of_nothing_hangs_for_ever() -> None:
    host = Host()
    host.send(Packet(253, 9, bytes([255, 0, 0])))
    host.send(LOOP)
    host.send(b"HHHH", 60.0)
    assert host.busy


def test_playing_before_loading_drives_to_zero() -> None:
    host = Host()
    host.send(Packet(253, 7, bytes([1])), 0.5)
    host.send(PLAY, 3.0)
    assert host.board.bench.servos[0].position < 20
    assert host.busy


def test_times_are_signed() -> None:
    host = Host()
    host.load([[HOME + 10]], [(0, 40_000)])
    assert host.frames(10.0) == 81  # an eighth of a count each frame


def test_an_unreadable_servo_is_taken_to_be_at_minus_one() -> None:
    host = Host()
    host.load([[HOME, 500]], [(0, 32)])
    assert host.board.engine.pose[1] == -8


def test_many_bytes_while_it_is_busy_are_lost() -> None:
    host = Host()
    host.send(Packet(253, 7, bytes([3])), 0.0)
    heard = host.send(HELLO.encode() * 20, 0.5)
    assert len(Parser().feed(heard)) < 15


def test_a_reset_forgets_and_takes_its_time() -> None:
    host = Host()
    host.load([[HOME]], [(0, 32)])
    host.board.reset(host.now, boot=2.0)
    assert host.busy
    host.now += 2.0
    assert not host.busy
    assert host.board.engine.size == 0


def test_nothing_is_due_while_nobody_speaks() -> None:
    board = Host().board
    assert board.take(0.0) == b""
    assert board.due() == math.inf
