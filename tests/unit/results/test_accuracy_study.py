"""What points of error and time say: the front, the costs, the recommendation."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.studies import POINTS, made_study, point
from viscodesign.results.accuracy_points import (
    POINT_COLUMNS,
    spread,
    tolerance_words,
    with_dominated,
)

# Few values, so that equal times and equal errors are common.
PAIRS = st.lists(st.tuples(st.integers(1, 6), st.integers(1, 6)), max_size=25)


@given(PAIRS)
def test_a_point_is_dominated_where_another_is_no_worse_in_both(
    pairs: list[tuple[int, int]],
) -> None:
    found = with_dominated(point(1e-3 * time, 1e-4 * error) for time, error in pairs)
    assert [(p.solve_s, p.tip_error_rel) for p in found] == [
        (1e-3 * time, 1e-4 * error) for time, error in pairs
    ]
    for k, (time, error) in enumerate(pairs):
        beaten = any(
            (t <= time and e <= error) and ((t, e) != (time, error) or j < k)
            for j, (t, e) in enumerate(pairs)
            if j != k
        )
        assert found[k].dominated == beaten


@given(PAIRS.filter(bool))
def test_along_the_front_time_rises_and_error_falls(pairs: list[tuple[int, int]]) -> None:
    front = made_study(points=[point(1e-3 * t, 1e-4 * e) for t, e in pairs], start=None).front
    assert front
    times, errors = [p.solve_s for p in front], [p.tip_error_m for p in front]
    assert all(a < b for a, b in itertools.pairwise(times))
    assert all(a > b for a, b in itertools.pairwise(errors))


def test_the_cost_of_an_error_is_its_cheapest_setting() -> None:
    study = made_study()
    assert study.errors == (0.01, 0.005, 0.001, 0.0001)
    assert [p and p.solve_s for p in map(study.cheapest, study.errors)] == [
        0.012, 0.012, 0.020, 0.060
    ]  # fmt: skip
    assert study.cheapest(1e-5) is None
    assert study.recommended == study.points[2]


def test_within_a_budget_the_most_accurate_is_chosen() -> None:
    study = made_study()
    assert study.most_accurate(0.0005) is None
    assert study.most_accurate(0.02) == study.points[3]
    assert study.most_accurate(0.055) == study.points[3]
    assert study.most_accurate(100.0) == study.points[5]


def test_differences_from_the_selected_effects_are_stated_as_changes() -> None:
    assert made_study().recommended_changes == ()
    assert made_study(requested_rel=0.3).recommended_changes == (
        "effects.damping=off", "effects.inertia=off", "effects.pressure_distribution=off",
    )  # fmt: skip
    assert made_study(requested_rel=5e-5).recommended_changes == ("effects.feedback=on",)
    assert made_study(requested_rel=1e-9).recommended_changes == ()


def test_a_setting_in_words() -> None:
    study = made_study()
    assert study.words(study.points[0]) == "IV (uniform, quasi-static); no time steps, exact arcs"
    assert study.words(study.points[4]) == (
        "auto (distributed, inertial); idas, 2 edges per section, tolerance 1e-4"
    )


def test_the_frame_has_the_columns_of_the_file() -> None:
    frame = made_study().frame()
    assert tuple(frame.columns) == POINT_COLUMNS
    assert len(frame) == len(POINTS)
    assert frame["dominated"].tolist() == [False, False, False, False, True, False, True]


@pytest.mark.parametrize(
    ("tolerance", "words"), [(1e-2, "1e-2"), (3e-5, "3e-5"), (1.25e-4, "1.25e-4")]
)
def test_tolerances_are_written_in_short_form(tolerance: float, words: str) -> None:
    assert tolerance_words(tolerance) == words


def test_a_long_front_keeps_its_ends() -> None:
    front = [point(1e-3 * k, 1 / k) for k in range(1, 31)]
    told = spread(front, 9)
    assert len(told) == 9
    assert told[0] == front[0]
    assert told[-1] == front[-1]
    assert spread(front[:4], 9) == front[:4]
