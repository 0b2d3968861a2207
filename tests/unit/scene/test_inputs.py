"""Inputs: values, corners, coefficients and transient times."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.inputs.base import Input

SPECS = {
    "constant": "{kind: constant, value: 3 kPa}",
    "step": "{kind: step, value: 3 kPa, time: 1 s}",
    "sine": "{kind: sine, amplitude: 3 kPa, frequency: 0.5 Hz, phase: 90 deg, mean: 1 kPa}",
    "square": "{kind: square, high: 2 kPa, low: -1 kPa, frequency: 1 Hz, duty: 25 %}",
    "trapezoid": "{kind: trapezoid, high: 2 kPa, low: -1 kPa, rise: 0.5 s, hold: 1 s, fall: 0.25 s, rest: 0.25 s}",
    "double_sigmoid": "{kind: double_sigmoid, start: 40.41 kPa, drop: 141.3 kPa, fall_time: 0.5 s, rise_time: 4 s, transition: 0.875 s}",
    "harmonics": "{kind: harmonics, period: 6.1 s, mean: 1 kPa, cosine: [1 kPa, -0.5 kPa], sine: [0.3 kPa, 0.4 kPa]}",
    "table": "{kind: table, rows: [[0.5, 1 kPa], [1, 2 kPa], [1, 0], [2, -1 kPa]]}",
    "syringe": "{kind: syringe, diameter: 20 mm, start: 40 mm, dead_volume: 1 mL, rows: [[0.5, 1 mm], [1, 3 mm], [2, -1 mm]]}",
}  # fmt: skip


def made(kind: str, changes: str = "") -> Input:
    return leg(f"input={SPECS[kind]}", *([changes] if changes else [])).inputs["inlet"]


def test_every_kind_is_covered() -> None:
    assert set(SPECS) == set(INPUT_KINDS)


@pytest.mark.parametrize("kind", SPECS)
def test_expression_and_pressure_agree_inside_every_interval(kind: str) -> None:
    source, duration = made(kind), 8.0
    corners = source.corners(duration)
    edges = np.array([0.0, *corners, duration])
    pieces = source.pieces(edges)
    assert pieces.shape == (len(edges) - 1, source.coefficients)
    for k, piece in enumerate(pieces):
        times = edges[k] + (edges[k + 1] - edges[k]) * np.array([0.01, 0.3, 0.5, 0.99])
        direct = source.values(times)
        by_piece = [source.expression(t, piece, np) for t in times]
        assert by_piece == pytest.approx(direct, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize("kind", SPECS)
def test_corners_are_inside_and_increase(kind: str) -> None:
    corners = made(kind).corners(3.3)
    assert corners == sorted(set(corners))
    assert all(0 < t < 3.3 for t in corners)


def test_values() -> None:
    assert made("square").values(np.array([0, 0.2, 0.25, 0.9, 1.0])) == pytest.approx(
        [2e3, 2e3, -1e3, -1e3, 2e3]
    )
    trapezoid = made("trapezoid").values(np.array([0, 0.25, 0.5, 1.4, 1.625, 1.75, 2.0, 2.25]))
    assert trapezoid == pytest.approx([-1e3, 500, 2e3, 2e3, 500, -1e3, -1e3, 500])
    table = made("table").values(np.array([0, 0.5, 0.75, 1.0, 1.5, 2, 9]))
    assert table == pytest.approx([1e3, 1e3, 1.5e3, 0, -500, -1e3, -1e3])
    assert made("sine").values(np.array([0.0, 1.0])) == pytest.approx([4e3, -2e3])


@pytest.mark.parametrize("kind", SPECS)
@pytest.mark.parametrize("duration", [0.2, 0.7, 1.0, 1.6, 3.3, 8.0])
def test_extremes_are_those_of_dense_samples(kind: str, duration: float) -> None:
    source = made(kind)
    corners = np.array([0.0, *source.corners(duration)])
    ends = np.array([*corners[1:], duration])
    grid = np.concatenate([a + (b - a) * np.linspace(0.0, 1 - 1e-12, 4001)
                           for a, b in zip(corners, ends, strict=True)])  # fmt: skip
    values, (low, high) = source.values(grid), source.extremes(duration)
    size = max(abs(low), abs(high))
    assert low == pytest.approx(values.min(), abs=1e-6 * size)
    assert high == pytest.approx(values.max(), abs=1e-6 * size)
    assert low <= values.min() + 1e-12 * size
    assert high >= values.max() - 1e-12 * size


@pytest.mark.parametrize("phase", [0, 45, 90, 200, 300, -30, 725])
@pytest.mark.parametrize("duration", [0.05, 0.3, 0.6, 1.1, 2000.0])
def test_extremes_of_a_sine_of_any_phase(phase: int, duration: float) -> None:
    source = leg(
        f"input={{kind: sine, amplitude: -3 kPa, frequency: 1 Hz, phase: {phase} deg, mean: 1 kPa}}"
    ).inputs["inlet"]
    values = source.values(np.linspace(0.0, duration, 100_003))
    tolerance = 10.0 if duration > 2 else 1e-3
    assert source.extremes(duration) == pytest.approx((values.min(), values.max()), abs=tolerance)


def test_extremes_of_a_sine_over_many_periods() -> None:
    """Equal samples of 2000 s would all fall upon its zeros."""
    source = leg("input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}").inputs["inlet"]
    assert source.extremes(2000.0) == (-3e3, 3e3)


def test_extremes_ignore_values_after_the_end() -> None:
    assert made("step").extremes(1.0) == (0.0, 0.0)
    assert made("table").extremes(0.75) == pytest.approx((1e3, 1.5e3))


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        ("constant", math.inf),
        ("step", 0.0),
        ("square", 0.0),
        ("trapezoid", 0.98 * 0.25),
        ("double_sigmoid", 0.67),  # model's reading of the paper's pulse, two digits
        ("sine", 0.8725),
        ("table", 0.0),
    ],
)
def test_transient_time_is_the_shortest_swing(kind: str, expected: float) -> None:
    assert made(kind).transient() == pytest.approx(expected, abs=1e-3)


def test_paper_pulse_at_its_start() -> None:
    assert made("double_sigmoid").values(np.zeros(1))[0] == pytest.approx(40261.52, abs=0.01)


def test_small_wiggles_are_not_swings() -> None:
    rows = "[[0, 0], [1, 1000], [1.001, 999.9], [2, 1000], [5, 0]]"
    source = leg(f"input={{kind: table, rows: {rows}}}").inputs["inlet"]
    assert source.transient() == pytest.approx(0.98, abs=0.02)


def test_noise_does_not_split_a_ramp() -> None:
    time = np.linspace(0, 1, 201)
    noisy = 1e4 * time + 30 * np.cos(400 * math.pi * time)
    rows = [[float(t), float(p)] for t, p in zip(time, noisy, strict=True)]
    assert swing(rows) == pytest.approx(0.98, abs=0.01)


def test_a_ramp_of_small_steps_is_one_swing() -> None:
    rows = [[k / 200, 50.0 * (k // 2)] for k in range(401)]
    assert swing(rows) == pytest.approx(1.96, abs=0.02)


def test_large_steps_are_separate_swings() -> None:
    rows = [[0, 0], [1, 0], [1.1, 100], [9, 100], [9.3, 200], [20, 200]]
    assert swing(rows) == pytest.approx(0.098)


def test_a_jump_between_slow_changes_is_the_shortest_swing() -> None:
    assert swing([[0, 0], [5, 10], [5, 20], [9, 30]]) == 0.0


def test_a_level_table_has_no_swing() -> None:
    assert swing([[0, 5], [1, 5], [2, 5]]) == math.inf


def swing(rows: list[list[float]]) -> float:
    return leg(f"input={{kind: table, rows: {rows}}}").inputs["inlet"].transient()


def test_a_given_transient_time_takes_precedence() -> None:
    assert made("square", "input.transient_time=0.74 s").transient() == 0.74


def test_a_step_starts_from_the_baseline() -> None:
    at_once = leg("input={kind: step, value: 3 kPa}").inputs["inlet"]
    assert at_once.expression(0.0, at_once.initial_piece(), np) == 0.0
    assert at_once.values(np.zeros(1))[0] == 3e3


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("{kind: square, high: 1, low: 2, frequency: 1}", "must be at least low"),
        ("{kind: square, high: 2, low: 1, frequency: 1, duty: 1.5}", "input.duty"),
        ("{kind: square, high: 2, low: 1, frequency: 0}", "above 0 Hz"),
        ("{kind: trapezoid, high: 1, rise: 0, fall: 0}", "the period must be above 0 s"),
        ("{kind: double_sigmoid, start: 1, drop: 1, fall_time: 1, rise_time: 2, transition: 0}", "above 0 s"),
        ("{kind: table, rows: [[0, 1]]}", "must have from 2 to 50000 rows; got 1"),
        ("{kind: table, rows: [[1, 1], [0, 1]]}", "row 2: time decreases"),
        ("{kind: table, rows: [[0, 1, 2], [1]]}", "expected a pair"),
        ("{kind: table}", "one of 'file' and 'rows'"),
        ("{kind: step, value: 1, transient_time: 0}", "above 0 s"),
    ],
)  # fmt: skip
def test_refusals(source: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        leg(f"input={source}")


def test_a_million_periods_are_refused() -> None:
    with pytest.raises(SpecError, match="periods"):
        leg("input={kind: square, high: 1, low: 0, frequency: 1 MHz}", "run.duration=100 s")


def test_the_value_at_the_start_needs_one_period() -> None:
    fast = leg(
        "input={kind: trapezoid, high: 1, rise: 1e-8 s, fall: 1e-8 s}",
        "run={duration: 1e-6 s, output_interval: 1e-7 s}",
    ).inputs["inlet"]
    assert fast.values(np.zeros(1)).tolist() == [0.0]  # of a second there would be 5e7
