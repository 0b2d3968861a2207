"""Which part of a run is its loop, and values between output times."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.results.loop_part import LoopPart

TIME = np.linspace(0.0, 8.0, 401)


@pytest.mark.parametrize(
    ("period", "start", "is_period", "intervals"),
    [(None, 0.0, False, 400), (2.0, 6.0, True, 100), (8.0, 0.0, True, 400), (9.0, 0.0, False, 400),
     (2.03, 5.97, True, 101), (8.0 * (1 + 1e-12), 0.0, True, 400)],
)  # fmt: skip
def test_the_last_period_or_the_whole_run(
    period: float | None, start: float, is_period: bool, intervals: int
) -> None:
    part = LoopPart.of(TIME, period)
    assert part.start == pytest.approx(start, abs=1e-12)
    assert part.is_period is is_period
    assert part.intervals == pytest.approx(intervals, abs=1)
    assert part.duration == pytest.approx(8.0 - start, abs=1e-9)


def test_its_path_begins_where_it_begins_and_has_every_output_after_that() -> None:
    path = LoopPart.of(TIME, 2.03).path
    assert path.at[0] == pytest.approx(5.97)
    assert path.at[1:] == pytest.approx(TIME[299:])
    assert path.values(TIME**2)[0] == pytest.approx((5.96**2 + 5.98**2) / 2)
    aligned = LoopPart.of(TIME, 2.0).path
    assert aligned.values(TIME) == pytest.approx(TIME[300:])
    assert len(aligned.at) in (101, 102)  # a start that round-off puts before an output is another


def test_pulling_back_is_the_transpose() -> None:
    rng = np.random.default_rng(1)
    for sampled in (LoopPart.of(TIME, 2.03).path, LoopPart.of(TIME, None).even(217)):
        rows, weights = rng.random((401, 2)), rng.random((len(sampled.at), 2))
        ahead = np.sum(sampled.values(rows) * weights)
        assert np.sum(rows * sampled.pulled_back(weights)) == pytest.approx(ahead, rel=1e-13)


@pytest.mark.parametrize("period", [2.03, 2.0])
def test_change_with_the_period(period: float) -> None:
    """At an output time, too: there as central differences have it."""
    rows, step = np.sin(TIME)[:, None], 1e-6
    low, high = (LoopPart.of(TIME, period + sign * step).even(50).values(rows) for sign in (-1, 1))
    found = LoopPart.of(TIME, period).even(50).change_with_period(rows)
    assert found == pytest.approx((high - low) / (2 * step), abs=1e-8)


def test_a_whole_run_does_not_change_with_a_period() -> None:
    assert not LoopPart.of(TIME, None).even(50).change_with_period(np.sin(TIME)).any()


def test_uneven_output_times() -> None:
    time = np.array([0.0, 0.1, 0.5, 2.0, 3.0])
    part = LoopPart.of(time, 2.0)
    assert part.path.values(time) == pytest.approx([1.0, 2.0, 3.0])
    assert part.even(4).values(time) == pytest.approx([1.0, 1.5, 2.0, 2.5, 3.0])


def test_a_single_output_time() -> None:
    part = LoopPart.of(np.array([1.0]), 2.0)
    assert not part.is_period
    assert part.path.values(np.array([[3.0, 4.0]])) == pytest.approx(np.array([[3.0, 4.0]]))
