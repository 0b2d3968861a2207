"""Every rule that stops a pump: when it does, when it does not, and what it says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import pytest

from tests.unit.pump.samples import sample, servo
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.play.axis import AxisLimits, Sample
from viscodesign.pump.play.guard import Guard, first_broken
from viscodesign.pump.play.safety_rules import retreat_rules, stream_rules
from viscodesign.scene.pumps.servo import ServoPumpSpec

LIMITS = axis_limits(ServoPumpSpec(syringe_diameter=0.0349))


def rule(name: str, limits: AxisLimits = LIMITS) -> Guard:
    """The rule of a stream with this name, which has seen nothing yet."""
    return next(guard for guard in stream_rules(limits, 3) if guard.rule == name)


def first_stop(guard: Guard, samples: Sequence[Sample]) -> int | None:
    """Index of the sample that stops the pump."""
    for k, one in enumerate(samples):
        if guard.check(one) is not None:
            return k
    return None


@pytest.mark.parametrize(
    ("kilopascals", "stops"),
    [
        ([24.9, 24.9, 24.9], None),
        ([26, 24, 26, 24, 26], None),  # one alone is noise
        ([24, 26, 26, 24], 2),
        ([24, 25, 25, 25], None),  # the cap itself is allowed
        ([26, math.nan], 1),  # no number is no reading below the cap
        ([math.nan, math.nan], 1),
        ([-90, -90], None),
    ],
)
def test_the_cap_takes_two_samples(kilopascals: list[float], stops: int | None) -> None:
    samples = [sample(pressure=1e3 * p) for p in kilopascals]
    assert first_stop(rule("pressure_cap"), samples) == stops


def test_the_first_broken_rule_is_told_and_all_of_them_count() -> None:
    guards = [rule("silence"), rule("pressure_cap"), rule("low_battery")]
    assert first_broken(guards, sample(pressure=26e3, state=servo(voltage=9.0))) is None
    stop = first_broken(guards, sample(pressure=26e3, state=servo(voltage=9.0)))
    assert stop is not None
    assert stop.rule == "pressure_cap"
    assert [guard.count for guard in guards] == [0, 1, 2]
    assert "26.00 kPa gauge" in stop.reason
    assert "pump.max_pressure" in stop.reason


def test_a_frozen_sensor_is_found_when_the_pressure_should_change() -> None:
    wanted = [1e3 * k for k in range(12)]
    frozen = [sample(pressure=2e3, wanted=w) for w in wanted]
    assert first_stop(rule("sensor_frozen"), frozen) == 7  # more than 6 kPa
    alive = [sample(pressure=w, wanted=w) for w in wanted]
    assert first_stop(rule("sensor_frozen"), alive) is None


def test_a_sensor_is_frozen_if_it_does_not_change_with_the_pressure() -> None:
    guard = rule("sensor_frozen")
    for expected in (0.0, 3e3, 6e3):
        assert guard.check(sample(pressure=1e3, wanted=expected)) is None
    stop = guard.check(sample(pressure=1e3, wanted=7e3))
    assert stop is not None
    assert "frozen: it kept reading 1.00 kPa" in stop.reason
    assert "changed by 7.0 kPa" in stop.reason
    alive = rule("sensor_frozen")
    for step in range(10):
        assert alive.check(sample(pressure=1e3 + step // 2, wanted=3e3 * step)) is None


def test_a_steady_pressure_may_read_the_same_for_ever() -> None:
    assert first_stop(rule("sensor_frozen"), [sample(pressure=2e3, wanted=2.1e3)] * 1000) is None


def test_where_nothing_measures_nothing_is_frozen() -> None:
    samples = [sample(pressure=None, wanted=1e3 * k) for k in range(20)]
    assert first_stop(rule("sensor_frozen"), samples) is None


@pytest.mark.parametrize(
    ("pressed", "step", "stops"),
    [
        ("", 3, False),
        ("high", 3, True),
        ("high", 0, False),
        ("high", -3, False),
        ("low", -3, True),
        ("low", 3, False),
        ("low high", 3, True),  # both: a broken wire of one
        ("low high", -3, True),
    ],
)
def test_a_switch_allows_only_motion_away(pressed: str, step: int, stops: bool) -> None:
    reason = rule("limit_switch").check(sample(pressed=pressed, step=step))
    assert (reason is not None) == stops


def test_running_into_a_switch_stops_before_the_next_step() -> None:
    # The profile stands still for a few ticks between two of its counts.
    guard = rule("limit_switch")
    assert guard.check(sample(step=1)) is None
    assert guard.check(sample(step=0)) is None
    assert guard.check(sample(step=0, pressed="high")) is not None


def test_leaving_a_switch_goes_on() -> None:
    guard = rule("limit_switch")
    samples = [sample(pressed="low", step=1)] * 5 + [sample(step=1)] * 5
    assert first_stop(guard, samples) is None


@pytest.mark.parametrize(
    ("position", "stops"), [(100, False), (95, False), (94, True), (1006, True)]
)
def test_travel(position: int, stops: bool) -> None:
    reason = rule("travel", replace(LIMITS, travel=(100, 1000))).check(
        sample(state=servo(position))
    )
    assert (reason is not None) == stops


def test_a_blocked_plunger_is_noticed_after_three_samples() -> None:
    behind = sample(state=servo(500, goal=564))
    assert first_stop(rule("following"), [behind] * 5) == 2
    assert first_stop(rule("following"), [sample(state=servo(500, goal=563))] * 5) is None


def test_a_lost_command_may_be_lost_twice() -> None:
    arrived = sample(state=servo(500))
    lost = Sample(**{**vars(arrived), "goals": {1: 503}})
    assert first_stop(rule("command_lost"), [lost, lost, arrived, lost, lost]) is None
    assert first_stop(rule("command_lost"), [lost, lost, lost]) == 2


def test_a_servo_that_restarted_is_noticed_at_once() -> None:
    stop = rule("command_lost").check(sample(state=servo(driven=False)))
    assert stop is not None
    assert "restarted" in stop.reason


@pytest.mark.parametrize("bit", list(ErrorBits))
def test_every_error_bit_stops(bit: ErrorBits) -> None:
    stop = rule("servo_alarm").check(sample(state=servo(errors=bit)))
    assert stop is not None
    assert "servo 1 reports: " in stop.reason


def test_heat_and_battery_take_two_samples() -> None:
    hot, cool = sample(state=servo(temperature=70.0)), sample(state=servo(temperature=69.0))
    assert first_stop(rule("temperature"), [hot, cool, hot, hot]) == 3
    low, full = sample(state=servo(voltage=9.9)), sample(state=servo(voltage=10.0))
    assert first_stop(rule("low_battery"), [low, full, low, low]) == 3


def test_a_silence_of_more_than_a_quarter_of_a_second_stops() -> None:
    times = [0.0, 0.033, 0.28, 0.54]
    assert first_stop(rule("silence"), [sample(time=t) for t in times]) == 3


def test_every_rule_names_itself_and_leaves_a_healthy_pump_alone() -> None:
    rules = stream_rules(LIMITS, 3)
    assert len({guard.rule for guard in rules}) == len(rules) == 11
    assert all(guard.check(sample(time=0.01 * k)) is None for k in range(50) for guard in rules)


def test_drawing_back_is_watched_by_all_but_the_pressure() -> None:
    pump = LIMITS
    left_out = {g.rule for g in stream_rules(pump, 3)} - {g.rule for g in retreat_rules(pump, 3)}
    assert left_out == {"behind_profile", "pressure_cap", "sensor_frozen"}


# -- two inlets -----------------------------------------------------------------------------


def two(
    pressure: tuple[float | None, float | None] = (10e3, 10e3),
    wanted: tuple[float, float] = (10e3, 10e3),
    pressed: str = "",
    steps: tuple[int, int] = (0, 0),
) -> Sample:
    """Servos 4 and 7; ``pressed``: ends of servo 7."""
    states = {4: servo(), 7: servo()}
    goals = {number: state.goal for number, state in states.items()}
    return Sample(
        time=0.0,
        axes=states,
        pressure=pressure,
        wanted=wanted,
        pressed={4: frozenset(), 7: frozenset(pressed.split())},
        goals=goals,
        next_goals={4: goals[4] + steps[0], 7: goals[7] + steps[1]},
        noun="servo",
    )


@pytest.mark.parametrize(
    ("pairs", "stops"),
    [
        ([(24e3, 26e3), (24e3, 26e3)], 1),
        ([(26e3, 24e3), (24e3, 26e3), (26e3, 24e3)], None),  # one sample each is noise
        ([(None, 26e3), (None, 26e3)], 1),
        ([(24e3, math.nan), (24e3, math.nan)], 1),  # a number beside it hides it not
    ],
)
def test_each_inlet_is_capped(
    pairs: list[tuple[float | None, float | None]], stops: int | None
) -> None:
    assert first_stop(rule("pressure_cap"), [two(pressure=pair) for pair in pairs]) == stops


def test_the_inlet_above_the_cap_is_named_by_its_servo() -> None:
    guard = rule("pressure_cap")
    guard.check(two(pressure=(10e3, 26e3)))
    stop = guard.check(two(pressure=(10e3, 26e3)))
    assert stop is not None
    assert "26.00 kPa gauge in 2 samples at the inlet of servo 7" in stop.reason


def test_a_frozen_sensor_of_either_inlet_is_found() -> None:
    samples = [two(pressure=(1e3 * k, 2e3), wanted=(1e3 * k, 1e3 * k)) for k in range(12)]
    assert first_stop(rule("sensor_frozen"), samples) == 7
    reason = [rule("sensor_frozen").check(one) for one in samples]
    assert reason == [None] * 12  # each guard counts for itself
    guard = rule("sensor_frozen")
    told = [guard.check(one) for one in samples][7]
    assert told is not None
    assert "at the inlet of servo 7" in told.reason


@pytest.mark.parametrize(
    ("steps", "stops"), [((3, 0), False), ((-3, 0), False), ((0, -3), False), ((0, 3), True)]
)
def test_a_switch_bars_only_its_own_plunger(steps: tuple[int, int], stops: bool) -> None:
    stop = rule("limit_switch").check(two(pressed="high", steps=steps))
    assert (stop is not None) == stops
    if stop is not None:
        assert "the high end of servo 7" in stop.reason


def test_running_into_a_switch_is_noticed_of_the_plunger_that_does() -> None:
    guard = rule("limit_switch")
    assert guard.check(two(steps=(1, -1))) is None
    # Servo 4 went up, but the switch is servo 7's.
    assert guard.check(two(pressed="high")) is None
    assert guard.check(two(pressed="low")) is not None


def test_a_torque_limit_of_zero_is_a_servo_that_shut_itself_off() -> None:
    stop = rule("servo_alarm").check(sample(state=servo(torque_limit=0)))
    assert stop is not None
    assert "shut itself off" in stop.reason
