"""Inputs that would move, but not within the run, are told."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign import check

SHORT = "run={duration: 8 s, output_interval: 0.1 s}"
RESTING = (
    "input={kind: step, value: 10 kPa, time: 20 s}",
    "input={kind: double_sigmoid, start: 0 kPa, drop: 20 kPa, fall_time: 500 s, rise_time: 600 s, "
    "transition: 1 s}",
)
MOVING = (
    "input={kind: step, value: 10 kPa, time: 7.9 s}",
    "input={kind: constant, value: 10 kPa}",
    "input={kind: sine, amplitude: 10 kPa, frequency: 0.5 mHz}",
)


def codes(words: str) -> set[str]:
    return {notice.code for notice in check(leg(words, SHORT, config="leg_4_air")).warnings}


@pytest.mark.parametrize("words", RESTING)
def test_an_input_that_moves_later_is_told(words: str) -> None:
    assert "input_rests" in codes(words)


@pytest.mark.parametrize("words", MOVING)
def test_others_are_not(words: str) -> None:
    assert "input_rests" not in codes(words)
