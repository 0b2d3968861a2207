"""A steady grid of moments; late ones are dropped."""

from __future__ import annotations

import pytest

from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.play.ticks import Ticks


def begun(period: float = 0.1) -> tuple[Ticks, SteppedClock]:
    clock = SteppedClock()
    clock.sleep(7.0)
    ticks = Ticks(clock, period)
    ticks.begin()
    return ticks, clock


def test_moments_do_not_drift() -> None:
    ticks, clock = begun()
    for k in range(1, 1001):
        clock.sleep(0.03)
        ticks.wait()
        assert clock.now() - 7.0 == pytest.approx(0.1 * k, abs=1e-9)
    assert (ticks.done, ticks.skipped) == (1000, 0)


def test_late_ticks_are_skipped_and_counted() -> None:
    ticks, clock = begun()
    ticks.wait()
    clock.sleep(0.35)  # 0.45: the moments 0.2 and 0.3 are gone, and 0.4 is late
    ticks.wait()
    assert (ticks.index, ticks.skipped) == (4, 2)
    assert ticks.worst == pytest.approx(0.05)
    ticks.wait()
    assert clock.now() - 7.0 == pytest.approx(0.5)
    assert (ticks.index, ticks.skipped) == (5, 2)


def test_a_little_late_is_not_skipped() -> None:
    ticks, clock = begun()
    clock.sleep(0.15)
    ticks.wait()
    assert (ticks.index, ticks.skipped) == (1, 0)
    assert clock.now() - 7.0 == pytest.approx(0.15)


def test_waiting_ends_when_it_is_not_wanted_any_more() -> None:
    ticks, clock = begun(10.0)
    ticks.wait(lambda: clock.now() < 8.0)
    assert clock.now() == pytest.approx(8.0, abs=0.03)


def test_the_document_tells_rate_and_jitter() -> None:
    ticks, clock = begun()
    clock.sleep(0.15)
    ticks.wait()
    told = ticks.document()
    assert told["rate_hz"] == pytest.approx(10.0)
    assert told["worst_lateness_s"] == pytest.approx(0.05)
    assert (told["ticks"], told["skipped_ticks"]) == (1, 0)
