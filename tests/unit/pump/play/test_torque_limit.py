"""Which servos may be given another torque limit."""

from __future__ import annotations

import pytest

from tests.unit.pump.samples import servo
from viscodesign.pump.bus.packets import ErrorBits
from viscodesign.pump.play.torque_limit import (
    FULL,
    LONGEST_SATURATION,
    NOTABLE,
    TorqueSaturation,
    following_limit,
)


def test_who_is_well_may_be_written_to() -> None:
    saturation = TorqueSaturation()
    saturation.note({1: servo(torque_limit=300), 2: servo(torque_limit=400)}, 1.0)
    assert saturation.writable(1.01) == {1: 300, 2: 400}


@pytest.mark.parametrize(
    "state",
    [
        servo(torque_limit=0),
        servo(torque=False),
        servo(errors=ErrorBits.OVERLOAD),
        servo(errors=ErrorBits.OVERHEAT),
    ],
)
def test_who_is_off_is_not(state) -> None:  # type: ignore[no-untyped-def]
    saturation = TorqueSaturation()
    saturation.note({1: state}, 1.0)
    assert saturation.writable(1.01) == {}


@pytest.mark.parametrize("sign", [-1, 1])
def test_who_strains_for_long_is_not_until_it_gives_less(sign: int) -> None:
    saturation = TorqueSaturation()
    full, less = servo(load=sign * 300 / FULL), servo(load=sign * 250 / FULL)
    for moment in (1.0, 1.0 + LONGEST_SATURATION / 2):
        saturation.note({1: full}, moment)
        assert saturation.writable(moment) == {1: 300}
    # Time goes on between a reading and a writing too.
    assert saturation.writable(1.0 + 1.01 * LONGEST_SATURATION) == {}
    saturation.note({1: full}, 1.0 + 2 * LONGEST_SATURATION)
    assert saturation.writable(1.0 + 2 * LONGEST_SATURATION) == {}
    saturation.note({1: less}, 1.0 + 3 * LONGEST_SATURATION)
    assert saturation.writable(1.0 + 3 * LONGEST_SATURATION) == {1: 300}


def test_nothing_read_is_nothing_written() -> None:
    assert TorqueSaturation().writable(0.0) == {}


@pytest.mark.parametrize(
    ("held", "needed", "then"),
    [
        (300, 300, 300),
        (300, 300 - NOTABLE, 300),
        (300, 299 - NOTABLE, 299 - NOTABLE + NOTABLE // 4),
        (300, 301, 301 + NOTABLE // 4),
        (300, FULL, FULL),
    ],
)
def test_a_limit_is_raised_at_once_and_lowered_where_it_is_notable(
    held: int, needed: int, then: int
) -> None:
    assert following_limit(held, needed) == then
