"""The timing law of the pose engine, frame by frame and in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pose_law import UNREAD, frames_in_16_bits, frames_of_moves, play_in_16_bits
from viscodesign.errors import PumpError
from viscodesign.pump.poses.engine import (
    EIGHTHS,
    EXACT_FRAMES,
    FRAME,
    LONGEST_MS,
    MAX_FRAMES,
    PHANTOM,
    Move,
    PoseSequence,
    frames_asked,
    frames_taken,
    play,
    time_asking,
)


def sequence(*moves: tuple[tuple[int, ...], int]) -> PoseSequence:
    """Goals and times [ms], each with a pose of its own."""
    poses = tuple(goals for goals, _ in moves)
    return PoseSequence(poses, tuple(Move(index, ms) for index, (_, ms) in enumerate(moves)))


def servos(number: int) -> st.SearchStrategy[tuple[int, ...]]:
    return st.tuples(*[st.integers(0, 1023)] * number)


@st.composite
def played(draw: st.DrawFn) -> tuple[PoseSequence, tuple[int, ...]]:
    number = draw(st.integers(1, 3))
    times = st.one_of(st.integers(0, 400), st.integers(0, LONGEST_MS))
    moves = draw(st.lists(st.tuples(servos(number), times), min_size=1, max_size=6))
    return sequence(*moves), draw(servos(number))


@given(played())
@settings(deadline=None)
def test_closed_form_and_frames_agree(case: tuple[PoseSequence, tuple[int, ...]]) -> None:
    program, start = case
    rows = play(program, start)
    assert np.array_equal(rows, play_in_16_bits(program, start))
    assert len(rows) == sum(frames_of_moves(program, start))
    ends = np.cumsum(frames_of_moves(program, start)) - 1
    assert rows[ends].tolist() == [[EIGHTHS * count for count in goal] for goal in program.goals()]


@given(servos(2), servos(2), st.integers(0, LONGEST_MS))
@settings(deadline=None)
def test_each_servo_goes_straight_and_waits_for_the_slowest(
    start: tuple[int, ...], goal: tuple[int, ...], ms: int
) -> None:
    rows = play(sequence((goal, ms)), start)
    for column, a, b in zip(rows.T, start, goal, strict=True):
        distance = EIGHTHS * abs(b - a)
        step = distance // frames_asked(ms) + 1
        gone = np.minimum(step * np.arange(1, len(rows) + 1), distance)
        assert column.tolist() == (EIGHTHS * a + np.sign(b - a) * gone).tolist()


@given(st.integers(0, EIGHTHS * 1023), st.integers(1, MAX_FRAMES))
def test_no_servo_takes_longer_than_asked(distance: int, frames: int) -> None:
    assert 1 <= frames_taken(distance, frames) <= frames


@given(st.integers(1, MAX_FRAMES))
def test_a_time_asks_for_its_frames(frames: int) -> None:
    assert frames_asked(time_asking(frames)) == frames
    assert frames_in_16_bits(time_asking(frames)) == frames


# Measured on the original firmware's image in an AVR emulator: 2.7 s and one frame.
def test_ten_counts_in_five_seconds_take_less_than_three_seconds() -> None:
    rows = play(sequence(((310,), 5000)), (300,))
    assert len(rows) * FRAME == pytest.approx(2.7, abs=0.05)
    assert np.diff(rows[:, 0]).max() == 1


def test_a_wait_lasts_one_frame() -> None:
    assert len(play(sequence(((300,), 5000)), (300,))) == 1


@pytest.mark.parametrize("frames", [1, 2, 30, 50, 91, 889])
def test_a_wait_with_the_phantom_lasts_what_was_asked(frames: int) -> None:
    program = sequence(((300, PHANTOM), time_asking(frames)))
    assert len(play(program, (300, 0))) == frames


def test_the_slowest_ramp_is_an_eighth_of_a_count_a_frame() -> None:
    rows = play(sequence(((200, PHANTOM), time_asking(MAX_FRAMES))), (100, 0))
    assert np.unique(np.diff(rows[:800, 0])).tolist() == [1]
    assert pytest.approx(3.8, abs=0.02) == 1 / EIGHTHS / FRAME  # counts per second


def test_the_phantom_times_all_short_waits_and_few_long_ones() -> None:
    distance = EIGHTHS * PHANTOM
    # 8000 // s + 1 frames at s eighths a frame: all of them that there are, and no others.
    reached = {distance // step + 1 for step in range(1, distance + 2)}
    assert set(EXACT_FRAMES) == {frames for frames in reached if frames <= MAX_FRAMES}
    assert EXACT_FRAMES[:92] == tuple(range(1, 93))
    assert 93 not in EXACT_FRAMES
    long = np.array(EXACT_FRAMES[91:])
    assert max(np.diff(long) / long[:-1]) < 0.12


def test_a_move_whose_time_overflows_sixteen_bits_runs_at_the_slowest_speed() -> None:
    rows = play_in_16_bits(sequence(((110,), LONGEST_MS + 1)), (100,))
    assert len(rows) == EIGHTHS * 10 + 1


@pytest.mark.parametrize("frames", [0, MAX_FRAMES + 1])
def test_times_that_the_board_does_not_take_are_refused(frames: int) -> None:
    with pytest.raises(PumpError, match="the firmware takes 1 to 993"):
        time_asking(frames)


@pytest.mark.parametrize("frames", [2, 3, 30, MAX_FRAMES])
def test_a_phantom_that_was_never_read_is_there_in_one_frame(frames: int) -> None:
    assert len(play_in_16_bits(sequence(((300, 0), time_asking(frames))), (300, UNREAD))) == 1


def test_a_first_entry_of_one_frame_would_wander_for_minutes() -> None:
    """Its step overflows to -7: away from the goal, until the difference overflows too."""
    rows = play_in_16_bits(sequence(((300, 0), time_asking(1))), (300, UNREAD))
    assert len(rows) * FRAME > 150


def test_a_move_without_a_step_is_told_to_be_endless() -> None:
    with pytest.raises(PumpError, match="move 1 of the sequence would never end"):
        play_in_16_bits(sequence(((300,), 2**16 - 40)), (200,))


def test_a_servo_that_was_never_read_jumps_to_its_goal() -> None:
    assert play_in_16_bits(sequence(((300,), time_asking(2))), (UNREAD,)).tolist() == [[2400]]
