"""The computed servo keeps the manual's rules."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.pumps import HOME, Weights, bench
from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, Instruction, Packet
from viscodesign.pump.ax.protocol.registers import COUNTS_PER_TURN, Register
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.motor import FRICTION, motor_output, motor_speed
from viscodesign.scene.pumps.servo_motor import SERVOS

STALL_PRESSURE = 1.8 / 0.0148 / (math.pi * 0.0349**2 / 4)
"""Gauge at which the servo's 1.8 N m just hold the plunger [Pa]."""


def ask(bench: SimulatedBench, packet: Packet, now: float = 0.0) -> Packet | None:
    answered = bench.answer(packet, now)
    return answered[0] if answered else None


def get(bench: SimulatedBench, register: Register, now: float, servo: int = 1) -> int:
    reply = ask(bench, packets.read(servo, register.address, register.size), now)
    assert reply is not None
    return register.decode(reply.parameters)


def set(bench: SimulatedBench, register: Register, value: int, now: float, servo: int = 1) -> int:
    data = register.encode(value)
    reply = ask(bench, packets.write(servo, register.address, data), now)
    assert reply is not None
    return reply.code


def at_pressure(gauge: float) -> SimulatedBench:
    return bench(1, plant=Weights(np.array([gauge])))


def test_it_goes_at_the_speed_of_its_register() -> None:
    pump = at_pressure(0.0)
    set(pump, registers.MOVING_SPEED, 100, 0.0)
    set(pump, registers.GOAL_POSITION, 900, 0.0)
    expected = 100 * 0.111 / 60 * COUNTS_PER_TURN  # 227 counts/s
    early, late = (
        get(pump, registers.PRESENT_POSITION, 0.5),
        get(pump, registers.PRESENT_POSITION, 1.5),
    )
    assert late - early == pytest.approx(expected, abs=1.5)
    assert get(pump, registers.PRESENT_SPEED, 1.6) == 100
    assert get(pump, registers.MOVING, 1.6) == 1
    assert get(pump, registers.PRESENT_POSITION, 5.0) == pytest.approx(900, abs=3)
    assert get(pump, registers.MOVING, 5.0) == 0


def test_speed_register_zero_is_full_speed() -> None:
    pump = at_pressure(0.0)
    set(pump, registers.GOAL_POSITION, 1000, 0.0)
    free = 983 / 1023 - FRICTION / 1.8
    assert get(pump, registers.PRESENT_POSITION, 0.2) == pytest.approx(
        HOME + 0.2 * free * 97 / 60 * COUNTS_PER_TURN, abs=1
    )


def test_a_goal_switches_the_torque_on() -> None:
    pump = at_pressure(0.0)
    assert get(pump, registers.TORQUE_ENABLE, 0.0) == 0
    set(pump, registers.GOAL_POSITION, 300, 0.0)
    assert get(pump, registers.TORQUE_ENABLE, 0.0) == 1


@pytest.mark.parametrize("share", [0.3, 0.8])
def test_it_slows_down_under_load_by_the_line_from_no_load_to_stall(share: float) -> None:
    pump = at_pressure(share * STALL_PRESSURE)
    set(pump, registers.GOAL_POSITION, 1000, 0.0)
    a, b = (get(pump, registers.PRESENT_POSITION, t) for t in (0.1, 0.4))
    expected = (983 / 1023 - share - FRICTION / 1.8) * 97 / 60 * COUNTS_PER_TURN
    assert (b - a) / 0.3 == pytest.approx(expected, rel=0.03)


def test_a_load_above_the_torque_limit_overloads_it_and_it_holds_nothing() -> None:
    pump = at_pressure(0.5 * STALL_PRESSURE)
    set(pump, registers.TORQUE_LIMIT, 300, 0.0)
    set(pump, registers.GOAL_POSITION, 400, 0.0)
    reply = ask(pump, packets.ping(1), 2.0)
    assert reply is not None
    assert reply.code == ErrorBits.OVERLOAD
    assert get(pump, registers.TORQUE_LIMIT, 2.0) == 0
    assert get(pump, registers.PRESENT_POSITION, 3.0) < HOME  # the pressure pushes it out
    assert set(pump, registers.TORQUE_LIMIT, 900, 3.0) == 0  # revived


def test_without_torque_friction_alone_holds() -> None:
    servo = SERVOS["ax18a"]
    assert motor_speed(servo, 0.0, 12.0, 0.9 * FRICTION) == 0.0
    assert motor_speed(servo, 0.0, 12.0, -2.0 * FRICTION) < 0.0


def test_output_is_the_inverse_of_speed() -> None:
    servo = SERVOS["ax12a"]
    for output in (0.9, -0.7):
        speed = motor_speed(servo, output, 11.1, 0.2)
        assert motor_output(servo, speed, 11.1, 0.2) == pytest.approx(output)


@pytest.mark.parametrize(
    ("register", "value", "bit"),
    [
        (registers.GOAL_POSITION, 1024, ErrorBits.RANGE),
        (registers.PRESENT_POSITION, 1, ErrorBits.RANGE),
        (registers.TORQUE_ENABLE, 2, ErrorBits.RANGE),
        (registers.GOAL_POSITION, 50, ErrorBits.ANGLE_LIMIT),
    ],
)
def test_what_it_refuses_changes_nothing(register: Register, value: int, bit: int) -> None:
    pump = at_pressure(0.0)
    set(pump, registers.CW_LIMIT, 100, 0.0)
    before = bytes(pump.servos[0].memory[:36])
    assert set(pump, register, value, 0.0) == bit
    assert bytes(pump.servos[0].memory[:36]) == before


def test_the_eeprom_outlives_the_power_and_the_rest_does_not() -> None:
    pump = at_pressure(0.0)
    set(pump, registers.CW_LIMIT, 100, 0.0)
    set(pump, registers.MOVING_SPEED, 50, 0.0)
    pump.supply(4.0)
    assert ask(pump, packets.ping(1)) is None
    pump.supply(12.0)
    assert get(pump, registers.CW_LIMIT, 0.1) == 100
    assert get(pump, registers.MOVING_SPEED, 0.1) == 0
    assert get(pump, registers.TORQUE_ENABLE, 0.1) == 0
    assert get(pump, registers.TORQUE_LIMIT, 0.1) == 983


def test_a_low_supply_is_reported_in_every_reply() -> None:
    pump = at_pressure(0.0)
    pump.supply(5.5)
    reply = ask(pump, packets.read(1, 42, 1))
    assert reply == Packet(1, ErrorBits.VOLTAGE, bytes([55]))


def test_heat_shuts_it_down() -> None:
    pump = at_pressure(0.0)
    pump.servos[0].temperature = 76.0
    pump.advance(0.0)
    pump.advance(0.1)
    assert ask(pump, packets.ping(1), 0.1) == Packet(1, ErrorBits.OVERHEAT)
    assert get(pump, registers.TORQUE_LIMIT, 0.1) == 0


@pytest.mark.parametrize(("level", "pings", "reads", "writes"), [(0, 1, 0, 0), (1, 1, 1, 0)])
def test_the_status_return_level(level: int, pings: int, reads: int, writes: int) -> None:
    pump = at_pressure(0.0)
    set(pump, registers.STATUS_LEVEL, level, 0.0)
    assert bool(ask(pump, packets.ping(1))) == pings
    assert bool(ask(pump, packets.read(1, 0, 2))) == reads
    assert bool(ask(pump, packets.write(1, 25, b"\1"))) == writes


def test_a_registered_write_waits_for_its_action() -> None:
    pump = at_pressure(0.0)
    todo = Packet(1, Instruction.REG_WRITE, bytes([30, 44, 1]))
    action = Packet(254, Instruction.ACTION)
    assert ask(pump, todo) == Packet(1, 0)
    assert get(pump, registers.REGISTERED, 0.0) == 1
    assert get(pump, registers.GOAL_POSITION, 0.0) == HOME
    assert ask(pump, action) is None
    assert get(pump, registers.GOAL_POSITION, 0.0) == 300
    assert ask(pump, Packet(1, Instruction.ACTION)) == Packet(1, ErrorBits.INSTRUCTION)


def test_sync_write_sets_each_servo_its_own() -> None:
    pump = bench(1, 2)
    ask(pump, packets.sync_write(30, {1: b"\x2c\x01\x64\x00", 2: b"\x90\x01\xc8\x00"}))
    assert get(pump, registers.GOAL_POSITION, 0.0, 1) == 300
    assert get(pump, registers.GOAL_POSITION, 0.0, 2) == 400
    assert get(pump, registers.MOVING_SPEED, 0.0, 2) == 200
    assert ask(pump, packets.ping(3)) is None


def test_factory_reset_makes_it_id_one() -> None:
    pump = bench(7)
    ask(pump, Packet(7, Instruction.RESET))
    assert ask(pump, packets.ping(1)) == Packet(1, 0)


def test_it_does_not_matter_when_it_is_asked() -> None:
    often, seldom = bench(1), bench(1)
    for pump in (often, seldom):
        set(pump, registers.GOAL_POSITION, 700, 0.0)
    for k in range(1, 1001):
        often.advance(k * 0.0013)
    seldom.advance(1.3)
    assert often.servos[0].position == seldom.servos[0].position
