"""Filters against their closed solutions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from viscodesign.estimate import modal_response
from viscodesign.estimate.modal_response import FilterStart, first_order, second_order
from viscodesign.native.loops import PythonLoops

TIME = np.sort(np.random.default_rng(3).uniform(0.0, 2.0, 60))
TIME[0] = 0.0
RATES = np.array([-0.3, -2.0, -50.0])


def constant(value: float, count: int) -> np.ndarray:
    return np.full((count, len(TIME)), value)


def decays(delay: float, rate: float, drive: np.ndarray, *, steady: bool = False) -> np.ndarray:
    """One second-order filter (T,)."""
    start = FilterStart.EQUILIBRIUM if steady else FilterStart.REST
    found = second_order(np.array([delay]), np.array([rate]), TIME, drive[None], start)
    return np.asarray(found[0])


@pytest.mark.parametrize("copies", [1, 5])
def test_a_free_filter_decays(copies: int) -> None:
    rates = np.tile(RATES, copies)
    start = np.arange(1.0, len(rates) + 1)
    found = first_order(rates, TIME, constant(0.0, len(rates)), start)
    expected = start[:, None] * np.exp(rates[:, None] * TIME)
    assert found == pytest.approx(expected, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("copies", [1, 5])
def test_a_ramp(copies: int) -> None:
    """y' = r y + a + b t from rest: y = -(a + b t)/r - b/r^2 + (a/r + b/r^2) exp(r t)."""
    rates = np.tile(RATES, copies)
    a, b = 2.0, -3.0
    drive = np.repeat((a + b * TIME)[None], len(rates), axis=0)
    found = first_order(rates, TIME, drive, np.zeros(len(rates)))
    rates = rates[:, None]
    moment = a / rates + b / rates**2
    expected = moment * np.exp(rates * TIME) - drive / rates - b / rates**2
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_a_rate_of_zero_integrates() -> None:
    drive = np.array([np.ones(len(TIME)), TIME])
    found = first_order(np.zeros(2), TIME, drive, np.array([1.0, 0.0]))
    assert found[0] == pytest.approx(1 + TIME, rel=1e-13)
    assert found[1] == pytest.approx(TIME**2 / 2, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("rate", [-1e-5, -1e-4, -1e-3])
def test_slow_filters_keep_their_digits_on_both_sides_of_the_series(rate: float) -> None:
    """Where the closed form loses digits to its differences a series stands in."""
    time = np.array([0.0, 0.7, 1.0])
    drive = (1.0 + 2.0 * time)[None]
    found = first_order(np.array([rate]), time, drive, np.zeros(1))[0, -1]
    # Sum over n of r^n/(n+1)! times what the drive's level and slope give at t = 1.
    expected = 1.0 * (1 + rate / 2 + rate**2 / 6) + 2.0 * (1 / 2 + rate / 6 + rate**2 / 24)
    assert found == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("rate", [-1e9, 1e4, np.nan])
def test_rates_beyond_all_numbers(rate: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """What has decayed is nothing; what grows or is unknown is not told as a number."""
    own = np.array([rate]), np.array([0.0, 1.0, 2.0]), np.ones((1, 3)), np.ones(1)
    with np.errstate(all="ignore"):
        found = first_order(*own)[0, -1]
        monkeypatch.setattr(modal_response, "native_loops", PythonLoops)
        again = first_order(*own)[0, -1]
    for end in (found, again):
        assert end == pytest.approx(1e-9, rel=1e-6) if rate < 0 else not np.isfinite(end)


@pytest.mark.parametrize("copies", [1, 5])
def test_a_jump_of_the_drive_is_felt_only_afterwards(copies: int) -> None:
    time = np.array([0.0, 1.0, 1.0, 2.0])
    drive = np.repeat(np.array([0.0, 0.0, 1.0, 1.0])[None], copies, axis=0)
    found = first_order(np.full(copies, -1.0), time, drive, np.zeros(copies))
    assert found[0] == pytest.approx([0, 0, 0, 1 - np.exp(-1.0)], rel=1e-13)


@pytest.mark.parametrize("turning", [False, True])
def test_loops_and_arrays_give_the_same(turning: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Native code, its twin in Python, and what stands in where there is none; also channels."""
    random = np.random.default_rng(8)
    rate = -(10.0 ** np.array([-5.0, -1.0, 0.5, 2.0])) * (1 + 3j if turning else 1)
    drive, start = random.normal(size=(4, 3, len(TIME))), random.normal(size=(4, 3))
    native = first_order(rate, TIME, drive, start)
    monkeypatch.setattr(modal_response, "native_loops", PythonLoops)
    assert first_order(rate, TIME, drive, start) == pytest.approx(native, rel=1e-12, abs=1e-14)
    monkeypatch.setenv("VISCODESIGN_NATIVE", "off")
    assert first_order(rate, TIME, drive, start) == pytest.approx(native, rel=1e-11, abs=1e-13)


@pytest.mark.parametrize("turning", [False, True])
def test_channels_of_a_filter_are_driven_apart(turning: bool) -> None:
    rate = RATES * (1 + 2j if turning else 1)
    random = np.random.default_rng(9)
    drive, start = random.normal(size=(3, 2, len(TIME))), random.normal(size=(3, 2))
    both = first_order(rate, TIME, drive, start)
    for k in range(2):
        alone = first_order(rate, TIME, drive[:, k], start[:, k])
        assert both[:, k] == pytest.approx(alone, rel=1e-12)


def test_complex_rates_swing() -> None:
    found = first_order(np.array([2j]), TIME, constant(0.0, 1), np.ones(1))
    assert found[0] == pytest.approx(np.exp(2j * TIME), rel=1e-11)


@given(
    count=st.integers(1, 12),
    seed=st.integers(0, 1000),
    exponent=st.floats(-6, 3),
)
@settings(max_examples=40, deadline=None)
def test_samples_between_do_not_change_the_rest(count: int, seed: int, exponent: float) -> None:
    """Exact for a drive that is straight between its samples, however many there are."""
    random = np.random.default_rng(seed)
    rates = -(10.0**exponent) * random.uniform(0.1, 10, count)
    time = np.cumsum(random.uniform(0.01, 1, 7))
    drive = random.standard_normal((count, 7))
    start = random.standard_normal(count)
    finer = np.sort(np.concatenate([time, (time[1:] + time[:-1]) / 2]))
    between = np.array([np.interp(finer, time, row) for row in drive])
    few = first_order(rates, time, drive, start)
    many = first_order(rates, finer, between, start)[:, ::2]
    assert many == pytest.approx(few, rel=1e-7, abs=1e-10)


@pytest.mark.parametrize("case", ["underdamped", "overdamped", "equal roots"])
def test_a_step_on_an_oscillator(case: str) -> None:
    """delay y'' + y' + rate y = 1 from rest."""
    rate = 5.0
    delay = {"underdamped": 1.0, "overdamped": 0.01, "equal roots": 0.25 / rate}[case]
    decay, square = 1 / (2 * delay), rate / delay
    if case == "underdamped":
        swing = np.sqrt(square - decay**2)
        free = np.exp(-decay * TIME) * (np.cos(swing * TIME) + decay / swing * np.sin(swing * TIME))
    elif case == "overdamped":
        apart = np.sqrt(decay**2 - square)
        slow, fast = -decay + apart, -decay - apart
        free = (slow * np.exp(fast * TIME) - fast * np.exp(slow * TIME)) / (slow - fast)
    else:
        free = np.exp(-decay * TIME) * (1 + decay * TIME)
    found = decays(delay, rate, np.ones(len(TIME)))
    assert found == pytest.approx((1 - free) / rate, rel=1e-6, abs=1e-8)


def test_nearly_equal_roots_lie_between_their_neighbours() -> None:
    rate, drive = 5.0, np.ones(len(TIME))
    below, equal, above = (decays(0.25 / rate * f, rate, drive) for f in (1 - 1e-4, 1.0, 1 + 1e-4))
    assert np.max(np.abs(equal - (below + above) / 2)) <= 1e-6 * np.max(equal)


def test_what_is_steady_stays_where_it_is() -> None:
    found = decays(0.1, 4.0, np.full(len(TIME), 8.0), steady=True)
    assert found == pytest.approx(np.full(len(TIME), 2.0), rel=1e-9)


def test_a_ramp_is_followed_with_the_delay_of_its_damping() -> None:
    """Long after its start y = (t - 1/rate)/rate under the drive t, whatever the delay."""
    time = np.linspace(0.0, 200.0, 401)
    found = second_order(
        np.array([0.01, 2.0]),
        np.array([3.0, 3.0]),
        time,
        np.array([time, time]),
        FilterStart.REST,
    )
    assert found[:, -1] == pytest.approx(np.full(2, (200 - 1 / 3) / 3), rel=1e-9)


@pytest.mark.parametrize("steady", [True, False])
def test_a_mode_without_stiffness_stays_at_zero(steady: bool) -> None:
    assert np.all(decays(0.1, 0.0, np.ones(len(TIME)), steady=steady) == 0.0)


def test_filters_of_all_kinds_stand_side_by_side() -> None:
    """One that swings makes the numbers complex; the others must not feel it."""
    delay, rate = np.array([1.0, 0.01, 1e-6, 0.1]), np.array([5.0, 5.0, 2.0, 0.0])
    drive = np.repeat(np.sin(TIME)[None], 4, axis=0)
    together = second_order(delay, rate, TIME, drive, FilterStart.EQUILIBRIUM)
    assert together.dtype == float
    for k in range(4):
        alone = decays(delay[k], rate[k], np.sin(TIME), steady=True)
        assert together[k] == pytest.approx(alone, rel=1e-9, abs=1e-12)


def test_without_delay_it_is_a_filter_of_first_order() -> None:
    drive = np.sin(3 * TIME)
    plain = first_order(np.array([-2.0]), TIME, drive[None], np.zeros(1))[0]
    assert decays(1e-9, 2.0, drive) == pytest.approx(plain, abs=1e-7)


@pytest.mark.parametrize("delay", [1e-3, 5.0])
def test_a_periodic_start_is_on_the_cycle_at_once(delay: float) -> None:
    """Two periods under a sine, against its complex amplitude; delayed much, it rings."""
    time, rate, speed = np.linspace(0.0, 4.0, 4001), 0.05, np.pi
    found = second_order(
        np.array([delay]),
        np.array([rate]),
        time,
        np.sin(speed * time)[None],
        FilterStart.PERIODIC,
    )[0]
    amplitude = 1 / (rate + 1j * speed - delay * speed**2)
    exact = np.imag(amplitude * np.exp(1j * speed * time))
    assert found == pytest.approx(exact, abs=1e-5 * abs(amplitude))
