"""White noise is found and taken out; what is no noise, and every clean table, is followed."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from pydantic_core import PydanticCustomError

from tests.scenes import leg, problem_of
from tests.unit.scene.tables.written import table
from viscodesign import check, load, simulate
from viscodesign.scene.inputs.base import shortest_swing
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.tables.measured import Followed, followed
from viscodesign.scene.tables.noise import white_noise
from viscodesign.scene.tables.smoothing import below_cut_off
from viscodesign.scene.tables.straight_pieces import connected, straight_pieces

Signal = Callable[[np.ndarray], np.ndarray]
SIZE = 15e3
SLOW: dict[str, Signal] = {
    "two sines": lambda t: 12e3 * np.sin(5.2 * t) + 3e3 * np.sin(2.1 * t),
    "pulse": lambda t: SIZE / 2 * (np.tanh(5 * (t - 1.5)) - np.tanh(5 * (t - 4))),
    "trapezoid": lambda t: SIZE * np.clip(np.minimum((t - 0.5) / 1.2, (5 - t) / 1.5), 0, 1),
}
FAST: dict[str, Signal] = {
    "square": lambda t: SIZE * (t % 1.0 < 0.5),
    "step": lambda t: SIZE * (t >= 2.0),
    "sawtooth": lambda t: SIZE * (t % 1.5) / 1.5,
}
NOISE = 0.007
"""Standard deviation in parts of the range."""


def times(rate: int) -> np.ndarray:
    return np.arange(6 * rate + 1) / rate


def noisy(value: np.ndarray, seed: int, share: float = NOISE) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.asarray(value + rng.normal(0.0, share * np.ptp(value), len(value)))


def swing(time: np.ndarray, value: np.ndarray, noise: float = 0.0) -> float:
    return shortest_swing(list(zip(time.tolist(), value.tolist(), strict=True)), noise)


def error(found: Followed, time: np.ndarray, value: np.ndarray) -> float:
    """Root mean square in parts of the range."""
    apart = np.interp(time, found.time, found.value) - value
    return float(np.sqrt(np.mean(apart**2)) / np.ptp(value))


@pytest.mark.parametrize("rate", [100, 1000])
@pytest.mark.parametrize("name", SLOW)
def test_noise_does_not_move_the_transient_time(name: str, rate: int) -> None:
    time = times(rate)
    clean = SLOW[name](time)
    for seed in range(3):
        found = followed(time, noisy(clean, seed), "auto", 0.005)
        assert found.noise == pytest.approx(NOISE * np.ptp(clean), rel=0.15)
        assert swing(found.time, found.value, found.noise) == pytest.approx(
            swing(time, clean), rel=0.05
        )
        assert error(found, time, clean) < (0.5 if rate == 100 else 0.25) * NOISE
        assert len(found.time) < 220


@pytest.mark.parametrize("rate", [100, 1000])
@pytest.mark.parametrize("name", FAST)
def test_edges_are_kept(name: str, rate: int) -> None:
    time = times(rate)
    clean = FAST[name](time)
    for seed in range(3):
        found = followed(time, noisy(clean, seed), "auto", 0.005)
        assert swing(found.time, found.value, found.noise) == pytest.approx(0.98 / rate, rel=0.05)
        assert error(found, time, clean) < 0.3 * NOISE
        assert len(found.time) < 40


@pytest.mark.parametrize("rows", [601, 6001])
def test_a_sine_of_ten_rows_a_period_is_not_smoothed_away(rows: int) -> None:
    time = np.arange(rows) / 100
    clean = SIZE * np.sin(2 * np.pi * np.arange(rows) / 10)
    assert white_noise(time, clean) == 0.0
    found = followed(time, noisy(clean, 0), "auto", 0.005)
    assert error(found, time, clean) < 1.2 * NOISE
    assert np.ptp(found.value) > 0.97 * np.ptp(clean)


CLEAN: dict[str, Signal] = {
    **SLOW,
    **FAST,
    "ramp": lambda t: 1e3 * t,
    "level": lambda t: 0 * t + 5.0,
    "rounded": lambda t: np.round(1e4 * np.sin(t), 1),
    "stairs": lambda t: 100 * np.round(t * 7),
    "chirp": lambda t: SIZE * np.sin(20 * t**2),
    "two rows a period": lambda t: SIZE * (-1.0) ** np.arange(len(t)),
    "three rows a period": lambda t: SIZE * np.sin(2 * np.pi / 3 * np.arange(len(t))),
    "random levels": lambda t: np.random.default_rng(3).choice([0.0, SIZE], len(t)),
    "random values": lambda t: np.random.default_rng(3).uniform(-SIZE, SIZE, len(t)),
    "pulses of one row": lambda t: SIZE * (np.arange(len(t)) % 50 == 7),
}


@pytest.mark.parametrize("name", CLEAN)
@pytest.mark.parametrize("rate", [10, 100, 1000])
def test_clean_tables_are_followed_row_by_row(name: str, rate: int) -> None:
    time = times(rate)
    value = np.asarray(CLEAN[name](time), dtype=float)
    for smooth in ("auto", "off"):
        found = followed(time, value, smooth, 0.005)
        assert found.time is time
        assert found.value is value


def test_rows_at_uneven_times_are_no_noise() -> None:
    rng = np.random.default_rng(0)
    time = np.sort(rng.uniform(0.0, 6.0, 601))
    clean = SLOW["two sines"](time)
    assert white_noise(time, clean) == 0.0
    found = followed(time, noisy(clean, 1), "auto", 0.005)
    assert error(found, time, clean) < 0.5 * NOISE


def test_jumps_of_a_table_are_kept_under_noise() -> None:
    time = np.concatenate([times(100)[:301], times(100)[300:]])
    clean = np.where(np.arange(602) < 301, 0.0, SIZE) + 100 * time
    found = followed(time, noisy(clean, 2), "auto", 0.005)
    at_jump = found.value[found.time == 3.0]
    assert np.diff(at_jump) == pytest.approx([SIZE], rel=0.01)


def test_nothing_that_is_taken_out_is_larger_than_told() -> None:
    time = times(100)
    value = noisy(SLOW["two sines"](time), 4)
    found = followed(time, value, "auto", 0.005)
    apart = np.abs(np.interp(time, found.time, found.value) - value)
    assert found.largest == pytest.approx(apart.max())
    assert found.largest < 5 * found.noise


@pytest.mark.parametrize("given", ["100 ms", "10 Hz", "0.01 kHz"])
def test_a_cut_off_passes_what_is_slower_and_stops_what_is_faster(given: str) -> None:
    time = np.arange(0, 6, 1e-3)
    for frequency in (1.0, 10.0, 40.0):
        sine = SIZE * np.sin(2 * math.pi * frequency * time)
        found = followed(time, sine, given, 1e-4)
        inner = (time > 1) & (time < 5)
        passed = np.interp(time, found.time, found.value)[inner]
        ratio = np.sqrt(np.mean(passed**2) / np.mean(sine[inner] ** 2))
        expected = 1 / (1 + (math.sqrt(2) - 1) * (frequency / 10) ** 4)
        assert ratio == pytest.approx(expected, abs=0.005)


def test_a_cut_off_beyond_the_table_leaves_a_level() -> None:
    time, value = below_cut_off(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 0.0]), 1e3)
    assert np.ptp(np.interp(np.linspace(0, 2, 9), time, value)) < 1e-3


def test_straight_pieces_stay_within_their_bound_and_keep_jumps() -> None:
    time = np.sort(np.random.default_rng(1).uniform(0, 6, 3000))
    time[1000] = time[1001]
    value = np.sin(3 * time) + (time > time[1000])
    for bound in (1e-1, 1e-2, 1e-4, 0.0):
        kept = straight_pieces(time, value, bound)
        assert np.abs(connected(time, value, kept) - value).max() <= bound + 1e-15
        assert {1000, 1001} <= set(kept.tolist())
    assert len(straight_pieces(time, value, 1e-2)) < 90


def test_long_clean_tables_are_followed_within_a_part_of_the_accuracy() -> None:
    time = np.arange(60_000) * 1e-4
    clean = SLOW["pulse"](time)
    found = followed(time, clean, "auto", 0.005)
    assert found.noise == 0.0
    assert found.largest <= 0.1 * 0.005 * np.ptp(clean)
    assert len(found.time) < 120
    wild = SIZE * np.sin(7e4 * time)
    for value, smooth, accuracy, words in (
        (clean, "off", 0.005, "off follows every row, 60000 of them; at most 50000"),
        (wild, "auto", 1e-5, "more than 50000 straight pieces are needed"),
    ):
        with pytest.raises(PydanticCustomError, match=words):
            followed(time, value, smooth, accuracy)


def written(value: np.ndarray, time: np.ndarray) -> str:
    return "t_s,p [Pa]\n" + "".join(f"{t:.3f},{p:.2f}\n" for t, p in zip(time, value, strict=True))


def test_a_noisy_file_gives_the_quadrant_of_the_clean_one_and_says_so(tmp_path: Path) -> None:
    time = times(100)
    value = noisy(SLOW["two sines"](time), 5)
    clean = table(tmp_path, written(SLOW["two sines"](time), time))
    found = table(tmp_path, written(value, time))
    assert found.transient(6.0) == pytest.approx(clean.transient(6.0), rel=0.05)
    every = table(tmp_path, written(value, time), smooth="off")
    assert len(every.rows or ()) == 601
    assert every.transient(6.0) == pytest.approx(clean.transient(6.0), rel=0.05)
    scene = load(tmp_path / "leg.yaml", ["input={kind: table, file: in.csv}"])
    (told,) = [fact for fact in check(scene).facts if "noise" in fact]
    assert "in.csv: 601 rows of t_s, p [Pa]; noise of " in told
    assert "smooth: off follows every row" in told
    other = tmp_path / "again.yaml"
    other.write_text(resolved_yaml(scene))
    assert load(other).model_dump() == scene.model_dump()
    assert told in check(load(other)).facts


def test_noise_adds_no_corners_and_moves_the_tip_by_a_part_of_the_accuracy(tmp_path: Path) -> None:
    time = times(100)[:201]
    clean = 8e3 * np.sin(4 * time) ** 2
    runs, corners = [], []
    for value, smooth in ((clean, "auto"), (noisy(clean, 6), "auto"), (noisy(clean, 6), "off")):
        (tmp_path / "in.csv").write_text(written(value, time))
        scene = leg(
            f"input={{kind: table, file: {tmp_path / 'in.csv'}, smooth: {smooth}}}",
            "bellows.count=4", "accuracy=0.5 %", "run={duration: 2 s, output_interval: 20 ms}",
            "effects={pressure_distribution: on, others: off}",
        )  # fmt: skip
        runs.append(simulate(scene, verify=False))
        corners.append(len(problem_of(scene).schedule.pieces.changes))
    exact, smooth, _ = runs
    # Each begins a step of its own.
    assert corners[1] < corners[0] == corners[2] == 199
    assert np.abs(smooth.tip - exact.tip)[:, :2].max() < exact.accuracy.requested_m
    assert len(smooth.notes) == 1
    assert smooth.summary()["notes"] == list(smooth.notes)
    assert not [notice for notice in smooth.warnings if "table" in notice.code]
