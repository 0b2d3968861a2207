"""The way to a profile and along it."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.pump.play.path import led_in, way_back
from viscodesign.pump.profile import AROUND, Profile

SPEED = 50.0
"""On the way to a start or back [counts/s]."""


def profile(counts: list[float], servos: tuple[int, ...] = (1,)) -> Profile:
    time = np.arange(len(counts), dtype=float)
    columns = np.repeat(np.array(counts)[:, None], len(servos), axis=1)
    names = tuple(f"inlet{k}" for k in servos)
    return Profile(names, servos, time, columns, 10 * columns)


def test_it_starts_at_the_plunger_and_moves_slowly() -> None:
    course = led_in(profile([300.0, 320.0]), {1: 200}, SPEED)
    assert course.at(0.0) == pytest.approx([200.0])
    assert course.begins == pytest.approx(100 / SPEED)
    assert course.at(course.begins) == pytest.approx([300.0])
    assert course.at(course.begins + 0.5) == pytest.approx([310.0])
    assert course.duration == pytest.approx(course.begins + 1.0)
    moments = np.arange(0.0, course.begins, 0.01)
    steps = np.diff([course.at(t)[0] for t in moments])
    assert np.abs(steps).max() <= SPEED * 0.01 * (1 + 1e-9)


def test_no_pressure_is_expected_before_the_profile() -> None:
    course = led_in(profile([300.0, 320.0]), {1: 200}, SPEED)
    assert course.expected_pressure(course.begins - 1e-6) == (None,)
    assert course.expected_pressure(course.begins + 0.5) == pytest.approx((3100.0,))


def test_several_plungers_arrive_together() -> None:
    course = led_in(profile([300.0, 320.0], (1, 2)), {1: 200, 2: 290}, SPEED)
    assert course.begins == pytest.approx(2.0)
    assert course.at(1.0) == pytest.approx([250.0, 295.0])


def test_one_tick_reaches_as_far_as_the_steepest_part() -> None:
    assert led_in(profile([200.0, 200.0, 290.0]), {1: 200}, SPEED).reach(1 / 30) == 4


def test_the_way_back_expects_no_pressure() -> None:
    back = way_back(profile([300.0, 320.0]), {1: 320}, 200, SPEED)
    assert back.at(0.0) == pytest.approx([320.0])
    assert back.at(back.duration) == pytest.approx([200.0])
    assert back.expected_pressure(back.duration) == (None,)


def test_the_pace_is_the_steepest_part_about_a_moment_of_each_servo() -> None:
    uneven = profile([0.0, 10.0, 110.0, 110.0, 110.0], (1, 2))
    uneven.steps[:, 1] = [0.0, 0.0, 0.0, -30.0, 0.0]
    assert uneven.paces(0.5) == {1: 10.0, 2: 0.0}
    assert uneven.paces(1.0 - 1.01 * AROUND) == {1: 10.0, 2: 0.0}
    assert uneven.paces(1.0 - 0.99 * AROUND) == {1: 100.0, 2: 0.0}
    assert uneven.paces(2.0 + 0.99 * AROUND) == {1: 100.0, 2: 30.0}
    assert uneven.paces(2.5) == {1: 0.0, 2: 30.0}
    assert uneven.paces(-1.0) == {1: 0.0, 2: 0.0}
    assert uneven.paces(9.0) == {1: 0.0, 2: 0.0}
