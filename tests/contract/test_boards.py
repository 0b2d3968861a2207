"""What every board of the catalogue promises, against the device that it is for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pumps import HOME, Weights, bench, stepped
from tests.rig import faults
from tests.rig.bus import BusAdapter
from tests.rig.faults import Fault, Faulty
from viscodesign.errors import PumpError, ViscodesignError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, Packet
from viscodesign.pump.ax.protocol.registers import Register
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.kinds.servo import ServoKind
from viscodesign.pump.sessions.board_names import boards_of
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import Device, DirectLine
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Ros

DEVICES: dict[str, Callable[[SimulatedBench], Device]] = {
    "dynamixel": BusAdapter,
    "arbotix": PyPose,
    "arbotix-ros": Ros,
    "simulated": Ros,
}
BOARD_KINDS: dict[str, type[Board]] = boards_of(ServoKind())  # type: ignore[assignment]
BOARDS = sorted(BOARD_KINDS)
STREAMING = sorted(name for name, kind in BOARD_KINDS.items() if kind.streams)
WITH_PINS = sorted(name for name, kind in BOARD_KINDS.items() if kind.has_pins)

# Registers whose values are known, no two of a length alike.
TRUTH: list[tuple[Register, int]] = [
    (registers.MODEL, 18),
    (registers.PRESENT_POSITION, HOME),
    (registers.CCW_LIMIT, 1023),
    (registers.FIRMWARE, 24),
    (registers.PRESENT_VOLTAGE, 120),
    (registers.PRESENT_TEMPERATURE, 25),
    (registers.TORQUE_LIMIT, 983),
    (registers.PUNCH, 32),
]


def connected(name: str, pump: SimulatedBench, trouble: Sequence[Fault] = ()) -> Board:
    device = Faulty(DEVICES[name](pump), trouble)
    return BOARD_KINDS[name](DirectLine(device, stepped()), [1, 2])


def value(board: Board, servo: int, register: Register) -> int:
    """A register's value; raises where the servo reports an error."""
    return register.decode(board.read(servo, register.address, register.size))


def wait(board: Board, seconds: float) -> None:
    board.line.clock.sleep(seconds)
    board.line.drain()


@pytest.mark.parametrize("name", BOARDS)
def test_it_says_what_it_is(name: str) -> None:
    kind = BOARD_KINDS[name]
    assert kind.name == name
    assert kind.__doc__
    assert kind.baud in (38_400, 115_200, 1_000_000)
    told = connected(name, bench(1, 2)).identify()
    assert told
    assert ("simulated" in told) == kind.simulated


@pytest.mark.parametrize("name", BOARDS)
@pytest.mark.parametrize("other", ["dynamixel", "arbotix", "arbotix-ros"])
def test_it_knows_what_it_is_not(name: str, other: str) -> None:
    if DEVICES[name] is DEVICES[other]:
        return
    board = BOARD_KINDS[name](DirectLine(DEVICES[other](bench(1, 2)), stepped()), [1, 2])
    with pytest.raises(PumpError, match=other):
        board.identify()


@pytest.mark.parametrize("name", BOARDS)
def test_identifying_a_silent_line_says_what_to_check(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump, [faults.LostRequest(times=10**6)])
    with pytest.raises(PumpError, match="baud"):
        board.identify()


@pytest.mark.parametrize("name", BOARDS)
def test_it_reads_and_writes_and_changes_nothing_else(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump)
    board.identify()
    for register, true in TRUTH:
        assert value(board, 1, register) == true
    before = bytes(pump.servos[0].memory)
    board.set(1, registers.TORQUE_LIMIT, 500)
    board.set(2, registers.LED, 1)
    assert value(board, 1, registers.TORQUE_LIMIT) == 500
    assert value(board, 2, registers.LED) == 1
    wait(board, 0.1)
    after = bytes(pump.servos[0].memory)
    assert {i for i in range(registers.TABLE_END) if before[i] != after[i]} == {34, 35}
    assert [servo.position for servo in pump.servos] == [HOME, HOME]


@pytest.mark.parametrize("name", BOARDS)
def test_it_moves_all_servos(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump)
    board.move({1: Goal(260, 100), 2: Goal(240, 50)})
    wait(board, 0.3)
    assert [servo.get(registers.MOVING_SPEED) for servo in pump.servos] == [100, 50]
    wait(board, 2.0)
    assert value(board, 1, registers.PRESENT_POSITION) == pytest.approx(260, abs=5)
    assert value(board, 2, registers.PRESENT_POSITION) == pytest.approx(240, abs=5)
    board.halt()


@pytest.mark.parametrize("name", BOARDS)
def test_the_eeprom_is_written_for_calibration_alone(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump)
    before = bytes(pump.servos[0].memory[: registers.RAM])
    with pytest.raises(PumpError, match="calibrate"):
        board.write(1, registers.CW_LIMIT.address, b"\x64\x00")
    assert bytes(pump.servos[0].memory[: registers.RAM]) == before
    board.write_permanent(1, registers.CW_LIMIT.address, b"\x64\x00")
    assert pump.servos[0].get(registers.CW_LIMIT) == 100


@pytest.mark.parametrize(("count", "speed"), [(-1, 10), (1024, 10), (500, 0), (500, 1024)])
def test_goals_that_cannot_be_are_refused(count: int, speed: int) -> None:
    with pytest.raises(PumpError):
        Goal(count, speed)


@pytest.mark.parametrize("name", BOARDS)
def test_a_missing_servo_is_reported(name: str) -> None:
    board = connected(name, bench(1, 2))
    for action in (
        lambda: value(board, 9, registers.PRESENT_POSITION),
        lambda: board.set(9, registers.LED, 1),
    ):
        with pytest.raises(PumpError, match="9"):
            action()


@pytest.mark.parametrize("name", BOARDS)
def test_an_overload_is_told_and_stays(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump)
    pump.servos[0].alarm(ErrorBits.OVERLOAD)
    with pytest.raises(PumpError, match="torque is already off"):
        value(board, 1, registers.PRESENT_POSITION)
    assert pump.servos[0].get(registers.TORQUE_LIMIT) == 0
    assert value(board, 2, registers.PRESENT_POSITION) == HOME


@pytest.mark.parametrize("name", BOARDS)
def test_a_brown_out_is_told(name: str) -> None:
    pump = bench(1, 2)
    board = connected(name, pump)
    pump.supply(5.5)
    with pytest.raises(PumpError, match="voltage"):
        value(board, 1, registers.PRESENT_POSITION)
    pump.supply(4.0)
    with pytest.raises(PumpError, match="did not answer"):
        value(board, 1, registers.PRESENT_POSITION)
    pump.supply(12.0)
    assert value(board, 1, registers.PRESENT_POSITION) == HOME


# -- pins -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", BOARDS)
def test_pins_are_read_or_none(name: str) -> None:
    pump = bench(1, limit_switches={"low": "D1", "high": "D2"})
    board = connected(name, pump)
    read = board.analog(0), board.digital("D1")
    if not BOARD_KINDS[name].has_pins:
        assert read == (None, None)
        return
    assert read[0] == pytest.approx((101.325 - 3.478) * 0.002421, abs=1 / 256)
    assert read[1] is False
    pump.servos[0].position = 80
    assert board.digital("D1") is True
    assert board.digital("D2") is False


@pytest.mark.parametrize("name", WITH_PINS)
def test_each_plunger_has_its_own_sensor_and_switches(name: str) -> None:
    pump = bench(
        1,
        2,
        plant=Weights(np.array([0.0, 20e3])),
        sensor={"a": {"channel": 2}, "b": {"channel": 5}},
        limit_switches={"a": {"low": "D1", "high": "D2"}, "b": {"low": "D3", "high": "D4"}},
    )
    board = connected(name, pump)
    assert not any(board.digital(f"D{k}") for k in range(1, 5))
    pump.servos[1].position = 80
    assert [board.digital(f"D{k}") for k in range(1, 5)] == [False, False, True, False]
    first, second, nothing = (board.analog(channel) for channel in (2, 5, 0))
    assert (first, second) == (
        pytest.approx((101.325 - 3.478) * 0.002421, abs=1 / 256),
        pytest.approx((121.325 - 3.478) * 0.002421, abs=1 / 256),
    )
    assert nothing == pytest.approx(0.0, abs=1 / 256)


@pytest.mark.parametrize("name", WITH_PINS)
def test_a_board_that_was_reset_reports_a_broken_wire_again(name: str) -> None:
    pump = bench(1, limit_switches={"low": "D1", "high": "D2"})
    device = Ros(pump)
    board = BOARD_KINDS[name](DirectLine(device, stepped()), [1])
    assert board.digital("D1") is False
    device.reset(board.line.clock.now())
    wait(board, 1.0)
    pump.servos[0].position = 80
    assert board.digital("D1") is True


@pytest.mark.parametrize("name", WITH_PINS)
@pytest.mark.parametrize("pin", ["D0", "D8", "D11", "D32", "A0", "1", ""])
def test_pins_that_are_none_are_refused(name: str, pin: str) -> None:
    board = connected(name, bench(1))
    with pytest.raises(ViscodesignError, match="cannot take a switch"):
        board.digital(pin)
    with pytest.raises(ViscodesignError, match="channel"):
        board.analog(8)


# -- faults -----------------------------------------------------------------------------------


def session(board: Board) -> list[str]:
    """Reads and writes of all kinds: each is right, or an error of the pump. The errors."""
    told: list[str] = []

    def attempt(action: Callable[[], Any], right: Any) -> None:
        try:
            got = action()
        except PumpError as error:
            told.append(str(error))
        else:
            assert got == right

    for servo in (1, 2):
        for register, true in TRUTH:
            attempt(lambda s=servo, r=register: value(board, s, r), true)
    attempt(lambda: board.set(1, registers.TORQUE_LIMIT, 500), None)
    if not told:
        attempt(lambda: value(board, 1, registers.TORQUE_LIMIT), 500)
    attempt(lambda: value(board, 2, registers.TORQUE_LIMIT), 983)
    attempt(lambda: board.read(2, 36, 8)[:2], HOME.to_bytes(2, "little"))
    return told


REQUESTS = st.integers(0, 24)
STALE = Packet(2, 0, b"\x63\x03").encode()
FAULTS = st.one_of(
    st.builds(faults.LostRequest, REQUESTS, times=st.integers(1, 4)),
    st.builds(faults.LostReply, REQUESTS, times=st.integers(1, 4)),
    st.builds(faults.LateReply, REQUESTS, times=st.integers(1, 3), delay=st.floats(0.05, 2.0)),
    st.builds(faults.CorruptRequest, REQUESTS, times=st.integers(1, 3), bit=st.integers(0, 90)),
    st.builds(faults.CorruptReply, REQUESTS, times=st.integers(1, 3), bit=st.integers(0, 90)),
    st.builds(
        faults.ForeignBytes,
        REQUESTS,
        times=st.integers(1, 3),
        data=st.sampled_from(
            [b"New Pose:\r\n", b"\xff\xff\xff", b"\xff\xff\x01\x04\x00", b"\0\xff"]
        )
        | st.binary(max_size=12),
    ),
)


@pytest.mark.parametrize("name", BOARDS)
@given(st.lists(FAULTS, min_size=1, max_size=3))
@settings(max_examples=150, deadline=None)
def test_no_fault_makes_it_take_a_wrong_value(name: str, trouble: list[Fault]) -> None:
    session(connected(name, bench(1, 2), trouble))


@pytest.mark.parametrize("name", BOARDS)
def test_without_faults_nothing_is_told(name: str) -> None:
    assert session(connected(name, bench(1, 2))) == []


@pytest.mark.parametrize("name", BOARDS)
@pytest.mark.parametrize("kind", [faults.LostRequest, faults.LostReply, faults.CorruptReply])
def test_one_lost_packet_is_mended(name: str, kind: type[Fault]) -> None:
    for request in range(20):
        assert session(connected(name, bench(1, 2), [kind(request)])) == [], request


@pytest.mark.parametrize("name", BOARDS)
def test_a_pulled_cable_is_told_from_then_on(name: str) -> None:
    for request in range(18):
        told = session(connected(name, bench(1, 2), [faults.Unplugged(request)]))
        assert len(told) >= 2
        assert all("cable was pulled" in words for words in told)


@pytest.mark.parametrize("name", STREAMING)
def test_a_move_that_was_lost_shows_in_the_positions(name: str) -> None:
    pump = bench(1)
    board = connected(name, pump, [faults.LostRequest()])
    board.move({1: Goal(300, 100)})
    wait(board, 1.0)
    assert value(board, 1, registers.PRESENT_POSITION) == HOME
