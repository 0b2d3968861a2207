"""Which servos may be given another torque limit."""

from __future__ import annotations

import pytest

from tests.unit.pump.samples import servo
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.torque_limit import (
    FULL,
    LONGEST_SATURATION,
    NOTABLE,
    TorqueLimits,
    following_limit,
)


def writable(limits: TorqueLimits, now: float) -> dict[int, int]:
    """Limits in force of servos whose limit would be raised where more is needed."""
    changed = limits.changes(dict.fromkeys(limits.in_force, FULL), now)
    return {servo: limits.in_force[servo] for servo in changed}


def test_who_is_well_may_be_written_to() -> None:
    limits = TorqueLimits()
    limits.update({1: servo(torque_limit=300), 2: servo(torque_limit=400)}, 1.0)
    assert writable(limits, 1.01) == {1: 300, 2: 400}


@pytest.mark.parametrize(
    "state",
    [
        servo(torque_limit=0),
        servo(driven=False),
        servo(errors=ErrorBits.OVERLOAD),
        servo(errors=ErrorBits.OVERHEAT),
    ],
)
def test_who_is_off_is_not(state) -> None:  # type: ignore[no-untyped-def]
    limits = TorqueLimits()
    limits.update({1: state}, 1.0)
    assert writable(limits, 1.01) == {}


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_saturated_servo_is_left_alone_until_its_output_falls(sign: int) -> None:
    limits = TorqueLimits()
    full, less = servo(load=sign * 300 / FULL), servo(load=sign * 250 / FULL)
    for moment in (1.0, 1.0 + LONGEST_SATURATION / 2):
        limits.update({1: full}, moment)
        assert writable(limits, moment) == {1: 300}
    # Time goes on between a reading and a writing too.
    assert writable(limits, 1.0 + 1.01 * LONGEST_SATURATION) == {}
    limits.update({1: full}, 1.0 + 2 * LONGEST_SATURATION)
    assert writable(limits, 1.0 + 2 * LONGEST_SATURATION) == {}
    limits.update({1: less}, 1.0 + 3 * LONGEST_SATURATION)
    assert writable(limits, 1.0 + 3 * LONGEST_SATURATION) == {1: 300}


def test_nothing_read_is_nothing_written() -> None:
    assert writable(TorqueLimits(), 0.0) == {}


@pytest.mark.parametrize(
    ("held", "needed", "then"),
    [
        (300, 300, 300),
        (300, 300 - NOTABLE, 300),
        (310, 309 - NOTABLE, 309 - NOTABLE + NOTABLE // 4),
        (300, 301, 301 + NOTABLE // 4),
        (300, FULL, 3 * 256 + 300 % 256),
        (3 * 256 + 300 % 256, FULL, FULL),
    ],
)
def test_a_limit_is_raised_at_once_and_lowered_where_it_is_notable(
    held: int, needed: int, then: int
) -> None:
    assert following_limit(held, needed) == then


def test_every_limit_is_reached_byte_by_byte_and_none_in_between_is_too_low() -> None:
    for start in range(1, FULL + 1, 13):
        for needed in range(1, FULL + 1, 17):
            held = start
            for _ in range(5):
                after = following_limit(held, needed)
                if after == held:
                    break
                assert (after % 256 == held % 256) != (after // 256 == held // 256)
                # The byte that is not written must not be 0, or an alarm could not be seen.
                assert after // 256 != held // 256 or after >= 256
                assert after >= min(held, needed)
                assert after <= FULL
                held = after
            assert needed <= held <= needed + NOTABLE, (start, needed, held)


def test_a_limit_that_follows_a_changing_speed_is_too_high_for_two_ticks_at_most() -> None:
    """Low limits change by way of one 256 higher: a speed that goes on changing must not keep it there."""
    held, loose = 159, 0
    for tick in range(300):
        needed = 151 + tick
        held = following_limit(held, needed)
        loose = loose + 1 if held > needed + NOTABLE else 0
        assert loose <= 2, (tick, needed, held)


@pytest.mark.parametrize(("before", "after", "then"), [(300, 311, 55), (311, 567, 512)])
def test_a_servo_that_was_off_when_its_limit_was_changed_is_found(
    before: int, after: int, then: int
) -> None:
    limits = TorqueLimits(sent={1: (before, after)})
    for limit, found in ((before, []), (after, []), (0, []), (then, [1])):
        assert limits.revived({1: servo(torque_limit=limit)}) == found
