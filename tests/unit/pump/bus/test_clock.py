"""A simulated board's time goes with the wall's, and is never late."""

from __future__ import annotations

import pytest

from viscodesign.pump.bus import clock as clocks
from viscodesign.pump.bus.clock import PacedClock


def test_what_is_computed_takes_no_time(monkeypatch: pytest.MonkeyPatch) -> None:
    wall, slept = [100.0], []
    monkeypatch.setattr(clocks.time, "monotonic", lambda: wall[0])

    def sleep(seconds: float) -> None:
        slept.append(seconds)
        wall[0] += seconds

    monkeypatch.setattr(clocks.time, "sleep", sleep)
    clock = PacedClock(2.0)
    clock.sleep(1.0)
    assert (clock.now(), sum(slept)) == (1.0, pytest.approx(0.5))
    wall[0] += 10.0  # computing
    assert clock.now() == 1.0
    clock.sleep(1.0)
    assert (clock.now(), sum(slept)) == (2.0, pytest.approx(0.5))  # late already: no sleep
    clock.sleep(1.0)
    # A little of it is made up for, and no more.
    assert sum(slept) == pytest.approx(1.0 - clocks.MADE_UP)


def test_short_waits_are_gathered(monkeypatch: pytest.MonkeyPatch) -> None:
    wall, slept = [0.0], []
    monkeypatch.setattr(clocks.time, "monotonic", lambda: wall[0])

    def sleep(seconds: float) -> None:
        slept.append(seconds)
        wall[0] += seconds

    monkeypatch.setattr(clocks.time, "sleep", sleep)
    clock = PacedClock(1.0)
    for _ in range(1000):
        clock.sleep(1e-4)
    assert wall[0] == pytest.approx(0.1, abs=3e-3)
    assert len(slept) < 60
