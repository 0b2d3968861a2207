"""The closest that poses come to a profile, and that the stated error is the played one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pose_law import UNREAD, play_in_16_bits
from viscodesign.errors import PumpError
from viscodesign.pump.poses.engine import (
    EIGHTHS,
    FRAME,
    MAX_MOVES,
    MAX_POSES,
    PHANTOM,
    Move,
    PoseSequence,
    frames_taken,
    play,
)
from viscodesign.pump.poses.fit import FIT, PoseFit, fit_poses
from viscodesign.pump.profile import Profile


def profile(time: np.ndarray, *columns: np.ndarray) -> Profile:
    counts = np.stack(columns, -1)
    number = counts.shape[1]
    names = tuple("abc"[:number])
    return Profile(names, tuple(range(1, number + 1)), time, counts, 0.0 * counts)


def sine(duration: float, amplitude: float, cycles: float = 1.0, shift: float = 0.0) -> Profile:
    time = np.linspace(0.0, duration, int(50 * duration) + 1)
    angle = 2 * np.pi * (cycles * time / duration + shift)
    return profile(time, 500.0 + amplitude * np.sin(angle))


def pulse() -> Profile:
    """The paper's pulse: down within 0.875 s about 0.5 s, up again about 4 s."""
    time = np.linspace(0.0, 8.0, 401)

    def sigmoid(moment: float) -> np.ndarray:
        return 1 / (1 + np.exp(-10 * (time - moment) / 0.875))

    return profile(time, 700.0 - 300.0 * (sigmoid(1.0) - sigmoid(4.5)))


def trapezoid(duration: float = 6.0) -> Profile:
    corners = np.array([0.0, 1.0, 3.0, 4.0, 6.0]) * duration / 6
    return profile(corners, np.array([300.0, 700.0, 700.0, 300.0, 300.0]))


def played_error(wanted: Profile, fit: PoseFit) -> float:
    """Largest error, by another way: seen at a fine grid of times, and at all corners."""
    start = (*fit.sequence.goals()[0][:-1], UNREAD)
    moves = fit.sequence.moves * (2 if fit.looped else 1)
    rows = play_in_16_bits(PoseSequence(fit.sequence.poses, moves), start)
    # Of a loop the last round: its last frame is that of its opening entry.
    counts = rows[:, :-1] // EIGHTHS
    counts = counts[-fit.frames - 1 :] if not fit.looped else _one_round(counts, fit)
    instants = FRAME * np.arange(fit.frames + 1)
    pace = wanted.duration / fit.duration if fit.looped else 1.0
    corners = wanted.time / pace
    fine = np.linspace(0.0, fit.duration, 40 * fit.frames + 1)
    fine = np.union1d(fine, corners[corners <= fit.duration])
    return max(
        float(np.abs(np.interp(fine, instants, c) - np.interp(pace * fine, wanted.time, w)).max())
        for c, w in zip(counts.T, wanted.steps.T, strict=True)
    )


def _one_round(counts: np.ndarray, fit: PoseFit) -> np.ndarray:
    """From the end of one opening entry to the end of the next."""
    first = len(counts) - 2 * fit.frames
    begun = [k for k in (1, 2) if 0 <= k - first <= 2]
    return counts[begun[0] - 1 :][: fit.frames + 1]


def check(wanted: Profile, fit: PoseFit) -> None:
    """What holds for every fit."""
    sequence = fit.sequence
    assert len(sequence.poses) <= MAX_POSES
    assert len(sequence.moves) <= MAX_MOVES
    assert {pose[-1] for pose in sequence.poses} <= {0, PHANTOM}
    assert all(0 <= move.ms <= 32767 for move in sequence.moves)
    assert [goal[-1] for goal in sequence.goals()] == [
        PHANTOM * (k % 2) for k in range(len(sequence.moves))
    ]
    # Every move but the first lasts exactly what was asked: nothing drifts.
    asked = fit.move_frames[1:]
    assert [frames_taken(EIGHTHS * PHANTOM, frames) for frames in asked] == asked
    assert np.all(np.isfinite(fit.error))
    assert fit.largest_error == np.abs(fit.error).max()


@pytest.mark.parametrize("loop", [False, True])
@pytest.mark.parametrize(
    ("wanted", "most"),
    [
        (sine(4.0, 200.0), 1.3),
        (sine(20.0, 5.0), 0.6),
        (trapezoid(), 2.1),
        (trapezoid(5.94), 0.9),  # corners on frames
        (pulse(), 1.6),
    ],
)
def test_common_profiles_are_played_closely(wanted: Profile, most: float, loop: bool) -> None:
    fit = fit_poses(wanted, loop=loop)
    check(wanted, fit)
    assert fit.largest_error <= most
    assert fit.duration == pytest.approx(wanted.duration, abs=FRAME)


def test_two_servos_share_their_moves() -> None:
    one, two = sine(3.0, 150.0), sine(3.0, 80.0, shift=0.2)
    wanted = profile(one.time, one.steps[:, 0], two.steps[:, 0])
    fit = fit_poses(wanted, loop=True)
    check(wanted, fit)
    assert fit.largest_error < 1.2
    assert fit.sequence.goals()[0][2] == 0


@given(
    st.lists(st.floats(100.0, 900.0), min_size=3, max_size=6),
    st.floats(0.7, 3.0),
    st.booleans(),
)
@settings(max_examples=15, deadline=None)
def test_the_stated_error_is_the_played_one(
    levels: list[float], duration: float, loop: bool
) -> None:
    corners = np.linspace(0.0, duration, len(levels) + 1)
    wanted = profile(corners, np.array([*levels, levels[0]]))
    fit = fit_poses(wanted, loop=loop)
    check(wanted, fit)
    assert played_error(wanted, fit) == pytest.approx(fit.largest_error, abs=1e-6)


def test_a_profile_that_the_law_plays_exactly_is_found() -> None:
    """Ramps of whole eighths a frame between whole counts, and a wait that the phantom holds."""
    time = FRAME * np.array([0.0, 40.0, 90.0, 130.0])
    wanted = profile(time, np.array([200.0, 300.0, 300.0, 200.0]))
    fit = fit_poses(wanted)
    # Counts are rounded down on the way: nearly a whole one, were they not shifted.
    assert fit.largest_error <= FIT.finest * 1.05
    assert len(fit.sequence.moves) < 8


def brute_force(wanted: np.ndarray, moves: int, levels: range) -> float:
    """Smallest error at the frames of all ways with so many moves, by trying each."""
    last = len(wanted) - 1

    def least(frame: int, count: int, left: int) -> float:
        if frame == last:
            return 0.0
        if left == 0:
            return np.inf
        best = np.inf
        for length in range(1, last - frame + 1):
            for goal in levels:
                pose = PoseSequence(((goal, PHANTOM),), (Move(0, 33 * length - 1),))
                rows = play(pose, (count, 0))[:, 0] // EIGHTHS
                here = np.abs(rows - wanted[frame + 1 : frame + 1 + length]).max()
                if here < best:
                    best = min(best, max(here, least(frame + length, goal, left - 1)))
        return best

    return min(max(abs(start - wanted[0]), least(0, start, moves)) for start in levels)


@pytest.mark.parametrize("shape", [(0, 1.2, 3.7, 4.4, 4.0), (2.0, 0.0, 0.4, 3.0, 2.0)])
def test_the_search_agrees_with_brute_force(shape: tuple[float, ...]) -> None:
    from viscodesign.pump.poses.search import MoveSearch, ToleranceBand

    wanted = 100.0 + np.array(shape)
    for moves in (1, 2):
        best = brute_force(wanted, moves, range(98, 107))
        for margin, found in ((best, True), (best - 1e-3, False)):
            band = ToleranceBand.around(wanted, wanted, margin, (98, 106), closed=False)
            assert (MoveSearch([band], closed=False).path(moves) is not None) is found


def test_a_profile_beyond_the_engine_states_its_error() -> None:
    fit = fit_poses(sine(8.0, 200.0, cycles=8))
    check(sine(8.0, 200.0, cycles=8), fit)
    assert fit.largest_error > 5.0


def test_goals_stay_within_travel() -> None:
    time = np.linspace(0.0, 2.0, 101)
    wanted = profile(time, 500.0 + 100.0 * np.abs(np.sin(np.pi * time)))
    fit = fit_poses(wanted, travel=(500, 600))
    counts = [goal[0] for goal in fit.sequence.goals()]
    assert min(counts) >= 500
    assert max(counts) <= 600


def test_a_very_long_profile_is_refused_before_the_search() -> None:
    time = np.array([0.0, 400.0])
    with pytest.raises(PumpError, match="Loop one cycle of it"):
        fit_poses(profile(time, np.array([100.0, 900.0])))


def test_a_profile_beyond_all_counts_is_refused() -> None:
    time = np.array([0.0, 1.0, 2.0])
    with pytest.raises(PumpError, match="keep within the servo's travel"):
        fit_poses(profile(time, np.array([100.0, 2500.0, 100.0])), travel=(0, 1023))
