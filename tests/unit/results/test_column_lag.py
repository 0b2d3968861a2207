"""Lags that are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.results.column_lag import LAG, column_lag, intervals_for

COUNT = 400
TURNS = 2 * math.pi * np.arange(COUNT + 1) / COUNT
SECONDS = np.linspace(0.0, 8.0, COUNT + 1)
SPACING = 8.0 / COUNT


def cycle(turns: np.ndarray) -> np.ndarray:
    """A periodic pressure with harmonics [Pa]."""
    return np.asarray(2e4 * np.sin(turns) + 5e3 * np.cos(2 * turns + 0.4) + 1e4)


def pulse(time: np.ndarray) -> np.ndarray:
    """A pressure that moves from 1.5 s on, down and up again [Pa]."""
    since = np.maximum(time - 1.5, 0.0)
    return np.asarray(4e4 - 1e5 * since**3 / (1 + since**3) * np.exp(-since / 2))


@pytest.mark.parametrize("delay", [0, 1, 37, 150, -1, -80])
def test_a_cycle_delayed_by_whole_intervals(delay: int) -> None:
    left = 0.4 * cycle(TURNS - TURNS[delay] if delay >= 0 else TURNS + TURNS[-delay]) - 3e3
    lag = column_lag(cycle(TURNS), left, is_cyclic=True)
    assert lag.intervals == pytest.approx(delay, abs=1e-9)


@pytest.mark.parametrize("part", [0.1, 0.37, -0.25, 0.49])
def test_a_delayed_sine_between_the_samples(part: float) -> None:
    """Of a single harmonic, sampled and joined by lines, the phase is exact."""
    right, left = np.sin(TURNS) * 1e4, np.sin(TURNS - 2 * math.pi * part) * 3e3
    lag = column_lag(right, left, is_cyclic=True)
    assert lag.intervals == pytest.approx(part * COUNT, abs=1e-3)


def test_a_lag_beyond_half_a_cycle_is_a_lead() -> None:
    left = cycle(TURNS - TURNS[300])
    assert column_lag(cycle(TURNS), left, is_cyclic=True).intervals == pytest.approx(-100, abs=1e-9)


def test_opposite_columns_are_half_a_cycle_apart() -> None:
    lag = column_lag(np.sin(TURNS) * 1e4, -np.sin(TURNS) * 1e4, is_cyclic=True)
    assert abs(lag.intervals) == pytest.approx(COUNT / 2, abs=1e-6)


def test_of_equal_peaks_the_smallest_shift_is_taken() -> None:
    """Both repeat twice within the cycle."""
    lag = column_lag(cycle(2 * TURNS), cycle(2 * (TURNS - TURNS[30])), is_cyclic=True)
    assert lag.intervals == pytest.approx(30, abs=1e-8)


@pytest.mark.parametrize("delay", [0, 1, 25, 130])
@pytest.mark.parametrize("swapped", [False, True])
def test_a_pulse_delayed_by_whole_intervals(delay: int, swapped: bool) -> None:
    early, late = pulse(SECONDS), 0.3 * pulse(SECONDS - delay * SPACING) + 1e4
    pair = (late, early) if swapped else (early, late)
    lag = column_lag(*pair, is_cyclic=False)
    assert lag.intervals == pytest.approx(-delay if swapped else delay, abs=1e-8)


def test_a_step_that_stays() -> None:
    """Its delay, however long it is held after that."""
    rise = [column_lag(*(1e4 * -np.expm1(-np.maximum(time - at, 0.0) / 0.3) for at in (0.5, 0.9)),
                       is_cyclic=False).intervals * 0.02
            for time in (np.arange(201) * 0.02, np.arange(2001) * 0.02)]  # fmt: skip
    assert rise == pytest.approx([0.4, 0.4], abs=1e-9)


def test_a_column_that_fills_more_slowly_lags() -> None:
    """Ramps through first-order filters come out delayed by their time constants."""
    time = np.linspace(0.0, 300.0, 15001)
    ramps = [1e3 * (time - constant * -np.expm1(-time / constant)) for constant in (0.5, 1.5)]
    lag = column_lag(*ramps, is_cyclic=False).intervals * 0.02
    assert lag == pytest.approx(1.0, abs=0.015)


def test_equal_columns_have_none_to_speak_of() -> None:
    for is_cyclic in (True, False):
        lag = column_lag(pulse(SECONDS), pulse(SECONDS), is_cyclic)
        assert lag.intervals == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("right", "left"),
    [
        (cycle(TURNS), np.full(COUNT + 1, 2e4)),
        (np.full(COUNT + 1, 2e4), cycle(TURNS)),
        (cycle(TURNS), 2e4 + 1e-3 * np.sin(TURNS)),
        (1e4 * np.sin(TURNS), 1e4 * np.sin(2 * TURNS)),
        (cycle(TURNS[:4]), cycle(TURNS[:4])),
    ],
)
def test_without_a_lag(right: np.ndarray, left: np.ndarray) -> None:
    lag = column_lag(right, left, is_cyclic=True)
    assert math.isnan(lag.intervals)
    assert np.isnan(lag.by_right).all()
    assert np.isnan(lag.by_left).all()


def test_a_lag_of_more_than_half_the_run_is_none() -> None:
    late = pulse(SECONDS - 4.5)
    assert math.isnan(column_lag(pulse(SECONDS), late, is_cyclic=False).intervals)


def test_opposite_pulses_are_not_alike() -> None:
    step = 1e4 * (SECONDS > 1.0)
    assert math.isnan(column_lag(step, -step, is_cyclic=False).intervals)


@pytest.mark.parametrize("is_cyclic", [True, False])
@pytest.mark.parametrize("swapped", [False, True])
def test_gradients_equal_central_differences(is_cyclic: bool, swapped: bool) -> None:
    if is_cyclic:
        pair = [cycle(TURNS), 0.4 * cycle(TURNS - 0.7) + 1e3 * np.sin(3 * TURNS)]
    else:
        pair = [pulse(SECONDS), 0.3 * pulse(SECONDS - 0.8) + 1e3 * np.sin(SECONDS)]
    right, left = pair[::-1] if swapped else pair
    lag = column_lag(right, left, is_cyclic)
    rng = np.random.default_rng(0)
    for _ in range(5):
        smooth = np.vander(SECONDS / 8.0, 6) @ rng.normal(size=(6, 2))
        step = 1.0  # Pa
        low, high = (
            column_lag(right + sign * step * smooth[:, 0], left + sign * step * smooth[:, 1],
                       is_cyclic).intervals
            for sign in (-1, 1)
        )  # fmt: skip
        found = lag.by_right @ smooth[:, 0] + lag.by_left @ smooth[:, 1]
        assert found == pytest.approx((high - low) / (2 * step), rel=1e-6)


def test_equal_curves_have_the_gradient_of_a_shift() -> None:
    """Both pulses at rest at the end: the lag is the shift of either."""
    time = np.linspace(0.0, 20.0, 2001)
    bump = 1e4 * np.exp(-((time - 8.0) ** 2))
    slope = np.gradient(bump, time)
    lag = column_lag(bump, bump, is_cyclic=False)
    assert lag.by_left @ -slope * 0.01 == pytest.approx(1.0, rel=1e-4)
    assert lag.by_right @ -slope * 0.01 == pytest.approx(-1.0, rel=1e-4)


def test_a_corner_at_the_top_does_not_move() -> None:
    """Two that end far apart: their likeness falls to either side of no shift."""
    time = np.linspace(0.0, 1.0, 201)
    right, left = (1e4 * (time + 0.2 * np.sin(rate * time) ** 2) for rate in (6.0, 3.0))
    lag = column_lag(right, left, is_cyclic=False)
    assert lag.intervals == 0.0
    assert not lag.by_left.any()
    assert not lag.by_right.any()
    assert column_lag(right, left + 10 * time, is_cyclic=False).intervals == 0.0


@pytest.mark.parametrize(("outputs", "found"), [(1, 200), (150, 300), (200, 200), (401, 401)])
def test_samples_fall_on_output_times(outputs: int, found: int) -> None:
    assert intervals_for(outputs) == found
    assert intervals_for(10 * LAG.most_intervals) == LAG.most_intervals
