"""A profile as poses and moves of the ArbotiX: the closest that its limits allow.

The tube around the profile is narrowed until no way through it is left with the moves there are;
what is stated as error is measured afterwards, by playing the poses through the engine's law.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.pumps.pose_engine import (
    EIGHTHS,
    FRAME,
    MOST_MOVES,
    MOST_POSES,
    PHANTOM,
    UNREAD,
    Move,
    PoseSequence,
    play,
    time_asking,
)
from viscodesign.pumps.pose_library import libraries, poses_of
from viscodesign.pumps.pose_search import FIRST_FRAMES, Pose, Search, Vertex
from viscodesign.pumps.pose_tube import HIGHEST_COUNT, Tube
from viscodesign.pumps.profile import Profile

FINEST = 0.5
"""Margin [counts] below which whole counts cannot follow any slope."""
RATIO = 1.04
"""Between the margins that are tried."""
_WIDEST = 196
"""Number of a margin that is wider than all counts."""


@dataclass(frozen=True)
class PoseFit:
    """What the board is to play, and how far that is from what was wanted."""

    sequence: PoseSequence
    looped: bool
    frames: int
    """From the start of the profile to its end, or of one round."""
    wanted_duration: float
    """[s]"""
    time: np.ndarray
    """(T,) instants at which either of both has a corner [s]."""
    wanted: np.ndarray
    """(T, P) counts; of a loop, at the pace that fills whole frames."""
    played: np.ndarray
    """(T, P) counts that the servos are sent, straight between frames."""

    @property
    def duration(self) -> float:
        """From the start of the profile to its end, or of one round [s]."""
        return self.frames * FRAME

    @property
    def error(self) -> np.ndarray:
        """(T, P) played less wanted [counts]."""
        return self.played - self.wanted

    @property
    def largest_error(self) -> float:
        """[counts]"""
        return float(np.max(np.abs(self.error)))


def fit_poses(
    profile: Profile, *, loop: bool = False, travel: tuple[int, int] = (0, HIGHEST_COUNT)
) -> PoseFit:
    """The closest that 30 poses and 46 moves come to a profile; all within travel [counts]."""
    return _Fitting(profile, loop, travel).best()


@dataclass(frozen=True)
class _Way:
    """Corners found, and the number of the margin they keep."""

    number: int
    vertices: list[Vertex]


_Finder = Callable[[int], list[Vertex] | None]
"""Corners within the margin of a number, if there is a way."""


class _Fitting:
    def __init__(self, profile: Profile, loop: bool, travel: tuple[int, int]) -> None:
        self.profile, self.loop, self.travel = profile, loop, travel
        exact = profile.duration / FRAME
        self.frames = max(round(exact) if loop else int(np.ceil(exact - 1e-9)), 2 * FIRST_FRAMES)
        self.pace = profile.duration / (self.frames * FRAME) if loop else 1.0
        instants = np.arange(self.frames + 1) * FRAME * self.pace
        self.wanted = np.stack([profile.at(float(instant)) for instant in instants])

    def best(self) -> PoseFit:
        few = self._narrowest(self._with_few_moves, -1, _WIDEST)
        ways = [few]
        many = self._narrowest(self._with_all_moves, -1, few.number, few)
        if len(poses_of(many.vertices)) > MOST_POSES:
            many = self._narrowest(self._with_shared_poses, many.number - 1, few.number, few)
        ways.append(many)
        return min((self._played(way) for way in ways), key=lambda fit: fit.largest_error)

    def _narrowest(
        self, find: _Finder, below: int, number: int, known: _Way | None = None
    ) -> _Way:
        """The narrowest margin with a way; ``below`` has none, ``number`` has the one known."""
        while number - below > 1 or known is None:
            middle = (below + number) // 2 if known else number
            vertices = find(middle)
            if vertices is not None:
                number, known = middle, _Way(middle, vertices)
            elif known is None:
                raise PumpError("no poses keep within the servo's travel; check home and travel")
            else:
                below = middle
        return known

    def _with_few_moves(self, number: int) -> list[Vertex] | None:
        """So few moves that each may have a pose of its own."""
        return self._search(number).vertices(MOST_POSES - 1)

    def _with_all_moves(self, number: int) -> list[Vertex] | None:
        return self._search(number).vertices(MOST_MOVES - 1)

    def _with_shared_poses(self, number: int) -> list[Vertex] | None:
        vertices = self._with_all_moves(number)
        if vertices is None or len(poses_of(vertices)) <= MOST_POSES:
            return vertices
        for poses in libraries(vertices, self._tubes(number)[0].grid):
            found = self._search(number, poses).vertices(MOST_MOVES - 1)
            if found is not None:
                return found
        return None

    def _search(self, number: int, poses: set[Pose] | None = None) -> Search:
        return Search(self._tubes(number), closed=self.loop, poses=poses)

    def _tubes(self, number: int) -> list[Tube]:
        margin = FINEST * RATIO**number
        return [
            Tube.around(column, margin, self.travel, closed=self.loop) for column in self.wanted.T
        ]

    def _played(self, way: _Way) -> PoseFit:
        sequence = sequence_of(way.vertices)
        start = (*way.vertices[0].goals, UNREAD)
        return measured(self.profile, sequence, start, loop=self.loop)


def sequence_of(vertices: Sequence[Vertex]) -> PoseSequence:
    """Poses and moves along corners; the first entry brings the phantom to its zero."""
    poses = poses_of(vertices)
    number = {pose: index for index, pose in enumerate(poses)}
    frames = [FIRST_FRAMES, *np.diff([vertex.frame for vertex in vertices]).tolist()]
    return PoseSequence(
        tuple((*goals, PHANTOM * phase) for goals, phase in poses),
        tuple(
            Move(number[vertex.goals, place % 2], time_asking(length))
            for place, (vertex, length) in enumerate(zip(vertices, frames, strict=True))
        ),
    )


def measured(
    profile: Profile, sequence: PoseSequence, start: Sequence[int], *, loop: bool
) -> PoseFit:
    """A sequence, played from a start [counts], against the profile it is for.

    The profile begins when the first entry is done; of a loop, the second round is measured.
    """
    first = PoseSequence(sequence.poses, sequence.moves[:1])
    begun = len(play(first, start))
    once = play(sequence, start)
    if loop:
        twice = play(PoseSequence(sequence.poses, sequence.moves * 2), start)
        # The entry that opens a round is the last piece of the one before.
        again = play(first, (once[-1] // EIGHTHS).tolist())
        rows = twice[begun - 1 : len(once) + len(again)]
    else:
        rows = once[begun - 1 :]
    counts = rows[:, :-1] // EIGHTHS
    return _compared(profile, sequence, counts, loop)


def _compared(
    profile: Profile, sequence: PoseSequence, counts: np.ndarray, loop: bool
) -> PoseFit:
    frames = len(counts) - 1
    instants = np.arange(frames + 1) * FRAME
    pace = profile.duration / (frames * FRAME) if loop else 1.0
    corners = profile.time / pace
    time = np.union1d(instants, corners[corners <= instants[-1]])
    return PoseFit(
        sequence=sequence,
        looped=loop,
        frames=frames,
        wanted_duration=profile.duration,
        time=time,
        wanted=np.stack([profile.at(float(moment * pace)) for moment in time]),
        played=np.stack([np.interp(time, instants, column) for column in counts.T], -1),
    )
