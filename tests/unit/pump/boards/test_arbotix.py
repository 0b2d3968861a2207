"""What the board with PyPose is asked, never asked, and taken for; besides every board's contract."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pose_rig import PoseRig, swing
from tests.pumps import bench, stepped
from tests.rig import faults
from tests.rig.faults import Faulty
from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import Instruction, Parser
from viscodesign.pump.boards.arbotix import LONGEST_READ, Arbotix
from viscodesign.pump.poses import engine
from viscodesign.pump.poses.engine import MAX_MOVES, Move, PoseSequence
from viscodesign.pump.simulated.device import Device, DirectLine
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Ros


class Heard(Device):
    """Keeps what reaches the device."""

    def __init__(self, device: Device) -> None:
        self.device = device
        self.bytes = bytearray()

    def feed(self, data: bytes, now: float) -> None:
        self.bytes += data
        self.device.feed(data, now)

    def take(self, now: float) -> bytes:
        return self.device.take(now)

    def due(self) -> float:
        return self.device.due()


def board(device: Device) -> Arbotix:
    return Arbotix(DirectLine(device, stepped()), [1])


def test_the_ros_firmware_is_told_from_this_one() -> None:
    with pytest.raises(
        PumpError, match="runs the ROS firmware, not PyPose's; use the board arbotix"
    ):
        board(Ros(bench(1))).identify()


def test_silence_may_be_a_board_that_plays() -> None:
    with pytest.raises(PumpError, match="may also be playing poses, which `pump stop --board"):
        board(Faulty(PyPose(bench(1)), [faults.LostRequest(times=10**6)])).identify()


@given(st.integers(LONGEST_READ + 1, 50))
def test_reads_that_overwrite_the_sequence_are_never_sent(count: int) -> None:
    device = Heard(PyPose(bench(1)))
    with pytest.raises(PumpError, match="the PyPose firmware reads 26"):
        board(device).read(1, 0, count)
    assert not device.bytes


@pytest.mark.parametrize("data", [b"", b"\x01\x02\x03"])
def test_writes_that_it_would_cut_off_are_never_sent(data: bytes) -> None:
    device = Heard(PyPose(bench(1)))
    with pytest.raises(PumpError, match="writes one or two"):
        board(device).write(1, registers.LED.address, data)
    assert not device.bytes


def test_a_write_to_a_servo_that_is_not_there_is_not_believed() -> None:
    # The firmware acknowledges it.
    with pytest.raises(PumpError, match="id 9 did not answer"):
        board(PyPose(bench(1))).write(9, registers.LED.address, b"\x01")


def test_a_write_that_does_not_stick_is_told() -> None:
    pump = bench(1)
    pump.servos[0].memory = Stubborn(pump.servos[0].memory)
    with pytest.raises(PumpError, match="was set to 01, but reads 00"):
        board(PyPose(pump)).write(1, registers.LED.address, b"\x01")


class Stubborn(bytearray):
    """Memory that keeps what it has."""

    def __setitem__(self, place: object, value: object) -> None:
        return None


@pytest.mark.parametrize("loop", [False, True])
def test_only_harmless_instructions_are_sent(loop: bool) -> None:
    rig = PoseRig((1, 2), loop=loop)
    rig.stop_at = 1.5 * rig.fit.duration
    heard = Heard(rig.line.device)
    rig.line.device = heard
    rig.pump.connect()
    rig.player.load()
    rig.player.approach(_start(rig))
    rig.player.play()
    sent = Parser().feed(bytes(heard.bytes))
    own = {packet.code for packet in sent if packet.id == engine.ARBOTIX}
    others = {packet.code for packet in sent if packet.id != engine.ARBOTIX}
    start = engine.PoseInstruction.LOOP if loop else engine.PoseInstruction.PLAY
    assert own == {Instruction.PING, Instruction.READ, 7, 8, 9, start}
    assert others == {Instruction.READ, Instruction.WRITE}
    assert sum(packet.code == start for packet in sent) == 1
    assert all(packet.parameters[0] < 30 for packet in sent if packet.code == 8)
    assert all(len(packet.parameters) <= 141 for packet in sent)
    # Nothing is between the start and the halt, or the end.
    behind = bytes(heard.bytes).partition(engine.LOOP.encode())[2]
    assert behind.startswith(b"HHH") is loop


def _start(rig: PoseRig) -> object:
    from viscodesign.pump.poses.player import split_at

    return split_at(rig.wanted, 0.0)[0]


def test_packets_are_those_of_the_firmwares_own_host() -> None:
    # The examples of the hardware notes: sent to the original firmware's image.
    assert str(engine.size_pose(2)) == "FF FF FD 03 07 02 F6"
    assert str(engine.load_pose(0, (300, 700))) == "FF FF FD 07 08 00 2C 01 BC 02 08"
    moves = [Move(0, 989), Move(1, 494)]
    assert str(engine.load_sequence(moves)) == "FF FF FD 0B 09 00 DD 03 01 EE 01 FF 00 00 1F"
    assert str(engine.PLAY) == "FF FF FD 02 0A F6"
    assert str(engine.LOOP) == "FF FF FD 02 0B F5"


def test_what_would_hang_the_board_is_refused() -> None:
    with pytest.raises(PumpError, match="47 moves; the board takes 1 to 46"):
        engine.load_sequence([Move(0, 32)] * (MAX_MOVES + 1))
    with pytest.raises(PumpError, match="0 moves"):
        engine.load_sequence([])
    with pytest.raises(PumpError, match="pose 30"):
        engine.load_pose(30, (1, 2))
    with pytest.raises(PumpError, match="32768 ms"):
        engine.load_sequence([Move(0, 32768)])
    assert len(engine.load_sequence([Move(0, 32)] * MAX_MOVES).encode()) == 147


@given(st.lists(st.tuples(st.integers(0, 29), st.integers(0, 32767)), min_size=1, max_size=46))
@settings(deadline=None, max_examples=30)
def test_the_board_holds_what_it_was_given(entries: list[tuple[int, int]]) -> None:
    device = PyPose(bench(1))
    poses = tuple((10 * k, 1000 * (k % 2)) for k in range(30))
    sequence = PoseSequence(poses, tuple(Move(pose, ms) for pose, ms in entries))
    speaker = board(device)
    size, *rest = engine.loading(sequence)
    speaker.size_pose(size)
    for packet in rest:
        speaker.tell(packet)
    speaker.line.clock.sleep(0.1)
    speaker.hello()
    assert [tuple(row[:2]) for row in device.engine.poses] == list(poses)
    assert device.engine.sequence[: len(entries) + 1] == [*entries, (255, 0)]


@pytest.mark.parametrize("kind", [faults.LostRequest, faults.CorruptRequest, faults.LostReply])
def test_loading_mends_one_fault_anywhere(kind: type[faults.Fault]) -> None:
    for request in range(1, 12):
        rig = PoseRig(profile=swing(duration=0.5, amplitude=8.0))
        rig.pump.connect()
        before = rig.line.device.requests  # type: ignore[attr-defined]
        rig.line.device.faults.append(kind(before + request))  # type: ignore[attr-defined]
        rig.player.load()
        rig.clock.sleep(0.5)
        rig.board.hello()
        sequence = rig.fit.sequence
        held = [tuple(row[:2]) for row in rig.device.engine.poses[: len(sequence.poses)]]
        assert held == list(sequence.poses)
        entries = [(move.pose, move.ms) for move in sequence.moves]
        assert rig.device.engine.sequence[: len(entries)] == entries
