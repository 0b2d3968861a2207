"""What a pump refuses, before a byte of it is sent."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.pump_rig import TRAVEL, Rig
from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.servo_pump import SLOWEST_SPEED, speed_register
from viscodesign.pump.ax.torque_limit import free_speed, stalling_pressure, torque_limit
from viscodesign.pump.boards.base import Goal
from viscodesign.pump.play.guard import Stop
from viscodesign.scene.pumps.servo import ServoPumpSpec as Settings


def servo_of(rig: Rig):  # type: ignore[no-untyped-def]
    return rig.bench.servos[0]


@pytest.mark.parametrize(
    ("trouble", "told"),
    [
        (lambda rig: rig.bench.supply(9.9), "charge the battery"),
        (lambda rig: rig.bench.supply(5.9), "supply voltage"),
        (lambda rig: servo_of(rig).alarm(ErrorBits.OVERLOAD), "overload"),
        (lambda rig: setattr(servo_of(rig), "temperature", 72.0), "let it cool down"),
        (lambda rig: servo_of(rig).set(registers.CW_LIMIT, 0), "not calibrated"),
        (lambda rig: servo_of(rig).set(registers.CCW_LIMIT, 1023), "not calibrated"),
        (lambda rig: servo_of(rig).set(registers.MODEL, 12), "correct pump.servo"),
        (lambda rig: servo_of(rig).set(registers.STATUS_LEVEL, 1), "status level"),
        (lambda rig: setattr(servo_of(rig), "position", 1015.0), "outside of pump.travel"),
        (
            lambda rig: [
                servo_of(rig).set(r, 0) for r in (registers.CW_LIMIT, registers.CCW_LIMIT)
            ],
            "wheel mode",
        ),
    ],
)
def test_connecting_refuses_what_must_not_move(trouble: Callable[[Rig], None], told: str) -> None:
    rig = Rig()
    trouble(rig)
    with pytest.raises(PumpError, match=told):
        rig.pump.connect()
    assert not any(list(sent.writes()) for sent in rig.tap.sent)


@pytest.fixture
def armed() -> Rig:
    rig = Rig()
    rig.begin()
    rig.pump.reach = 5
    return rig


@pytest.mark.parametrize("goal", [206, 194, TRAVEL[0] - 1, TRAVEL[1] + 1])
def test_goals_out_of_reach_or_travel_are_never_sent(armed: Rig, goal: int) -> None:
    before = len(armed.tap.sent)
    with pytest.raises(PumpError, match=r"one tick's travel|outside its travel"):
        armed.pump.set_goals({1: goal}, {1: 10.0})
    assert len(armed.tap.sent) == before


def test_without_torque_no_goal_is_sent() -> None:
    rig = Rig()
    rig.pump.connect()
    with pytest.raises(PumpError, match="not armed"):
        rig.pump.set_goals({1: 201}, {1: 10.0})


@pytest.mark.parametrize(("may_retreat", "allowed"), [(True, [199, 200]), (False, [200])])
def test_an_alarm_locks_all_but_what_makes_room(
    armed: Rig, may_retreat: bool, allowed: list[int]
) -> None:
    armed.pump.alarm = Stop("pressure_cap", "too much", may_retreat=may_retreat)
    for goal in (199, 200, 201):
        armed.pump.goals = {1: 200}
        if goal in allowed:
            armed.pump.set_goals({1: goal}, {1: 10.0})
        else:
            with pytest.raises(PumpError, match="locked by an alarm"):
                armed.pump.set_goals({1: goal}, {1: 10.0})


def test_what_no_servo_can_follow_is_not_armed() -> None:
    rig = Rig()
    rig.pump.connect()
    with pytest.raises(PumpError, match="counts/s requested"):
        rig.pump.arm(2500.0)
    assert not servo_of(rig).get(registers.TORQUE_ENABLE)


@pytest.mark.parametrize(
    ("speed", "register"),
    [(0.0, 1), (1e-9, 1), (SLOWEST_SPEED, 1), (1.01 * SLOWEST_SPEED, 2), (1e6, 1023)],
)
def test_the_speed_register_is_never_full_speed(speed: float, register: int) -> None:
    assert speed_register(speed) == register


def test_the_torque_limit_follows_cap_friction_and_speed() -> None:
    pump = Settings(syringe_diameter=0.0349, max_pressure=25e3)
    still = torque_limit(pump)
    # By hand: (25 kPa 9.566 cm2 + 5 N) 14.8 mm = 0.428 N m of 1.665 N m at 11.1 V, times 1.2.
    assert still == pytest.approx(1023 * 1.2 * 0.4280 / 1.665, abs=2)
    assert 25e3 < stalling_pressure(pump, still) < 40e3
    assert torque_limit(pump, free_speed(pump) / 2) == pytest.approx(still + 0.6 * 1023, abs=2)
    assert torque_limit(pump, free_speed(pump)) == 1023


def test_release_is_read_back(armed: Rig) -> None:
    (left,) = armed.pump.release()
    assert left.verified
    assert not servo_of(armed).get(registers.TORQUE_ENABLE)


def test_torque_limits_of_some_go_in_a_packet_of_their_own() -> None:
    rig = Rig((1, 2))
    rig.begin()
    before = len(rig.tap.sent)
    rig.board.move({1: Goal(200, 20), 2: Goal(201, 20, 350)})
    first, second = rig.tap.sent[before:]
    assert (first.register(registers.GOAL_POSITION), second.register(registers.GOAL_POSITION)) == (
        {1: 200},
        {2: 201},
    )
    assert first.register(registers.TORQUE_LIMIT) == {}
    assert second.register(registers.TORQUE_LIMIT) == {2: 350}


@pytest.mark.parametrize("torque", [0, 1024])
def test_no_torque_limit_lets_go_or_is_none(torque: int) -> None:
    with pytest.raises(PumpError, match="1 to 1023"):
        Goal(200, 20, torque)
