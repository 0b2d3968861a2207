"""Integrals of forces along sampled paths."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.postprocess.work_integrals import RULE, group_ends, path_integrals


def column(values: np.ndarray) -> np.ndarray:
    return values[:, None]


@pytest.mark.parametrize(
    ("last", "wanted"), [(1, [1]), (3, [3]), (4, [4]), (7, [7]), (8, [4, 8]), (11, [4, 11])]
)
def test_groups_cover_a_stretch(last: int, wanted: list[int]) -> None:
    assert group_ends(0, last, last).tolist() == wanted
    for stop in range(last + 1):
        early = [end for end in wanted if end <= stop]
        assert group_ends(0, last, stop).tolist() == early
        first = early[-1] if early else 0
        later = [end for end in wanted if end > first]
        assert group_ends(first, last, 99).tolist() == later


@pytest.mark.parametrize("size", range(1, RULE.group + 4))
def test_exact_for_polynomials_at_any_times(size: int) -> None:
    time = np.sort(np.random.default_rng(size).uniform(0, 2, size + 1))
    found, _ = path_integrals(time, column(time**size), column(3 * time), np.array([0, size]))
    exact = 3 * (time[-1] ** (size + 1) - time[0] ** (size + 1)) / (size + 1)
    assert found == pytest.approx([exact], rel=1e-9)


def test_columns_are_summed_along_the_path() -> None:
    time = np.linspace(0.0, 1.0, 33)
    force = np.column_stack((np.ones(33), time))
    path = np.column_stack((np.sin(time), time))
    found, _ = path_integrals(time, force, path, np.arange(0, 33, 4))
    exact = (np.sin(time) + time**2 / 2)[::4]
    assert np.cumsum(found) == pytest.approx(exact[1:], rel=1e-7)


@pytest.mark.parametrize("count", [9, 17, 33, 129])
def test_the_uncertainty_bounds_the_error(count: int) -> None:
    time = np.linspace(0.0, 2 * np.pi, count)
    cuts = np.arange(0, count, RULE.group)
    found, unsure = path_integrals(time, column(np.cos(time)), column(np.sin(time)), cuts)
    exact = (time / 2 + np.sin(2 * time) / 4)[cuts]
    assert np.all(np.abs(np.cumsum(found) - exact[1:]) <= np.cumsum(unsure))
    assert unsure.sum() <= 3 * (9 / count) ** 4


def test_a_constant_force_does_no_work_on_a_closed_path() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 65)
    cuts = np.arange(0, 65, RULE.group)
    found, unsure = path_integrals(angle, np.full((65, 1), 7.0), column(np.sin(angle)), cuts)
    assert found.sum() == pytest.approx(0.0, abs=1e-12)
    assert unsure.sum() <= 1e-12
