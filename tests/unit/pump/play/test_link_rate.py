"""The rate that a link can hold: measured, lowered, refused."""

from __future__ import annotations

import pytest

from tests.pump_rig import Rig
from viscodesign.errors import PumpError
from viscodesign.pump.play.link_rate import (
    LOWEST_RATE,
    RoundTrip,
    measure_round_trip,
    sustainable_rate,
)


def measured(latency: float) -> tuple[Rig, RoundTrip]:
    rig = Rig((1, 2))
    rig.adapter.latency = latency
    rig.pump.connect()
    before = len(rig.tap.sent)
    trip = measure_round_trip(rig.pump.look, rig.clock)
    assert not any(list(sent.writes()) for sent in rig.tap.sent[before:])
    return rig, trip


def test_a_quick_link_holds_what_is_requested() -> None:
    _, trip = measured(1e-3)
    assert trip.median == pytest.approx(trip.worst, abs=1e-3)
    assert sustainable_rate(30.0, trip) == (30.0, "")


def test_the_rate_is_lowered_to_what_the_adapters_latency_allows() -> None:
    _, trip = measured(16e-3)
    assert trip.median > 32e-3  # one request for each servo
    rate, note = sustainable_rate(30.0, trip)
    assert LOWEST_RATE <= rate < 30.0
    assert rate * trip.median <= 0.8
    assert "rate lowered from 30" in note
    assert "latency" in note


def test_a_link_that_is_too_slow_for_any_rate_is_refused() -> None:
    _, trip = measured(48e-3)
    with pytest.raises(PumpError, match="too long for 10 set-points a second"):
        sustainable_rate(10.0, trip)


def test_one_slow_reply_is_told_but_lowers_nothing() -> None:
    trip = RoundTrip(5e-3, 60e-3)
    assert sustainable_rate(50.0, trip) == (50.0, "")
    assert str(trip) == "5 ms (worst 60 ms)"
