"""Distances of motions, against exact ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from viscodesign.comparison.compare import compared
from viscodesign.comparison.differences import phase_difference, tip_difference_of
from viscodesign.comparison.interpolation import interpolation_error, merged_times, positions
from viscodesign.comparison.measured_motion import motion_of_rows
from viscodesign.errors import UsageError

from .motions import PERIOD, RADIUS, chord, circle

GRID = np.linspace(0.0, 4.0, 201)


def test_circles_are_a_chord_apart() -> None:
    found = tip_difference_of(circle("a", GRID), circle("b", GRID, late=0.1))
    np.testing.assert_allclose(found.distance, chord(0.1), rtol=1e-12)
    assert found.rms_m == pytest.approx(chord(0.1), rel=1e-12)
    assert found.interpolation_m == 0.0
    assert not found.is_part
    assert len(found.time) == 201


@pytest.mark.parametrize("rows", [50, 113, 500])
def test_other_times_are_interpolated_within_the_error_that_is_told(rows: int) -> None:
    found = tip_difference_of(circle("a", GRID), circle("b", np.linspace(0.0, 4.0, rows), late=0.1))
    error = np.abs(found.distance - chord(0.1)).max()
    assert 0 < error < found.interpolation_m < 0.05 * RADIUS


def test_the_error_told_holds_at_a_corner() -> None:
    fine = np.linspace(0.0, 1.0, 5001)
    for corner in (0.5, 0.503, 0.507, 0.51):
        time = np.linspace(0.0, 1.0, 101)
        tip, exact = (np.column_stack((abs(t - corner), t)) for t in (time, fine))
        error = np.hypot(*(positions(time, tip, fine) - exact).T).max()
        assert error <= interpolation_error(time, tip)


def test_the_part_of_time_that_both_have_is_compared_and_said() -> None:
    found = tip_difference_of(circle("a", GRID), circle("b", np.linspace(1.0, 6.0, 251), late=0.1))
    assert (found.time[0], found.time[-1]) == (1.0, 4.0)
    assert found.is_part
    assert "from 1 to 4 s, the part of time that both have" in found.sentence


def test_the_mean_is_over_time_not_over_rows() -> None:
    time = np.concatenate([np.linspace(0, 0.1, 1000, endpoint=False), np.linspace(0.1, 1, 1000)])
    still = motion_of_rows("still", np.column_stack((time, 0 * time, 0 * time)))
    ramp = motion_of_rows("ramp", np.column_stack((time, time, 0 * time)))
    assert tip_difference_of(still, ramp).rms_m == pytest.approx(1 / np.sqrt(3), rel=1e-5)


def test_times_that_differ_by_rounding_are_one() -> None:
    time = np.arange(11) * 0.1
    assert len(merged_times(time, np.linspace(0.0, 1.0, 11))) == 11


def test_no_common_time_is_refused_with_both_spans() -> None:
    with pytest.raises(UsageError, match="no time in common: b is from 5 to 9 s, a is from 0 to 4"):
        tip_difference_of(circle("a", GRID), circle("b", GRID + 5.0))


@pytest.mark.parametrize("late", [0.1, -0.437, 0.95])
def test_cycles_are_compared_at_the_same_phase(late: float) -> None:
    """Periods, starts and grids differ; the shift is that of the phase."""
    first = circle("a", GRID)
    slower = replace(
        circle("b", np.linspace(0, 8, 777), late),
        time=3 * np.linspace(0, 8, 777),
        period=3 * PERIOD,
    )
    found = phase_difference(first, slower)
    assert found is not None
    np.testing.assert_allclose(found.distance, abs(chord(late)), atol=2e-3 * RADIUS)
    assert found.shift_s == pytest.approx(late, abs=1e-4)
    assert found.shifted_rms_m < 1e-3 * RADIUS


@pytest.mark.parametrize("late", [0.137, -0.731, 0.0])
def test_a_late_clock_is_found(late: float) -> None:
    """A pulse that does not repeat, seen on other times by a clock that is late."""

    def pulse(time: np.ndarray) -> np.ndarray:
        return 0.03 * np.column_stack((np.exp(-((time - 2) ** 2)), np.tanh(time - 2.5)))

    there = np.linspace(0.5, 5.0, 223)
    tables = [
        motion_of_rows(name, np.column_stack((shown, pulse(time))))
        for name, shown, time in (("model", GRID, GRID), ("camera", there + late, there))
    ]
    found = tip_difference_of(*tables)
    assert found.shift is not None
    assert found.shift.shift_s == pytest.approx(late, abs=1e-3)
    assert found.shift.rms_m < 1e-5
    word = f"camera fits best {abs(late):.3g} s {'later' if late > 0 else 'earlier'}"
    assert (word in found.shift_sentence) == (late != 0.0)


@pytest.mark.parametrize(
    ("late", "words"),
    [
        (0.1, "b is 0.1 s late (5 % of the period), without that"),
        (-0.1, "b is 0.1 s early (5 % of the period)"),
        (1e-4, "neither is later by 0.1 % of the period"),
    ],
)
def test_a_delay_is_told_where_it_is_one(late: float, words: str) -> None:
    assert words in tip_difference_of(circle("a", GRID), circle("b", GRID, late)).phase_sentence


def test_without_a_whole_period_there_is_no_phase() -> None:
    assert phase_difference(circle("a", GRID), circle("b", GRID[:90])) is None
    assert phase_difference(circle("a", GRID), circle("b", GRID, period=None)) is None


@pytest.mark.parametrize(
    ("errors", "verdict", "words"),
    [
        ((1e-4, 2e-4), "differ", "of which 0.1 mm + 0.2 mm may be numerical"),
        ((4e-3, 4e-3), "within errors", "so no difference can be told"),
        ((1e-4, None), "unknown", "0.1 mm of it may be numerical; that of b is not known"),
        ((None, None), "unknown", "no errors are stated"),
    ],
)
def test_stated_errors_stand_beside_the_difference(
    errors: tuple[float | None, float | None], verdict: str, words: str
) -> None:
    pair = [circle(n, GRID, k * 0.1, e) for k, (n, e) in enumerate(zip("ab", errors, strict=True))]
    found = tip_difference_of(*pair)
    assert chord(0.1) == pytest.approx(6.26e-3, abs=1e-5)
    assert found.verdict == verdict
    assert words in found.sentence


def test_a_table_takes_the_period_of_a_run_if_it_is_long_enough() -> None:
    rows = np.column_stack((GRID, circle("", GRID, 0.1).tip))
    tables = [motion_of_rows("long", rows), motion_of_rows("short", rows[:60])]
    found = compared([circle("a", GRID), *tables])
    assert [m.period for m in found.motions] == [PERIOD, PERIOD, None]
    assert [d.phase is None for d in found.differences] == [False, True]
    assert found.notes[0] == "long is taken to have the period of a, 2 s"
    assert "short is shorter than a period" in found.notes[1]
    area = np.pi * RADIUS**2
    assert abs(found.motions[1].metrics["loop_area_m2"]) == pytest.approx(area, rel=1e-3)


def test_equal_labels_become_different() -> None:
    found = compared([circle("a", GRID), circle("a", GRID, source="x/a"), circle("a", GRID)])
    assert [m.label for m in found.motions] == ["a 1", "x/a", "a 2"]
