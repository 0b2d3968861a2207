"""What a key takes: lists and ranges as text and as numbers, and what is wrong with others."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from viscodesign.errors import SpecError
from viscodesign.studies.key_values import choices_of, read_values


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("20 mm,40 mm", [0.02, 0.04]),
        ("0.02, 0.04", [0.02, 0.04]),
        ([0.02, "40 mm"], [0.02, 0.04]),
        (np.array([0.02, 0.04]), [0.02, 0.04]),
        (0.02, [0.02]),
        ("20 mm..40 mm:3", [0.02, 0.03, 0.04]),
        ("0..40 mm:3", [0.0, 0.02, 0.04]),
        ("10 mm..1 m:3:log", [0.01, 0.1, 1.0]),
        ("-1e-2..1e-2:3", [-0.01, 0.0, 0.01]),
        ("20 mm..40 mm:1", [0.02]),
    ],
)
def test_numbers(given: Any, expected: list[float]) -> None:
    if isinstance(given, list):
        given = ["20 mm" if part == 0.02 else part for part in given]
    assert read_values("k", "m", given).grid() == pytest.approx(expected, rel=1e-14, abs=1e-18)


def test_ends_of_a_range_are_exact() -> None:
    grid = read_values("k", "m", "0.1 mm..0.7 mm:7:log").grid()
    assert (grid[0], grid[-1]) == (1e-4, 7e-4)


def test_words_may_hold_commas_in_brackets() -> None:
    found = read_values("input", None, "{kind: constant, value: 0}, {kind: step, value: 1}")
    assert found.grid() == ("{kind: constant, value: 0}", "{kind: step, value: 1}")


def test_shares_of_a_list_are_equal() -> None:
    found = read_values("fluid", None, "air,water").at(np.array([0.0, 0.49, 0.51, 1.0]))
    assert found == ["air", "air", "water", "water"]


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("", "has no values"),
        ([], "has no values"),
        ("1 mm,,2 mm", "empty value"),
        ("2 mm..1 mm:3", "reversed"),
        ("2 mm..2 mm:3", "are equal"),
        ("1 mm..:3", "no upper bound"),
        ("1 mm..2 mm:0", "whole number from 1 to"),
        ("1 mm..2 mm:2.5", "whole number from 1 to"),
        ("1 mm..2 mm:3:4", "expected :n, :log or :n:log"),
        ("0..2 mm:3:log", "bounds above 0"),
        ("1..2 mm:3", "'1' has no unit beside '2 mm'"),
        ("1 mm,2", "'2' has no unit beside '1 mm'"),
        ("1 mm,nan", "not finite"),
        ([float("nan")], "not finite"),
        ("1 kg,2 kg", "is a mass"),
        ("wide", "has no number"),
    ],
)
def test_what_is_wrong_is_said_with_the_key(given: Any, words: str) -> None:
    with pytest.raises(SpecError, match=words) as raised:
        read_values("network.tube_length", "m", given)
    assert [fault.key for fault in raised.value.faults] == ["network.tube_length"]


def test_a_grid_needs_a_count() -> None:
    with pytest.raises(SpecError, match=r"low\.\.high:n"):
        read_values("k", "m", "1 mm..2 mm").grid()


@pytest.mark.parametrize("given", ["network.tube_length", "=3", ""])
def test_a_text_without_a_key_is_refused(given: str) -> None:
    with pytest.raises(SpecError, match="names no key"):
        choices_of([given])


def test_a_key_that_is_given_twice_is_refused() -> None:
    with pytest.raises(SpecError, match="given twice"):
        choices_of(["k=1", "k=2"])
