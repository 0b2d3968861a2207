"""Goals of the next tick: smooth, within reach, and ahead by what the servo stays behind."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.pumps import pump
from viscodesign.pump.ax.servo_pump import (
    COMPLIANCE_SLOPE,
    LARGEST_LEAD,
    axis_limits,
    speed_register,
)
from viscodesign.pump.play.path import SetPoints
from viscodesign.pump.profile import Profile

PERIOD = 1 / 30
FREE = 1800.0


def points(speed: float) -> SetPoints:
    time = np.array([0.0, 10.0])
    counts = np.array([[500.0], [500.0 + 10.0 * speed]])
    profile = Profile(("inlet",), (1,), time, counts, np.zeros((2, 1)))
    return SetPoints(profile, PERIOD, replace(axis_limits(pump()), top_speed=FREE))


def test_a_slow_ramp_steps_by_single_counts_at_its_own_speed() -> None:
    course, goals, steps = points(6.0), {1: 500}, []
    for k in range(90):
        new, speeds = course.next(k * PERIOD, goals, 2)
        steps.append(new[1] - goals[1])
        goals = new
        assert speed_register(speeds[1]) <= 5  # 11 counts/s
    assert set(steps) == {0, 1}
    assert sum(steps) == pytest.approx(18, abs=1)


def test_on_a_fast_ramp_goals_lead_by_what_the_speed_needs() -> None:
    speed = 900.0
    new, _ = points(speed).next(1.0, {1: 1430}, 100)
    assert new[1] == round(500 + speed * (1.0 + PERIOD) + COMPLIANCE_SLOPE * speed / FREE)


@pytest.mark.parametrize("before", [400, 600])
def test_no_goal_is_out_of_reach(before: int) -> None:
    new, _ = points(0.0).next(1.0, {1: before}, 3)
    assert abs(new[1] - before) == 3


def test_what_a_load_holds_back_is_learnt_and_bounded() -> None:
    course = points(0.0)
    for _ in range(3):
        course.learn(1.0, {1: 492})
    assert course.behind[1] == pytest.approx(3 * 0.25 * 8)
    for _ in range(100):
        course.learn(1.0, {1: 400})
    assert course.behind[1] == LARGEST_LEAD
    course.learn(1.0, {1: 500})
    assert course.behind[1] == LARGEST_LEAD  # in place: what holds it there is kept
