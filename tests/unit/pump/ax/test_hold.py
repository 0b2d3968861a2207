"""`stop` with nothing known but the board: on every board, whatever it is doing."""

from __future__ import annotations

import pytest

from tests.pumps import bench, stepped
from tests.rig.bus import BusAdapter
from viscodesign.pump.ax.hold import stop_all
from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.sessions.board_names import boards
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.pypose import LOAD_POSE, LOAD_SEQ, LOOP, SIZE_POSE, PyPose
from viscodesign.pump.simulated.ros import Ros

DEVICES = {"dynamixel": BusAdapter, "arbotix-ros": Ros, "arbotix": PyPose}


def moving(pump: SimulatedBench) -> None:
    """Servo 1 on its way to 900 at 45 counts/s; servo 2 without torque."""
    servo = pump.servos[0]
    servo.set(registers.MOVING_SPEED, 20)
    servo.set(registers.GOAL_POSITION, 900)
    servo.set(registers.TORQUE_ENABLE, 1)


@pytest.mark.parametrize("name", DEVICES)
@pytest.mark.parametrize("release", [False, True])
def test_what_moves_stands(name: str, release: bool) -> None:
    pump, clock = bench(1, 2), stepped()
    board = boards()[name](DirectLine(DEVICES[name](pump), clock))
    board.line.drain()  # a computed device begins when it is first spoken to
    moving(pump)
    clock.sleep(2.0)
    board.line.drain()
    left = {one.axis: one for one in stop_all(board, range(1, 5), clock, release=release)}
    assert set(left) == {1, 2}
    assert all(one.verified for one in left.values())
    before = pump.servos[0].position
    assert 250 < before < 350
    clock.sleep(3.0)
    board.line.drain()
    assert pump.servos[0].position == pytest.approx(before, abs=3)
    assert not pump.servos[1].get(registers.TORQUE_ENABLE)
    assert pump.servos[0].get(registers.TORQUE_ENABLE) == (0 if release else 1)


def test_a_loop_of_poses_ends_when_its_move_is_over() -> None:
    pump, clock = bench(1, 2), stepped()
    board = Arbotix(DirectLine(PyPose(pump), clock), [1, 2])
    board.write(1, registers.TORQUE_ENABLE.address, b"\x01")

    def tell(code: int, data: bytes = b"") -> None:
        board.line.write(packets.Packet(253, code, data).encode())
        clock.sleep(0.5)
        board.line.drain()

    def pose(*counts: int) -> bytes:
        return b"".join(count.to_bytes(2, "little") for count in counts)

    tell(SIZE_POSE, b"\x02")
    tell(LOAD_POSE, b"\x00" + pose(200, 200))
    tell(LOAD_POSE, b"\x01" + pose(300, 300))
    long = (8000).to_bytes(2, "little")
    tell(LOAD_SEQ, b"\x00" + long + b"\x01" + long + b"\xff\x00\x00")
    tell(LOOP)
    clock.sleep(12.0)
    board.line.drain()
    began = clock.now()
    left = stop_all(board, [1, 2], clock)
    assert [one.axis for one in left] == [1, 2]
    assert all(one.verified for one in left)
    assert clock.now() - began < 40.0
    before = [servo.position for servo in pump.servos]
    clock.sleep(20.0)
    board.line.drain()
    assert [servo.position for servo in pump.servos] == pytest.approx(before, abs=3)


def test_nobody_there_is_told_as_nobody() -> None:
    pump, clock = bench(9), stepped()
    board = boards()["dynamixel"](DirectLine(BusAdapter(pump), clock))
    assert stop_all(board, [1, 2], clock) == []


def test_a_deaf_board_is_halted_again_until_its_longest_move_is_over() -> None:
    pump, clock = bench(1), stepped()
    pump.supply(0.0)
    board = Arbotix(DirectLine(PyPose(pump), clock))
    began = clock.now()
    assert stop_all(board, [1], clock) == []
    assert 40.0 <= clock.now() - began < 60.0
